"""The picture of plans: the map, each one's sharpest turn from near, and how the searches went on."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.exact import exact_paths
from planners.path import Path as PlannedPath
from planners.planner import Plan
from planners.scenario import Scenario
from reports.figures.fleet_plan_figure import fleet_plan_figure
from reports.figures.frame import draw_frame
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.needed_panel import WITHIN, draw_beyond, draw_worst, needed_entries
from reports.figures.plan_map import colours_of, draw_ground, ground_entries, label_ground, total, whole_map
from reports.figures.plan_search import draw_search
from reports.figures.plan_turn import came_entries, draw_came, draw_exact, draw_lines, draw_turn, turn_view
from reports.figures.style import DASHES, INK, MUTED, WIDTH, new_figure, place, save, style
from reports.pages.plan_rows import is_fleet
from reports.words.quantity import number, text

_LABELS, _TITLE, _KEY, _BOTTOM = 0.44, 0.44, 0.26, 0.06  # [in] under and above axes, legend of the map, margin
_NAME, _LINE = 0.40, 0.19  # [in] of the head, and of each plan in it
_BROADEST = 105  # characters of a line in the head
_FULL = WIDTH - LEFT - RIGHT
_HIGHEST, _LOWEST = 4.8, 2.0  # [in] of the map
_TURN, _SEARCH = 2.3, 2.3  # [in] height of the rows
_GAP = 0.8  # [in] between panels side by side
_MOST_TURNS = 3


def save_plan_figure(
    scenario: Scenario,
    plans: Mapping[str, Plan],
    file: str | Path,
    clearance: float = 0.0,
    speed: float | None = None,
) -> None:
    """Write the picture of `plans`, by name, as PNG (1600 pixels wide) or SVG, by the suffix of `file`.

    The same plans give the same bytes. Raises `InputError` where the folder does not exist.
    """
    with style():
        save(plans_figure(scenario, plans, clearance, speed), file)


def plans_figure(
    scenario: Scenario, plans: Mapping[str, Plan], clearance: float = 0.0, speed: float | None = None
) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`.

    The one plan of a fleet has a picture of its own. The yardstick is the exact shortest path that keeps `clearance`
    [m]. Plans for a ground vehicle's `speed` [m/s] are coloured by the lateral acceleration that they need.
    """
    if is_fleet(scenario) and len(plans) == 1:
        ((name, plan),) = plans.items()
        return fleet_plan_figure(scenario, name, plan, clearance)
    return plan_figure(scenario, plans, clearance, speed)


def plan_figure(
    scenario: Scenario, plans: Mapping[str, Plan], clearance: float = 0.0, speed: float | None = None
) -> Figure:
    """That of plans for one vehicle each."""
    colours = colours_of(plans) if speed is None else dict.fromkeys(plans, WITHIN)
    exact, view = exact_paths(scenario, clearance), whole_map(scenario)
    turns = [name for name, plan in plans.items() if plan.paths][:_MOST_TURNS]
    histories = {name: plan.history for name, plan in plans.items() if plan.history is not None}
    told = {
        name: textwrap.fill(f"{name}: {_told(plan, scenario.unit, exact)}", _BROADEST) for name, plan in plans.items()
    }
    top = _NAME + _LINE * sum(len(lines.splitlines()) for lines in told.values()) + 0.12
    world = Box(LEFT, top, _FULL, min(_HIGHEST, max(_LOWEST, _FULL * view.height / view.width)))
    key = _KEY if speed is None else _KEY + _LINE
    near, search, bottom = _rows(world.bottom + _LABELS + key + _TITLE, len(turns), bool(histories))
    figure = new_figure(bottom + _BOTTOM)
    _draw_head(figure, scenario, told, colours)
    view = view.filled(world.width / world.height)
    axes = place(figure, world.left, world.top, world.width, world.height)
    draw_ground(axes, scenario, view)
    label_ground(axes, world, view)
    draw_exact(axes, exact)
    for name, plan in plans.items():
        draw_lines(axes, plan, colours[name])
        draw_came(axes, plan, colours[name])
        if speed is not None and plan.paths:
            draw_beyond(axes, plan, speed)
            draw_worst(axes, plan, speed)
    for name, box in zip(turns, near, strict=True):
        around = turn_view(scenario, plans[name]).filled(box.width / box.height)
        draw_frame(axes, around)
        near_axes = place(figure, box.left, box.top, box.width, box.height)
        draw_turn(near_axes, scenario, plans[name], exact, name, colours[name])
        if speed is not None:
            draw_beyond(near_axes, plans[name], speed)
    _draw_key(figure, scenario, world, plans, _yardstick(exact, clearance), speed)
    if search is not None:
        draw_search(figure, search, histories, colours, total(exact))
    return figure


def _rows(top: float, turns: int, searched: bool) -> tuple[list[Box], Box | None, float]:
    """Boxes of the turns and of the searches from `top` on, and where they end: one turn has the searches beside it."""
    bottom, beside = top - _TITLE, searched and turns == 1
    count = turns + 1 if beside else max(1, turns)
    width = (_FULL - (count - 1) * _GAP) / count
    if beside:
        width = _TURN + 0.2
    near = [Box(LEFT + i * (width + _GAP), top, width, _TURN) for i in range(turns)]
    if near:
        bottom = near[0].bottom + _LABELS
    if not searched:
        return near, None, bottom
    if beside:
        left = LEFT + width + _GAP
        return near, Box(left, top, WIDTH - RIGHT - left, _TURN), bottom
    search = Box(LEFT, bottom + _TITLE - 0.1, _FULL, _SEARCH)
    return near, search, search.bottom + _LABELS


def _draw_head(figure: Figure, scenario: Scenario, told: Mapping[str, str], colours: Mapping[str, str]) -> None:
    """The scenario's name, and what is told of each plan in its colour."""
    height = figure.get_size_inches()[1]
    figure.text(0.2 / WIDTH, 1.0 - 0.22 / height, scenario.name, fontsize=12.5, fontweight="bold", va="center")
    lines = [Line2D([], [], color=colours[name], linewidth=1.8, label=lines) for name, lines in told.items()]
    figure.legend(
        handles=lines, loc="upper left", bbox_to_anchor=(0.2 / WIDTH, 1.0 - _NAME / height), borderaxespad=0.0,
        fontsize=8.5, handlelength=1.4, borderpad=0.0, labelspacing=0.4,
    )  # fmt: skip


def _told(plan: Plan, unit: float, exact: Sequence[PlannedPath]) -> str:
    """Length, also in map units of `unit` [m] and against the exact shortest path; or why there is no path."""
    if not plan.paths:
        return f"{plan.outcome}: {plan.reason}"
    length, least = sum(path.length for path in plan.paths), total(exact)
    told = text(length, "m", 4)
    if unit != 1.0:
        told += f" ({number(length / unit, 6)} map units)"
    if least is not None:
        told += f", {number(length / least, 4)} times the exact shortest {'path' if len(exact) == 1 else 'sum'}"
    return told


def _yardstick(exact: Sequence[PlannedPath], clearance: float) -> str:
    """What the exact shortest path is called, "" where there is none."""
    least = total(exact)
    if least is None:
        return ""
    apart = f", {text(clearance, 'm')} clear" if clearance else ""
    return f"exact shortest{apart}: {text(least, 'm', 4)}"


def _draw_key(
    figure: Figure, scenario: Scenario, world: Box, plans: Mapping[str, Plan], yardstick: str, speed: float | None
) -> None:
    """What the marks of the map mean, in a row under it, and its colours at a `speed` [m/s] in another."""
    entries = ground_entries(scenario)
    if yardstick:
        entries.append(Line2D([], [], color=INK, linewidth=0.7, label=yardstick))
    if any(plan.polylines and plan.smallest_radius is not None for plan in plans.values()):
        entries.append(Line2D([], [], color=MUTED, linewidth=0.9, linestyle=DASHES, label="before smoothing"))
    entries += came_entries(plans.values(), MUTED)
    needed = [] if speed is None else needed_entries(plans.values(), speed)
    for i, row in enumerate(filter(None, [entries, needed])):
        top = world.bottom + _LABELS + 0.04 + i * _LINE
        figure.legend(
            handles=row, loc="upper left", ncols=len(row), borderaxespad=0.0, columnspacing=1.6, handletextpad=0.6,
            bbox_to_anchor=(LEFT / WIDTH, 1.0 - top / figure.get_size_inches()[1]),
        )  # fmt: skip
