"""The last arcs of a way: from a pose onto the goal."""

from __future__ import annotations

import math

from planners.astar.dubins_kernels import FULL_TURN, LSL, LSR, word
from planners.astar.room_kernels import along_arc, arc_fits
from planners.kernel import Floats, kernel

FREE_HEADING = 1e9  # [rad] stands for a heading that is not given
FINISH = 3.0  # [steps] the last arc's length at most
FINISH_TURNS = 0.5  # [turns] that are allowed on top of it where the heading at the goal is given


@kernel
def arc_to(x: float, y: float, heading: float, goal: Floats) -> tuple[float, float]:
    """Curvature [1/m] and length [m] of the arc from a pose to the `goal` (2,); length inf where that is not ahead."""
    dx, dy = goal[0] - x, goal[1] - y
    far = math.hypot(dx, dy)
    half = (math.atan2(dy, dx) - heading + math.pi) % FULL_TURN - math.pi
    if far == 0.0 or abs(half) > 0.49 * math.pi:
        return 0.0, math.inf
    return 2.0 * math.sin(half) / far, far if abs(half) < 1e-9 else far * half / math.sin(half)


@kernel
def last_arcs(
    x: float, y: float, heading: float, bent: float, begins: bool, goal: Floats, goal_heading: float,
    step: float, curvature: float, change: float, arcs: Floats,
) -> float:  # fmt: skip
    """Length [m] of the way to the `goal` (2,) from a pose, where nothing stands in it; inf where there is none.

    An arc, or where `goal_heading` [rad] is given two with a line between (Dubins 1957), which is a `step` [m] at least
    where they turn to different sides. Curvatures [1/m] keep to `curvature`, and differ by at most `change`, also from
    that with which the pose was reached, `bent`, unless it `begins` the path. `arcs` (3, 2) takes curvatures and
    lengths, and some of these may be 0.
    """
    arcs[:] = 0.0
    if goal_heading == FREE_HEADING:
        bend, length = arc_to(x, y, heading, goal)
        arcs[0, 0], arcs[0, 1] = bend, length
        fine = length <= FINISH * step and abs(bend) <= curvature and (begins or abs(bend - bent) <= change)
        return length if fine else math.inf
    bend = min(curvature, change)
    dx, dy = goal[0] - x, goal[1] - y
    d, bearing = math.hypot(dx, dy) * bend, math.atan2(dy, dx)
    most, best = FINISH * step + FINISH_TURNS * FULL_TURN / bend, math.inf
    for side in (-1.0, 1.0):
        for kind in (LSL, LSR):
            first, middle, last = word(kind, side * (heading - bearing), side * (goal_heading - bearing), d)
            length = (first + middle + last) / bend
            begin = side * bend if first > 0.0 else 0.0
            if length > min(most, best) or (kind == LSR and middle < bend * step):
                continue
            if not begins and abs(begin - bent) > change:
                continue
            best = length
            arcs[0, 0], arcs[2, 0] = side * bend, side * bend if kind == LSL else -side * bend
            arcs[0, 1], arcs[1, 1], arcs[2, 1] = first / bend, middle / bend, last / bend
    return best


@kernel
def arcs_fit(
    field: Floats, cell: float, size: Floats, along: Floats, radius: float, middle: float, around: float,
    x: float, y: float, heading: float, arcs: Floats,
) -> bool:  # fmt: skip
    """Whether the body fits all along `arcs` (A, 2), curvatures [1/m] and lengths [m], but for their start."""
    for k in range(len(arcs)):
        bend, length = arcs[k, 0], arcs[k, 1]
        if not arc_fits(field, cell, size, along, radius, middle, around, x, y, heading, bend, length):
            return False
        x, y, heading = along_arc(x, y, heading, bend, length)
    return True
