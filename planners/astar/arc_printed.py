"""Paper 004's A* by arcs as it is printed: sectors by speed, and an open list that is emptied at every step."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, ClassVar

import msgspec
import numpy as np

from planners.astar.arc_printed_kernels import CIRCLE, SPACING, descend, sector
from planners.astar.heading_limits import STEP_TIME, paper_heading_limit
from planners.astar.settings import Length, SpeedSettings
from planners.errors import InputError
from planners.ground import Ground, ground_of, path_of, pixel, without_path
from planners.kernel import Bools, Floats, Ints
from planners.path import Path
from planners.planner import NOT_FOUND, Plan, Stage
from planners.scenario import Scenario

CAME = "as far as it came"  # the stage of a plan without a path


@dataclass(frozen=True, slots=True, eq=False)
class Descent:
    """How the search went over `ground`: the `nodes` (N, 2) [cells] one after the other, and whether it `arrived`.

    `headings` (N,) are the directions in which they were found, of `CIRCLE` counter-clockwise from east. `step` [m] and
    `limit` [rad] are a sector's radius and what it reaches to either side of a heading.
    """

    ground: Ground
    nodes: Floats
    headings: Ints
    arrived: bool
    step: float
    limit: float

    def heading(self, node: int) -> float:
        """That of a node [rad]."""
        return float(self.headings[node]) * SPACING


class AstarArcPaper(SpeedSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A* by arcs (Xie et al., paper 004, sections 2.2 and 2.3), with the heading limits of its Tables 1 and 2.

    A node's children lie on an arc about it, one step of speed x 0.5 s away (eq. 10), 3 deg apart, within the heading
    limit on either side of its heading, each at the centre of the nearest pixel. Of them the one of least f = g + h
    follows, h being the distance from the goal (eq. 9, 11). Step 5 empties the open list, so none of the others is
    ever returned to: this is greedy descent, and where a node has no child that is free, nothing is found. It ends
    where the goal lies in a node's sector, or in the pixel of one of its children, with a free line to it.

    Where the paper leaves a choice, this is it. A node's heading is the direction of the circle in which it was found,
    not that of the line between two pixels: the turns that its Tables 3 and 4 print are multiples of 3 deg. Of children
    that are as good, as those in one pixel, the one that turns least counts. The start has no heading, and so the whole
    circle of 120 nodes. An obstacle cuts a sector along the lines to its borders (Fig. 7a): what it hides is gone, and
    one that stands within leaves a part on either side. A closed pixel is not opened again, as in any A*. The goal is
    a point: one that a step lands beside, outside of the sector, is driven past.

    cell: side of a pixel [map units]; None for that of the map's own raster, or 1/512 of its larger side.
    clearance: [m] kept from obstacles; the paper's vehicle is a point.
    """

    name: ClassVar[str] = "astar-arc-paper"
    summary: ClassVar[str] = "A* by arcs for a speed (paper 004, as printed): greedy, and may find nothing"

    cell: Length | None = None
    clearance: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] = 0.0

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same path for every seed, its corners at the nodes. Where it got stuck, a stage has the way it came.

        Raises `InputError` where a step is shorter than a pixel, and as `ground_of` does.
        """
        found = descent_of(scenario, self)
        if found is None:
            return without_path(self.clearance)
        line = found.ground.to_metres(found.nodes)
        if not found.arrived:
            return Plan(outcome=NOT_FOUND, reason=_stuck(line, found), stages=_came(line, scenario, self.name))
        path = path_of(line, scenario, self.name)
        if scenario.max_range is not None and path.length > scenario.max_range:
            what = f"its {path.length:.6g} m exceed the range of {scenario.max_range:.6g} m, and it knows no other way"
            return Plan(outcome=NOT_FOUND, reason=what)
        return Plan(paths=(path,))


def descent_of(scenario: Scenario, planner: AstarArcPaper) -> Descent | None:
    """The search itself; None where no free pixels lead from the start to the goal."""
    cell = pixel(scenario, planner.cell)
    step, limit = planner.planned_speed * STEP_TIME, paper_heading_limit(planner.planned_speed)
    if step < cell:
        what = f"a step of {step:.3g} m is shorter than a cell of {cell:.3g} m"
        raise InputError(f"planner {planner.name}", what, "give a higher speed or smaller cells")
    ground = ground_of(scenario, planner.name, cell, planner.clearance)
    if not ground.connected:
        return None
    most = int((~ground.blocked).sum()) + 2
    nodes, headings = np.empty((most, 2)), np.empty(most, np.int64)
    count, arrived = descend(
        ground.blocked, ground.start, ground.goal, step / cell, limit, sector_reach(limit), nodes, headings
    )
    return Descent(ground, nodes[:count].copy(), headings[:count].copy(), arrived, step, limit)


def children(found: Descent, node: int) -> tuple[Floats, Bools]:
    """Those (N, 2) [m] of a node of the search, from its heading outwards, and which are free (N,)."""
    count = 2 * sector_reach(found.limit) + 1 if node else CIRCLE
    ends, free = np.empty((count, 2)), np.empty(count, np.bool_)
    x, y = found.nodes[node]
    sector(found.ground.blocked, x, y, found.headings[node], found.step / found.ground.cell, ends, free)
    return found.ground.to_metres(ends), free


def sector_reach(limit: float) -> int:
    """How many directions of the circle lie within `limit` [rad] on one side of a heading."""
    return math.floor(limit / SPACING + 1e-9)


def _came(line: Floats, scenario: Scenario, name: str) -> tuple[Stage, ...]:
    """The way to where the search ended; none where that is the start."""
    if len(line) < 2:
        return ()
    way = np.vstack([scenario.starts[:1], line[1:]])
    return (Stage(CAME, (Path(way, name=name, frame=scenario.map.frame),)),)


def _stuck(line: Floats, found: Descent) -> str:
    """Where the search had no way on."""
    (x, y), steps = line[-1], len(line) - 1
    within = f"within {math.degrees(found.limit):.3g} deg of its heading" if steps else "on the whole circle about it"
    return (
        f"at ({x:.1f}, {y:.1f}) m, after {steps} step{'' if steps == 1 else 's'}, no node {found.step:.3g} m on and "
        f"{within} is free and new, and greedy descent cannot go back"
    )
