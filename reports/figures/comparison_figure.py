"""The picture of several searches in the same axes: what each found, and how fast."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.planner import History
from reports.figures.fitted import shortened
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.plan_map import colours_of
from reports.figures.plan_search import draw_search
from reports.figures.style import WIDTH, new_figure

_TOP, _LABELS, _BOTTOM = 0.56, 0.44, 0.06  # [in]
_NAMES = 90  # characters of all names together
_HEIGHT = 3.4  # [in] of both panels together


def comparison_figure(histories: Mapping[str, History], exact: float | None = None) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    colours = colours_of(histories)
    figure = new_figure(_TOP + _HEIGHT + _LABELS + _BOTTOM)
    figure.legend(
        handles=[Line2D([], [], color=colours[name], linewidth=1.8, label=shortened(name, _NAMES // len(histories)))
            for name in histories
        ],
        loc="upper left", bbox_to_anchor=(LEFT / WIDTH, 1.0 - 0.1 / figure.get_size_inches()[1]), ncols=len(histories),
        fontsize=8.5, borderaxespad=0.0, borderpad=0.0, handlelength=1.4, columnspacing=1.6,
    )  # fmt: skip
    draw_search(figure, Box(LEFT, _TOP, WIDTH - LEFT - RIGHT, _HEIGHT), histories, colours, exact)
    return figure
