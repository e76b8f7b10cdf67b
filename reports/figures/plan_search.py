"""How searches went on: length of the ways that arrived, and how many did, by iteration."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from planners.kernel import Floats
from planners.planner import History
from reports.figures.layout import Box
from reports.figures.style import DASHES, INK, MUTED, Look, place
from reports.figures.ticks import HIGH, length_unit, ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SURVIVORS = 0.22  # of the height, for the lower panel
_WIDTH, _MANY = 1.3, 60  # [pt] of lines; iterations from which on they have no dots
_BETWEEN = 0.34  # [in] for the title of the lower panel


def draw_search(
    figure: Figure, room: Box, histories: Mapping[str, History], colours: Mapping[str, str], exact: float | None
) -> None:
    """Draw both panels within `room`; `exact` [m] is the length of the exact shortest path, None for none."""
    lower = _SURVIVORS * room.height
    lengths = place(figure, room.left, room.top, room.width, room.height - lower - _BETWEEN)
    survivors = place(figure, room.left, room.bottom - lower, room.width, lower)
    last = max(len(history.best) for history in histories.values())
    for axes in (lengths, survivors):
        axes.set_xlim(0.5, last + 0.5)
        axes.xaxis.set_major_locator(MaxNLocator(nbins=8, integer=True, min_n_ticks=1))
    _draw_lengths(lengths, histories, colours, exact)
    _draw_survivors(survivors, histories, colours)
    ticks(survivors.yaxis, 2)
    lengths.tick_params(labelbottom=False)
    survivors.set_xlabel("iteration")


def _draw_lengths(
    axes: Axes, histories: Mapping[str, History], colours: Mapping[str, str], exact: float | None
) -> None:
    looks: list[Look] = [
        {"label": "best", "color": MUTED, "linewidth": _WIDTH},
        {"label": "mean", "color": MUTED, "linewidth": _WIDTH, "linestyle": DASHES},
    ]
    for name, history in histories.items():
        _plot(axes, history.best, colours[name])
        _plot(axes, history.mean, colours[name], DASHES)
    longest = max((float(np.nanmax(one.mean)) for one in histories.values() if one.converged), default=0.0)
    scale, unit = length_unit(longest)
    axes.set_title(f"Length by iteration [{unit}]" if longest else "Length by iteration")
    if not longest:
        axes.set_yticks([])
        axes.text(0.5, 0.5, "nothing arrived", transform=axes.transAxes, ha="center", va="center", color=MUTED)
        return
    if exact is not None:
        axes.axhline(exact, color=INK, linewidth=0.7, zorder=2)
        looks.append({"label": "exact shortest", "color": INK, "linewidth": 0.7})
    ticks(axes.yaxis, axes.bbox.height / axes.figure.dpi / HIGH, scale)
    axes.legend(
        handles=[Line2D([], [], **look) for look in looks],
        loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, borderaxespad=0.15, handlelength=1.4,
        columnspacing=0.7, handletextpad=0.5,
    )  # fmt: skip


def _draw_survivors(axes: Axes, histories: Mapping[str, History], colours: Mapping[str, str]) -> None:
    for name, history in histories.items():
        _plot(axes, 100.0 * history.survivors / max(1, history.population), colours[name])
    axes.set_ylim(-8.0, 108.0)
    axes.set_title("Arrived [%]")


def _plot(axes: Axes, values: Floats, colour: str, line: Any = "-") -> None:
    """A line by iteration, with dots while they are few: a value between two that are missing has no line."""
    dots = "o" if len(values) < _MANY else ""
    steps = np.arange(1, len(values) + 1)
    axes.plot(steps, values, color=colour, linewidth=_WIDTH, linestyle=line, marker=dots, markersize=2.6, zorder=3)
