"""The picture of a colony: the ways of all ants in some iterations, those that arrived and those that died."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.kernel import Floats
from planners.planner import History, Swarm
from planners.scenario import Scenario
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.plan_map import draw_ground, ground_entries, label_ground, whole_map
from reports.figures.style import BLUE, INK, VERMILION, WIDTH, Look, new_figure, place
from reports.words.quantity import text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TOP, _BETWEEN, _LABELS, _KEY, _BOTTOM = 0.28, 0.36, 0.44, 0.22, 0.06  # [in]
_GAP = 0.2  # [in] between maps side by side
_COLUMNS, _SHOWN = 2, 4
_LOWEST, _HIGHEST = 1.2, 3.6  # [in] of a map
_FAINTEST, _INKED = 0.1, 25.0  # so many ways drawn over each other are opaque; how faint a way may be
_ALIVE: Look = {"color": BLUE, "linewidth": 0.6, "label": "arrived"}
_DEAD: Look = {"color": VERMILION, "linewidth": 0.6, "label": "died"}
_BEST: Look = {"color": INK, "linewidth": 1.3, "label": "best of the iteration"}


def colony_figure(scenario: Scenario, history: History, iterations: Sequence[int] | None = None) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    shown, view = shown_iterations(len(history.swarms), iterations), whole_map(scenario)
    columns = min(_COLUMNS, len(shown))
    rows = -(-len(shown) // columns)
    width = (WIDTH - LEFT - RIGHT - (columns - 1) * _GAP) / columns
    height = min(_HIGHEST, max(_LOWEST, width * view.height / view.width))
    view = view.filled(width / height)
    end = _TOP + rows * height + (rows - 1) * _BETWEEN + _LABELS
    figure = new_figure(end + _KEY + _BOTTOM)
    for i, iteration in enumerate(shown):
        row, column = divmod(i, columns)
        box = Box(LEFT + column * (width + _GAP), _TOP + row * (height + _BETWEEN), width, height)
        axes = place(figure, box.left, box.top, box.width, box.height)
        draw_ground(axes, scenario, view)
        label_ground(axes, box, view, east=i + columns >= len(shown), north=column == 0)
        _draw_swarm(axes, history.swarms[iteration - 1])
        _draw_title(axes, history, iteration)
    entries = [
        *ground_entries(scenario),
        *(Line2D([], [], **{**look, "linewidth": 1.3}) for look in (_ALIVE, _DEAD, _BEST)),
    ]
    figure.legend(
        handles=entries, loc="upper left", ncols=len(entries), borderaxespad=0.0, columnspacing=1.6, handletextpad=0.6,
        bbox_to_anchor=(LEFT / WIDTH, 1.0 - end / figure.get_size_inches()[1]),
    )  # fmt: skip
    return figure


def shown_iterations(count: int, wanted: Sequence[int] | None = None) -> tuple[int, ...]:
    """Which of `count` iterations, from 1, are shown, in order; raises `ValueError` where there are none."""
    if count == 0:
        raise ValueError("a history without swarms has nothing to show")
    asked = np.geomspace(1.0, count, _SHOWN) if wanted is None else np.clip(wanted, 1, count)
    return tuple(sorted({round(float(iteration)) for iteration in asked}))


def _draw_swarm(axes: Axes, swarm: Swarm) -> None:
    """The dead below the living, each the fainter the more there are; the shortest way that arrived on top."""
    ways = np.split(swarm.points, swarm.first[1:-1])
    faint = min(0.6, max(_FAINTEST, _INKED / max(1, len(ways))))
    for look, alive, order in ((_DEAD, False, 3.0), (_ALIVE, True, 3.1)):
        chosen = [way for way, lives in zip(ways, swarm.alive, strict=True) if lives == alive]
        axes.add_collection(
            LineCollection(
                chosen, colors=look["color"], linewidths=look["linewidth"], alpha=faint, rasterized=True, zorder=order
            ),
            autolim=False,
        )
    arrived = [way for way, lives in zip(ways, swarm.alive, strict=True) if lives]
    if arrived:
        axes.plot(*min(arrived, key=_length).T, zorder=4, **_BEST)


def _draw_title(axes: Axes, history: History, iteration: int) -> None:
    best, mean = float(history.best[iteration - 1]), float(history.mean[iteration - 1])
    axes.set_title(f"iteration {iteration}", pad=5.0)
    told = f"{history.survivors[iteration - 1]} of {history.population} arrive"
    if np.isfinite(best):
        told += f", best {text(best, 'm')}, mean {text(mean, 'm')}"
    axes.set_title(told, loc="right", fontsize=8.0, fontweight="normal", pad=5.0)


def _length(way: Floats) -> float:
    return float(np.hypot(*np.diff(way, axis=0).T).sum())
