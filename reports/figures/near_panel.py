"""The one point that a figure marks, from near."""

from __future__ import annotations

from typing import TYPE_CHECKING

from reports.figures.body import draw_body
from reports.figures.extent import Extent
from reports.figures.fitted import fit
from reports.figures.focus import Focus
from reports.figures.map_panel import draw_map
from reports.figures.ticks import ticks_from
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LABEL, _SMALLEST_LABEL = 8.0, 7.0  # [pt]
_OVERHANG = 0.6  # [in] that a label may be wider than the box, into the gap beside it
_LABEL_PAD, _TITLE_PAD = 4.5, 16.0  # [pt] above the box


def draw_near(axes: Axes, outcome: Outcome, marked: Focus, near: Extent) -> None:
    """Draw the surroundings of `marked` on `axes`, in metres from it."""
    draw_map(axes, outcome, near, marked)
    draw_body(axes, outcome, marked.index)
    axes.set_title(marked.title, pad=_TITLE_PAD)
    label = axes.annotate(
        marked.label, (0.0, 1.0), xycoords="axes fraction", xytext=(0.0, _LABEL_PAD), textcoords="offset points",
        fontsize=_LABEL, va="bottom", annotation_clip=False,
    )  # fmt: skip
    room = min(axes.bbox.width + _OVERHANG * axes.figure.dpi, axes.figure.bbox.width - axes.bbox.x0)
    fit(label, room, _SMALLEST_LABEL)
    ticks_from(axes, marked.x, marked.y)
