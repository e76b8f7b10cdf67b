"""The picture of a fleet's plan, as paper 001 draws it: hazards, diamonds, stars, and one colour an aircraft."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.exact import exact_paths
from planners.path import Path
from planners.planner import History, Plan
from planners.scenario import Scenario
from reports.figures.extent import Extent
from reports.figures.fleet_map import FREE_START, FREE_TARGET, draw_ends, end_entries, member_colours
from reports.figures.frame import draw_frame
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.plan_map import draw_hazards, label_ground, total, whole_map
from reports.figures.plan_turn import draw_exact, sharpest
from reports.figures.style import DASHES, INK, MUTED, WIDTH, new_figure, place
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks, ticks_from
from reports.words.quantity import number, text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_HEAD, _LINE, _KEY, _LABELS, _BOTTOM = 0.42, 0.19, 0.3, 0.44, 0.06  # [in]
_MAP, _LOWEST, _GAP, _TITLE = 4.3, 2.6, 0.78, 0.3  # [in] width of the map, its height at least
_AROUND = 0.05  # of the map, on each side of the sharpest turn
_BROADEST = 105  # characters of a line in the head
_PATH = 0.2  # [in] of a line about a path


def fleet_plan_figure(scenario: Scenario, name: str, plan: Plan, clearance: float) -> Figure:
    """The plan called `name` beside the exact shortest paths that keep `clearance` [m]: within `style.style()`."""
    exact, view = exact_paths(scenario, clearance), whole_map(scenario)
    first = textwrap.wrap(f"{name}: {plan_words(scenario, plan, exact)}", _BROADEST)
    others = [*_limit_words(scenario, plan), *_stage_words(scenario, plan)]
    lines = [*first, *(line for told in others for line in textwrap.wrap(told, _BROADEST))]
    top = _HEAD + _LINE * len(lines) + 0.14
    world = Box(LEFT, top, _MAP, min(_MAP, max(_LOWEST, _MAP * view.height / view.width)))
    figure = new_figure(world.bottom + _LABELS + _KEY + _BOTTOM)
    height = figure.get_size_inches()[1]
    figure.text(0.2 / WIDTH, 1.0 - 0.22 / height, scenario.name, fontsize=12.5, fontweight="bold", va="center")
    for i, line in enumerate(lines):
        figure.text(
            0.2 / WIDTH,
            1.0 - (_HEAD + _LINE * i) / height,
            line,
            va="top",
            fontsize=8.5,
            color=INK if i < len(first) else MUTED,
        )
    view = view.filled(world.width / world.height)
    axes = _axes(figure, world)
    draw_hazards(axes, scenario, view, INK)
    label_ground(axes, world, view)
    draw_exact(axes, exact)
    draw_paths(axes, scenario, plan)
    left = LEFT + _MAP + _GAP
    room = Box(left, top, WIDTH - RIGHT - left, world.height)
    if plan.paths:
        _draw_aside(figure, axes, scenario, plan, exact, room)
    _draw_key(figure, scenario, plan, world, exact, clearance)
    return figure


def pair_of(scenario: Scenario, path: Path) -> tuple[int, int]:
    """Which start and which goal, from 0, `path` joins: the nearest ones."""
    start, goal = (
        int(np.argmin(np.hypot(*(places - end).T)))
        for places, end in ((scenario.starts, path.xy[0]), (scenario.goals, path.xy[-1]))
    )
    return start, goal


def draw_paths(axes: Axes, scenario: Scenario, plan: Plan, width: float = 1.8) -> None:
    """Draw the paths with their ends, each in the colour of its aircraft, and dashed what they were one stage before.

    Ends that no path has are grey.
    """
    colours = member_colours(len(scenario.starts))
    for path in plan.stages[-2].paths if len(plan.stages) > 1 else ():
        colour = colours[pair_of(scenario, path)[0]]
        axes.plot(*path.xy.T, color=colour, linewidth=0.9, linestyle=DASHES, zorder=4.05)
    pairs = [pair_of(scenario, path) for path in plan.paths]
    for path, (start, _) in zip(plan.paths, pairs, strict=True):
        axes.plot(*path.xy.T, color=colours[start], linewidth=width, zorder=3.9)
        draw_ends(axes, path.xy, str(start + 1), colours[start])
    for i in set(range(len(scenario.starts))) - {start for start, _ in pairs}:
        axes.plot(*scenario.starts[i], **{**FREE_START, "zorder": 7})
    for i in set(range(len(scenario.goals))) - {goal for _, goal in pairs}:
        axes.plot(*scenario.goals[i], **{**FREE_TARGET, "zorder": 7})


def plan_words(scenario: Scenario, plan: Plan, exact: Sequence[Path]) -> str:
    """The sum of the paths, also against the exact shortest sum; or why there are none."""
    if not plan.paths:
        return f"{plan.outcome}: {plan.reason}"
    length, least = sum(path.length for path in plan.paths), total(exact)
    told = f"sum {_units(length, scenario)} ({text(length, 'm', 4)})"
    return told if least is None else f"{told}, {number(length / least, 4)} times the exact shortest sum"


def _limit_words(scenario: Scenario, plan: Plan) -> list[str]:
    """Longest path and largest turn against the scenario's limits."""
    if not plan.paths:
        return []
    longest = max(path.length for path in plan.paths)
    far, turned = scenario.max_range, scenario.max_turn_angle
    sharp = max(float(np.abs(path.turns).max(initial=0.0)) for path in plan.paths)
    most = f" of at most {number(far / scenario.unit, 6)}" if far is not None else ""
    limit = f" of at most {number(math.degrees(turned))}°" if turned is not None else ""
    return [f"longest path {number(longest / scenario.unit, 6)}{most} map units; largest turn {_degrees(sharp)}{limit}"]


def _stage_words(scenario: Scenario, plan: Plan) -> list[str]:
    """The sum after each stage: "Voronoi roadmap 741.2 → line of sight 702.3 → GCCPIO 690.1 map units"."""
    if len(plan.stages) < 2:
        return []
    sums = [(stage.name, sum(path.length for path in stage.paths) / scenario.unit) for stage in plan.stages]
    return [f"{' → '.join(f'{name} {number(length, 4)}' for name, length in sums)} map units"]


def _draw_aside(figure: Figure, world: Axes, scenario: Scenario, plan: Plan, exact: Sequence[Path], room: Box) -> None:
    """Beside the map: a line a path, the sharpest turn from near, and how the search went on."""
    below = _list_paths(figure, scenario, plan, room) + _TITLE
    history = plan.history if plan.history is not None and np.isfinite(plan.history.best).any() else None
    spare = room.bottom - below - (_LABELS + _TITLE if history else 0.0)
    near = Box(room.left, below, room.width, 0.56 * spare if history else min(spare, room.width))
    _draw_turn(_axes(figure, near), world, scenario, plan, exact)
    if history is not None:
        top = near.bottom + _LABELS + _TITLE
        _draw_search(_axes(figure, Box(room.left, top, room.width, room.bottom - top)), history, exact)


def _list_paths(figure: Figure, scenario: Scenario, plan: Plan, room: Box) -> float:
    """Write a line about each path; returns where they end [in]."""
    height, colours = figure.get_size_inches()[1], member_colours(len(scenario.starts))
    for row, path in enumerate(plan.paths):
        start, goal = pair_of(scenario, path)
        sharp = float(np.abs(path.turns).max(initial=0.0))
        told = f"{start + 1} to target {goal + 1}: {number(path.length / scenario.unit, 5)} units, {_degrees(sharp)}"
        line = 1.0 - (room.top + _PATH * (row + 0.4)) / height
        figure.add_artist(
            Line2D(
                [(room.left - 0.1) / WIDTH, (room.left + 0.08) / WIDTH], [line] * 2, color=colours[start], linewidth=2.4
            )
        )
        figure.text((room.left + 0.16) / WIDTH, line, told, va="center", fontsize=8.0)
    return room.top + _PATH * len(plan.paths)


def _draw_turn(axes: Axes, world: Axes, scenario: Scenario, plan: Plan, exact: Sequence[Path]) -> None:
    """The sharpest turn from near, framed on the `world`."""
    middle, angle = sharpest(plan)
    width, height = axes.get_window_extent().size
    view = Extent(*middle, *middle).grown(_AROUND * max(scenario.size)).filled(width / height)
    draw_frame(world, view)
    draw_hazards(axes, scenario, view, INK)
    draw_exact(axes, exact)
    colours = member_colours(len(scenario.starts))
    for path in plan.paths:
        colour = colours[pair_of(scenario, path)[0]]
        axes.plot(*path.xy.T, color=colour, linewidth=1.6, marker="o", markersize=2.8, zorder=3.9)
    axes.set_title(f"Sharpest turn: {_degrees(angle)}")
    ticks_from(axes, *middle)


def _draw_search(axes: Axes, history: History, exact: Sequence[Path]) -> None:
    """The sum of the best paths by iteration, against the exact one."""
    known = history.best[np.isfinite(history.best)]
    scale, unit = length_unit(float(known.max()))
    axes.plot(np.arange(1, len(history.best) + 1), history.best, color=INK, linewidth=1.4, zorder=3)
    least = total(exact)
    if least is not None:
        axes.axhline(least, color=INK, linewidth=0.7)
    low = min(float(known.min()), least or math.inf)
    room = 0.08 * (float(known.max()) - low) or 0.01 * low
    axes.set_ylim(low - room, float(known.max()) + room)
    width, height = (side / axes.figure.dpi for side in axes.bbox.size)
    ticks(axes.yaxis, height / HIGH, scale)
    ticks(axes.xaxis, width / BROAD)
    axes.set_title(f"Best sum [{unit}]")
    axes.set_xlabel("iteration")


def _draw_key(
    figure: Figure, scenario: Scenario, plan: Plan, world: Box, exact: Sequence[Path], clearance: float
) -> None:
    entries = end_entries()
    if len(plan.stages) > 1:
        entries.append(Line2D([], [], color=MUTED, linewidth=0.9, linestyle=DASHES, label=plan.stages[-2].name))
    if (least := total(exact)) is not None:
        clear = f", {text(clearance, 'm')} clear" if clearance else ""
        told = f"exact shortest{clear}: {_units(least, scenario)}"
        entries.append(Line2D([], [], color=INK, linewidth=0.7, label=told))
    figure.legend(
        handles=entries, loc="upper left", ncols=len(entries), borderaxespad=0.0, columnspacing=1.4, handletextpad=0.6,
        bbox_to_anchor=(LEFT / WIDTH, 1.0 - (world.bottom + _LABELS + 0.06) / figure.get_size_inches()[1]),
    )  # fmt: skip


def _units(length: float, scenario: Scenario) -> str:
    return f"{number(length / scenario.unit, 6)} map units"


def _degrees(angle: float) -> str:
    return f"{number(math.degrees(angle))}°"


def _axes(figure: Figure, box: Box) -> Axes:
    return place(figure, box.left, box.top, box.width, box.height)
