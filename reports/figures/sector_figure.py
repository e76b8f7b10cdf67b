"""The picture of the sectors that A* by arcs searches (paper 004, Fig. 7), and of how each search ended."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Wedge

from planners.astar.arc_printed import AstarArcPaper, Descent, children, descent_of
from planners.astar.heading_limits import LATERAL, heading_limit
from planners.kernel import Floats
from planners.scenario import Scenario
from planners.segments import is_free
from planners.units import STANDARD_GRAVITY
from reports.figures.extent import Extent
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.plan_map import draw_ground, ground_entries
from reports.figures.style import BLUE, INK, ORANGE, PAPER, SKY, VERMILION, WIDTH, Look, new_figure, place
from reports.figures.ticks import ticks_from
from reports.words.quantity import number, text
from reports.words.words import KMH
from sim.truck_limits import STEERING_LIMIT, WHEELBASE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COLUMNS = 3  # searches side by side at most
_TOP, _BETWEEN, _LABELS, _KEY, _BOTTOM, _GAP = 0.46, 0.56, 0.44, 0.28, 0.06, 0.36  # [in]
_REACH = 0.75  # [steps] from the middle of a view to its sides; the node stands half a step behind it
_RAYS = 0.25  # [deg] between the lines along which a sector's borders are looked for
_SECTOR: Look = {"facecolor": SKY, "alpha": 0.35, "linewidth": 0.0, "zorder": 3.0}
_WHOLE: Look = {"facecolor": "none", "edgecolor": BLUE, "linewidth": 0.7, "linestyle": (0, (1, 1.5)), "zorder": 3.2}
_CHILD: Look = {"marker": "o", "markersize": 3.0, "linestyle": "none", "color": BLUE, "label": "child"}
_HIDDEN: Look = {**_CHILD, "markerfacecolor": PAPER, "color": VERMILION, "label": "hidden"}
_WAY: Look = {"color": INK, "linewidth": 1.3, "marker": "o", "markersize": 3.6, "label": "path"}
_ARC: Look = {"color": ORANGE, "linewidth": 1.6, "label": f"sharpest arcs at {LATERAL:g} g"}


def sector_figure(scenario: Scenario, planners: Mapping[str, AstarArcPaper]) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`: of each search the sector that is cut most
    but leaves a way on, and the last, which holds the goal or nothing. All at one scale.
    """
    chosen = {name: (planner, descent_of(scenario, planner)) for name, planner in list(planners.items())[:COLUMNS]}
    searches = {name: (planner, found) for name, (planner, found) in chosen.items() if found is not None}
    side = (WIDTH - LEFT - RIGHT - (COLUMNS - 1) * _GAP) / COLUMNS
    reach = _REACH * max((found.step for _, found in searches.values()), default=1.0)
    figure = new_figure(_TOP + 2.0 * side + _BETWEEN + _LABELS + _KEY + _BOTTOM)
    for column, (planner, found) in enumerate(searches.values()):
        for row, node in enumerate((most_cut(found), len(found.nodes) - 1 - found.arrived)):
            box = Box(LEFT + column * (side + _GAP), _TOP + row * (side + _BETWEEN), side, side)
            axes = place(figure, box.left, box.top, box.width, box.height)
            _draw(axes, scenario, planner.planned_speed, found, node, reach)
            axes.set(xlabel=axes.get_xlabel() if row else "", ylabel="" if column else axes.get_ylabel())
    entries = [*ground_entries(scenario)[:2], *(Line2D([], [], **look) for look in (_WAY, _CHILD, _HIDDEN, _ARC))]
    figure.legend(
        handles=entries, loc="upper left", ncols=len(entries), borderaxespad=0.0, columnspacing=1.3, handletextpad=0.6,
        bbox_to_anchor=(LEFT / WIDTH, (_KEY + _BOTTOM - 0.06) / figure.get_size_inches()[1]),
    )  # fmt: skip
    return figure


def most_cut(found: Descent) -> int:
    """The node after the start whose sector hides most children but not all; where none does, the last but one."""
    last = len(found.nodes) - 1 - found.arrived
    free = [children(found, node)[1] for node in range(1, last + 1)]
    hidden = [int((~one).sum()) if one.any() else 0 for one in free]
    return int(np.argmax(hidden)) + 1 if any(hidden) else min(last, max(1, last - 1))


def _draw(axes: Axes, scenario: Scenario, speed: float, found: Descent, node: int, reach: float) -> None:
    """The sector of `node` on `axes` in metres from it, in a view of 2 `reach` [m]."""
    line = found.ground.to_metres(found.nodes)
    (x, y), heading = line[node], found.heading(node)
    middle = (x + 0.5 * reach / _REACH * math.cos(heading), y + 0.5 * reach / _REACH * math.sin(heading))
    draw_ground(axes, scenario, Extent(*middle, *middle).grown(reach))
    limit = math.degrees(found.limit if node else math.pi)
    ends, free = children(found, node)
    for first, last in _visible(found, node, limit):
        axes.add_patch(Wedge((x, y), found.step, first, last, **_SECTOR))
    axes.add_patch(Wedge((x, y), found.step, math.degrees(heading) - limit, math.degrees(heading) + limit, **_WHOLE))
    turn = heading_limit(speed, WHEELBASE, LATERAL * STANDARD_GRAVITY, STEERING_LIMIT)
    for arc in _arcs(turn, found.step):
        axes.plot(*(line[node] + _turned(arc, heading)).T, **_ARC, zorder=4.0)
    axes.plot(*line.T, **_WAY, zorder=4.2)
    axes.plot(*ends[~free].T, **_HIDDEN, zorder=4.3)
    axes.plot(*ends[free].T, **_CHILD, zorder=4.4)
    told = f"{int(free.sum())} of {len(free)} children free; {LATERAL:g} g: ±{number(math.degrees(turn))}°"
    if node == len(line) - 1:
        told = "no child is free and new: it ends here"
    elif node == len(line) - 2 and found.arrived:
        told = "the goal is in the sector"
    axes.set_title(f"{number(KMH * speed)} km/h: {text(found.step, 'm')}, ±{number(limit)}°", pad=16.0)
    axes.annotate(
        told, (0.0, 1.0), xycoords="axes fraction", xytext=(0.0, 4.5), textcoords="offset points", va="bottom"
    )
    ticks_from(axes, x, y)


def _visible(found: Descent, node: int, limit: float) -> list[tuple[float, float]]:
    """Between which bearings [deg] the sector of `node` is not cut, each pair counter-clockwise."""
    heading, (x, y), step = math.degrees(found.heading(node)), found.nodes[node], found.step / found.ground.cell
    bearings = heading + np.linspace(-limit, limit, 2 * math.ceil(limit / _RAYS) + 1)
    radii = np.radians(bearings)
    ends = np.column_stack([x + step * np.cos(radii), y + step * np.sin(radii)])
    free = [is_free(found.ground.blocked, x, y, *end) for end in ends]
    change = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(int)))
    return [(bearings[first], bearings[past - 1]) for first, past in change.reshape(-1, 2)]


def _arcs(turn: float, step: float) -> tuple[Floats, Floats]:
    """The arcs (N, 2) [m] of one `step` that turn by `turn` [rad] to the left and to the right, from the origin."""
    angle = np.linspace(0.0, turn, 30)
    arc = step / turn * np.column_stack([np.sin(angle), 1.0 - np.cos(angle)])
    return arc, arc * (1.0, -1.0)


def _turned(points: Floats, angle: float) -> Floats:
    cos, sin = math.cos(angle), math.sin(angle)
    return np.column_stack([cos * points[:, 0] - sin * points[:, 1], sin * points[:, 0] + cos * points[:, 1]])
