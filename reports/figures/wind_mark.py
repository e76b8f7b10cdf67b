"""The wind on a map: an arrow in the corner where it hides least."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import FancyArrowPatch

from planners.kernel import Floats
from reports.figures.extent import Extent, flown
from reports.figures.style import INK, PAPER, Look
from reports.words.quantity import text
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_AT_ENDS = 200
_ARROW, _WIDTH, _HEIGHT = 26.0, 52.0, 48.0  # [pt] the arrow's length, and the mark's whole box


def draw_wind(axes: Axes, outcome: Outcome, view: Extent) -> None:
    """Draw where the wind blows to, north being up, with its speed under the arrow."""
    point = axes.figure.dpi / 72.0
    width, height = _WIDTH * point / axes.bbox.width, _HEIGHT * point / axes.bbox.height
    left, low = _emptiest(outcome, view, width, height)
    wind = outcome.conditions.wind
    reach = 0.5 * _ARROW * point * np.array([wind.east, wind.north]) / wind.speed
    middle = axes.transAxes.transform((left + width / 2, low + 0.62 * height))
    tail, head = (tuple(axes.transAxes.inverted().transform(middle + sign * reach)) for sign in (-1.0, 1.0))
    look: Look = {"facecolor": INK, "edgecolor": PAPER, "linewidth": 0.8, "zorder": 9, "shrinkA": 0, "shrinkB": 0}
    shape = "simple,head_length=7,head_width=7,tail_width=2.2"
    axes.add_patch(FancyArrowPatch(tail, head, transform=axes.transAxes, arrowstyle=shape, **look))
    axes.text(
        left + width / 2, low + 0.05 * height, f"wind {text(wind.speed, 'm/s')}", transform=axes.transAxes,
        ha="center", va="bottom", fontsize=7.0, zorder=9,
        bbox={"boxstyle": "round,pad=0.15", "facecolor": PAPER, "edgecolor": "none", "alpha": 0.85},
    )  # fmt: skip


def same_wind(outcomes: Sequence[Outcome]) -> bool:
    """Whether one and the same wind blows in all of `outcomes`."""
    winds = {(one.conditions.wind.east, one.conditions.wind.north) for one in outcomes}
    return len(winds) == 1 and outcomes[0].conditions.wind.speed > 0.0


def _emptiest(outcome: Outcome, view: Extent, width: float, height: float) -> tuple[float, float]:
    """The lower left, in shares of the axes, of the corner that holds the least of paths and tracks."""
    runs = outcome.fleet.members if outcome.fleet else (outcome,)
    xy = np.concatenate([part for run in runs for part in (_spaced(run), flown(run))])
    xy = (xy - [view.x_min, view.y_min]) / [view.width, view.height]
    corners = [(1 - width, 1 - height), (0.0, 1 - height), (1 - width, 0.0), (0.0, 0.0)]

    def crowd(corner: tuple[float, float]) -> int:
        return int(np.sum(((xy >= corner) & (xy <= np.add(corner, (width, height)))).all(axis=1)))

    return min(corners, key=crowd)


def _spaced(run: Outcome) -> Floats:
    """Points (N, 2) [m] along the path, more of them at its ends, where its marks are."""
    xy = run.path.resample(max(run.path.length / 2000, 1e-3)).xy
    return np.concatenate([xy, np.repeat(xy[[0, -1]], _AT_ENDS, axis=0)])
