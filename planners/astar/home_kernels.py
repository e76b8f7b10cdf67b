"""Lower bounds of the way to the goal: around the obstacles for a point, and past them for what turns no tighter."""

from __future__ import annotations

import math

import numpy as np

from planners.astar.dubins_kernels import from_0
from planners.kernel import Bools, Floats, kernel

CHANGE = 1e-6  # [cells] less than that is none


@kernel
def pooled(field: Floats, factor: int, least: float) -> Bools:
    """Cells `factor` times as large: true where any of those within has at least that much room."""
    rows, columns = field.shape
    free = np.zeros((-(-rows // factor), -(-columns // factor)), dtype=np.bool_)
    for row in range(free.shape[0]):
        for column in range(free.shape[1]):
            for y in range(row * factor, min((row + 1) * factor, rows)):
                for x in range(column * factor, min((column + 1) * factor, columns)):
                    free[row, column] |= field[y, x] >= least
    return free


@kernel
def ways_home(free: Bools, row: int, column: int) -> Floats:
    """Distance (rows, cols) [cells] of each free cell from one, around what is not free; inf where there is no way.

    The eikonal equation |grad u| = 1 by fast sweeping (Zhao 2005): every quarter of the directions in turn, until
    nothing changes. It is first-order: what it adds to the true distance is up to two cells from one bend to the next.
    """
    rows, columns = free.shape
    home = np.full((rows, columns), np.inf)
    home[row, column] = 0.0
    idle = turn = 0
    while idle < 4:
        changed = False
        for i in range(rows):
            y = i if turn & 1 else rows - 1 - i
            for j in range(columns):
                x = j if turn & 2 else columns - 1 - j
                if not free[y, x]:
                    continue
                a = min(home[y, x - 1] if x > 0 else math.inf, home[y, x + 1] if x < columns - 1 else math.inf)
                b = min(home[y - 1, x] if y > 0 else math.inf, home[y + 1, x] if y < rows - 1 else math.inf)
                if a == math.inf and b == math.inf:
                    continue
                way = min(a, b) + 1.0
                if abs(a - b) < 1.0:
                    way = 0.5 * (a + b + math.sqrt(2.0 - (a - b) * (a - b)))
                if way < home[y, x] - CHANGE:
                    home[y, x], changed = way, True
        idle = 0 if changed else idle + 1
        turn += 1
    return home


@kernel
def way_to_point(ahead: float, left: float, radius: float) -> float:
    """Length [m] of the shortest path to a point `ahead` and `left` [m], turning no tighter than `radius` [m].

    Without obstacles, any heading at the end (Bui et al. 1994: an arc and a line, or inside of the turning circle an
    arc the other way first).
    """
    left = abs(left)
    far = math.hypot(ahead, left - radius)
    if far >= radius:
        tangent = math.atan2(left - radius, ahead) - math.acos(radius / far)
        return radius * from_0(tangent + 0.5 * math.pi) + math.sqrt(far * far - radius * radius)
    # The right circle's centre is at (0, -radius), and the left one's two radii from it
    centre = math.hypot(ahead, left + radius)
    cosine = (3.0 * radius * radius + centre * centre) / (4.0 * radius * centre)
    base, spread, best = math.atan2(left + radius, ahead), math.acos(min(1.0, cosine)), math.inf
    for side in (-1.0, 1.0):
        to = base + side * spread
        x, y = 2.0 * radius * math.cos(to), 2.0 * radius * math.sin(to) - radius
        right = from_0(0.5 * math.pi - to)
        back = from_0(math.atan2(left - y, ahead - x) - to - math.pi)
        best = min(best, radius * (right + back))
    return best
