"""The search over poses: A* whose steps are the arcs that a vehicle drives between two steering actions."""

from __future__ import annotations

import math

import numpy as np

from planners.astar.dubins_kernels import FULL_TURN, way_to_pose
from planners.astar.finish_kernels import FREE_HEADING, arcs_fit, last_arcs
from planners.astar.heap_kernels import pop, push
from planners.astar.home_kernels import way_to_point
from planners.astar.room_kernels import along_arc, arc_fits, fits
from planners.kernel import Bytes, Floats, Ints, kernel

TURNS = 3  # to either side: arcs of 1, 2 and 3 thirds of the largest curvature
HEADINGS = 72  # that are told apart, 5 deg each
BITS = 2 * TURNS + 1  # of a byte: the arcs on which a pose was reached
NONE, MOST = -1, -2  # in place of a node
COARSE = 2.0  # [cells] by which the way home may be too long
X, Y, HEADING, WAY, CURVATURE = range(5)  # columns of a node


@kernel
def cell_of(x: float, y: float, heading: float, cell: float, columns: int) -> int:
    """The number of the cell of a pose: square in position, `HEADINGS` in heading."""
    turn = int(heading % FULL_TURN / FULL_TURN * HEADINGS + 0.5) % HEADINGS
    return (int(y / cell) * columns + int(x / cell)) * HEADINGS + turn


@kernel
def bound(
    x: float, y: float, heading: float, goal: Floats, goal_heading: float, home: Floats, home_cell: float,
    radius: float, finish_radius: float,
) -> float:  # fmt: skip
    """About the least way [m] from a pose to the `goal` (2,); inf where there is none.

    The greater of that around the obstacles, less what its cells add to it in the open (behind many obstacles they add
    up to 2 % more), and that of turns of `radius` [m]; with
    a heading at the goal of `finish_radius`, of which the last arcs are. That is no bound where an earlier turn is
    tighter, but without it the search would look at all poses about the goal.
    """
    rows, columns = home.shape
    row, column = min(int(y / home_cell), rows - 1), min(int(x / home_cell), columns - 1)
    dx, dy = goal[0] - x, goal[1] - y
    ahead, left = math.cos(heading), math.sin(heading)
    at_ahead, at_left = dx * ahead + dy * left, dy * ahead - dx * left
    if goal_heading == FREE_HEADING:
        turning = way_to_point(at_ahead, at_left, radius)
    else:
        turning = way_to_pose(at_ahead, at_left, goal_heading - heading, finish_radius)
    around = (home[row, column] - COARSE) * home_cell
    return around if around > turning else turning


@kernel
def search(
    field: Floats, cell: float, size: Floats, along: Floats, radius: float, middle: float, around: float,
    home: Floats, home_cell: float, starts: Floats, goal: Floats, goal_heading: float,
    step: float, curvature: float, change: float, seen: Bytes, pose_cell: float, slack: float, most: int,
) -> tuple[int, int, Floats, Ints]:  # fmt: skip
    """A* from the poses `starts` (S, 3) to the `goal` (2,) by arcs of `step` [m] up to `curvature` [1/m].

    From one arc to the next the curvature changes by at most `change` [1/m]. The last arcs end on the goal, with
    `goal_heading` where that is given. `seen` (cells,) has a bit for each pose's arcs, all 0. An arc is looked at when
    its turn comes (lazy collision checks), for most never have it. What is found is at most `slack` times as long as
    the shortest of such ways, but for what the cells of `seen` leave out.

    Returns the last node, or `NONE` where there is none and `MOST` after `most` poses; how many poses were looked at;
    all nodes (N, 5) and their parents (N,).
    """
    columns = int(size[0] / pose_cell) + 1
    room = 1 << 14
    nodes, parents = np.empty((room, 5)), np.empty(room, dtype=np.int64)
    costs, items = np.empty(room), np.empty(room, dtype=np.int64)
    arcs = np.empty((3, 2))
    made = count = looked = 0
    for i in range(len(starts)):
        if fits(field, cell, size, along, radius, starts[i, 0], starts[i, 1], starts[i, 2]):
            nodes[made, X], nodes[made, Y], nodes[made, HEADING] = starts[i, 0], starts[i, 1], starts[i, 2]
            nodes[made, WAY], nodes[made, CURVATURE], parents[made] = 0.0, 0.0, -1
            count = push(costs, items, count, 0.0, made)
            made += 1
    while count > 0:
        item = items[0]
        if item < 0:  # of a node on the goal, that has been looked at
            return ~item, looked, nodes[:made], parents[:made]
        count = pop(costs, items, count)
        x, y, heading, way, bent = nodes[item]
        parent = parents[item]
        if parent >= 0:
            here = cell_of(x, y, heading, pose_cell, columns)
            bit = np.int64(1) << round((bent / curvature + 1.0) * TURNS)
            if seen[here] & bit:
                continue
            if not arc_fits(
                field, cell, size, along, radius, middle, around,
                nodes[parent, X], nodes[parent, Y], nodes[parent, HEADING], bent, step,
            ):  # fmt: skip
                continue
            seen[here] |= bit
        looked += 1
        if looked > most:
            return MOST, looked, nodes[:made], parents[:made]
        if made + BITS + len(arcs) > room:
            room *= 2
            more_nodes, more_parents = np.empty((room, 5)), np.empty(room, dtype=np.int64)
            more_costs, more_items = np.empty(room), np.empty(room, dtype=np.int64)
            more_nodes[:made], more_parents[:made] = nodes[:made], parents[:made]
            more_costs[:count], more_items[:count] = costs[:count], items[:count]
            nodes, parents, costs, items = more_nodes, more_parents, more_costs, more_items
        last = last_arcs(x, y, heading, bent, parent < 0, goal, goal_heading, step, curvature, change, arcs)
        if last < math.inf and arcs_fit(
            field, cell, size, along, radius, middle, around, x, y, heading, arcs
        ):  # fmt: skip
            before = item
            for k in range(len(arcs)):
                if arcs[k, 1] > 0.0:
                    x, y, heading = along_arc(x, y, heading, arcs[k, 0], arcs[k, 1])
                    nodes[made, X], nodes[made, Y], nodes[made, HEADING] = x, y, heading
                    nodes[made, WAY], nodes[made, CURVATURE] = nodes[before, WAY] + arcs[k, 1], arcs[k, 0]
                    parents[made], before = before, made
                    made += 1
            nodes[before, X], nodes[before, Y] = goal[0], goal[1]
            count = push(costs, items, count, way + last, ~before)
            x, y, heading, way, bent = nodes[item]
        for k in range(-TURNS, TURNS + 1):
            arc = k * curvature / TURNS
            if parent >= 0 and abs(arc - bent) > change:
                continue
            to_x, to_y, to = along_arc(x, y, heading, arc, step)
            if to_x < 0.0 or to_y < 0.0 or to_x > size[0] or to_y > size[1]:
                continue
            if seen[cell_of(to_x, to_y, to, pose_cell, columns)] & (np.int64(1) << (k + TURNS)):
                continue
            least = bound(
                to_x, to_y, to, goal, goal_heading, home, home_cell, 1.0 / curvature, 1.0 / min(curvature, change)
            )  # fmt: skip
            if least == math.inf:
                continue
            nodes[made, X], nodes[made, Y], nodes[made, HEADING] = to_x, to_y, to
            nodes[made, WAY], nodes[made, CURVATURE], parents[made] = way + step, arc, item
            count = push(costs, items, count, way + step + slack * least, made)
            made += 1
    return NONE, looked, nodes[:made], parents[:made]
