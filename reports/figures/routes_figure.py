"""The picture of routes side by side, after paper 004's Figs. 9 to 11: a row of small maps for each planner."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import dist
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.planner import Plan
from planners.scenario import Scenario
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.needed_panel import WITHIN, draw_beyond, entries_up_to, ring_worst, worst_place
from reports.figures.plan_map import draw_ground, ground_entries, label_ground, whole_map
from reports.figures.plan_turn import came, came_entries, draw_came, draw_lines
from reports.figures.style import DASHES, WIDTH, new_figure, place
from reports.words.quantity import number, text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COLUMNS, ROWS = 3, 3  # of maps at most
_TITLE, _LABELS, _KEY, _LINE, _BOTTOM, _GAP = 0.46, 0.40, 0.10, 0.19, 0.06, 0.30  # [in]
_LOWEST, _HIGHEST = 1.0, 2.6  # [in] of a map


@dataclass(frozen=True, slots=True, eq=False)
class Route:
    """A `plan`, what it is called, and the `speed` [m/s] at which it is driven."""

    name: str
    plan: Plan
    speed: float


def routes_figure(scenario: Scenario, rows: Sequence[Sequence[Route]]) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`: of `ROWS` rows the first `COLUMNS` each, all
    maps at one scale.
    """
    shown = [row[:COLUMNS] for row in rows[:ROWS]]
    view = whole_map(scenario)
    columns = max(2, *(len(row) for row in shown))
    width = (WIDTH - LEFT - RIGHT - (columns - 1) * _GAP) / columns
    height = min(_HIGHEST, max(_LOWEST, width * view.height / view.width))
    view = view.filled(width / height)
    below = len(shown) * (_TITLE + height) + _LABELS
    figure = new_figure(below + _KEY + 2 * _LINE + _BOTTOM)
    for row, routes in enumerate(shown):
        lowest = max((len(later) for later in shown[row + 1 :]), default=0)  # columns with a map below
        for column, route in enumerate(routes):
            box = Box(LEFT + column * (width + _GAP), _TITLE + row * (_TITLE + height), width, height)
            axes = place(figure, box.left, box.top, box.width, box.height)
            draw_ground(axes, scenario, view)
            label_ground(axes, box, view, east=column >= lowest, north=column == 0)
            _draw(axes, scenario, route)
    routes = [route for row in shown for route in row]
    for i, entries in enumerate(_key(scenario, routes)):
        figure.legend(
            handles=entries, loc="upper left", ncols=len(entries), borderaxespad=0.0, columnspacing=1.6,
            handletextpad=0.6,
            bbox_to_anchor=(LEFT / WIDTH, 1.0 - (below + _KEY + i * _LINE) / figure.get_size_inches()[1]),
        )  # fmt: skip
    return figure


def _draw(axes: Axes, scenario: Scenario, route: Route) -> None:
    plan = route.plan
    draw_lines(axes, plan, WITHIN)
    draw_came(axes, plan, WITHIN)
    if plan.paths:
        draw_beyond(axes, plan, route.speed)
        ring_worst(axes, plan, route.speed)
    axes.set_title(route.name, pad=16.0)
    axes.annotate(
        _told(route, scenario), (0.0, 1.0), xycoords="axes fraction", xytext=(0.0, 4.5), textcoords="offset points",
        va="bottom",
    )  # fmt: skip


def _told(route: Route, scenario: Scenario) -> str:
    """ "97.9 m, 0.5 g", or how far from the goal the search ended."""
    plan = route.plan
    if plan.paths:
        return f"{text(plan.paths[0].length, 'm', 4)}, {number(_most(route))} g"
    left = [dist(path.xy[-1], scenario.goals[0]) for path in came(plan)]
    return f"{plan.outcome}, {text(left[0], 'm')} from the goal" if left else plan.outcome


def _most(route: Route) -> float:
    """What it needs at most [g]."""
    return abs(worst_place(route.plan, route.speed)[2])


def _key(scenario: Scenario, routes: Sequence[Route]) -> list[list[Line2D]]:
    """What the marks mean, in two rows."""
    plans, found = [route.plan for route in routes], [route for route in routes if route.plan.paths]
    entries = ground_entries(scenario)
    if any(plan.polylines and plan.smallest_radius is not None for plan in plans):
        entries.append(Line2D([], [], color=WITHIN, linewidth=0.9, linestyle=DASHES, label="before smoothing"))
    entries += came_entries(plans, WITHIN)
    return [entries, *([entries_up_to(max(map(_most, found)), "at its speed")] if found else [])]
