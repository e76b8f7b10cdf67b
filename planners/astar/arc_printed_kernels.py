"""Kernels of paper 004's search by arcs, as it is printed, in units of pixels: column x, row y."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, Ints, kernel
from planners.segments import is_free

CIRCLE = 120  # search nodes on a whole circle (section 2.2)
SPACING = 2.0 * math.pi / CIRCLE  # [rad] between two of them: 3 deg


@kernel
def sector(blocked: Bools, x: float, y: float, heading: int, step: float, ends: Floats, free: Bools) -> None:
    """The children of a node at (`x`, `y`): the pixels at the `ends` (N, 2) of its radii, and which are `free` (N,).

    Directions are counted on the circle, counter-clockwise from east. Child 0 lies in that of `heading`, 1 the next to
    its left, 2 to its right, and so on outwards. Each is the centre of the pixel nearest to the end of a radius of
    length `step`.
    """
    for i in range(len(ends)):
        turn = (i + 1) // 2 if i % 2 == 1 else -(i // 2)
        angle = (heading + turn) * SPACING
        ends[i, 0] = math.floor(x + step * math.cos(angle)) + 0.5
        ends[i, 1] = math.floor(y + step * math.sin(angle)) + 0.5
        free[i] = is_free(blocked, x, y, ends[i, 0], ends[i, 1])


@kernel
def descend(
    blocked: Bools, start: Floats, goal: Floats, step: float, limit: float, reach: int, nodes: Floats, headings: Ints
) -> tuple[int, bool]:
    """From `start` to `goal` (2,) by the best child of each node; how many rows of `nodes` (N, 2) and `headings` (N,)
    it filled, and whether it arrived. N must exceed the number of free pixels by 2.

    A node's heading is the direction of the circle in which it was found. Its sector reaches `limit` [rad] to either
    side, which holds `reach` directions; that of the start is the whole circle.
    """
    closed = np.zeros(blocked.shape, np.bool_)
    ends, free = np.empty((CIRCLE, 2)), np.empty(CIRCLE, np.bool_)
    x, y, heading, count, n = start[0], start[1], 0, CIRCLE, 0
    while True:
        nodes[n, 0], nodes[n, 1], headings[n] = x, y, heading
        closed[math.floor(y), math.floor(x)] = True
        n += 1
        sector(blocked, x, y, heading, step, ends[:count], free[:count])
        if n > 1:
            reached = _holds(goal[0] - x, goal[1] - y, heading * SPACING, step, limit)
        else:
            reached = math.hypot(goal[0] - x, goal[1] - y) <= step
        chosen, least = -1, math.inf
        for i in range(count):
            if not free[i]:
                continue
            if math.floor(ends[i, 0]) == math.floor(goal[0]) and math.floor(ends[i, 1]) == math.floor(goal[1]):
                reached = True
            if closed[math.floor(ends[i, 1]), math.floor(ends[i, 0])]:
                continue
            # What g has before the node is the same for all that is open: only the node's own children are
            f = math.hypot(ends[i, 0] - x, ends[i, 1] - y) + math.hypot(goal[0] - ends[i, 0], goal[1] - ends[i, 1])
            if f < least:
                chosen, least = i, f
        if reached and is_free(blocked, x, y, goal[0], goal[1]):
            nodes[n, 0], nodes[n, 1], headings[n] = goal[0], goal[1], heading
            return n + 1, True
        if chosen < 0:
            return n, False
        heading += (chosen + 1) // 2 if chosen % 2 == 1 else -(chosen // 2)
        x, y, count = ends[chosen, 0], ends[chosen, 1], 2 * reach + 1


@kernel
def _holds(dx: float, dy: float, heading: float, step: float, limit: float) -> bool:
    """Whether a point at (`dx`, `dy`) from its apex lies in the sector about `heading` [rad]."""
    if math.hypot(dx, dy) > step:
        return False
    turn = (math.atan2(dy, dx) - heading + math.pi) % (2.0 * math.pi) - math.pi
    return abs(turn) <= limit
