"""Kernels on the paths of pigeons: lateral offsets from a straight line become legs of equal length, and are judged."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, kernel

EVEN = 0.1  # share by which a leg may be longer or shorter than the mean of all
HAZARD, TURN, RANGE = 1.0, 1.0, 10.0  # weights of what breaks a limit, while searching


@kernel
def room_at(room: Floats, cell: float, x0: float, y0: float, x: float, y: float) -> float:
    """The distance to all that is forbidden at (x, y), between the nodes bilinearly; outside it falls with distance."""
    rows, columns = room.shape
    u, v = (x - x0) / cell, (y - y0) / cell
    a, b = min(max(u, 0.0), columns - 1.0), min(max(v, 0.0), rows - 1.0)
    i, j = min(int(b), rows - 2), min(int(a), columns - 2)
    s, t = a - j, b - i
    low = (1.0 - s) * room[i, j] + s * room[i, j + 1]
    high = (1.0 - s) * room[i + 1, j] + s * room[i + 1, j + 1]
    outside = 0.0 if a == u and b == v else cell * math.hypot(a - u, b - v)
    return float((1.0 - t) * low + t * high - outside)


@kernel
def depth_along(
    room: Floats, cell: float, x0: float, y0: float, ax: float, ay: float, bx: float, by: float, keep: float
) -> float:
    """How much nearer than `keep` to what is forbidden the segment from a to b comes, at most; 0 where nowhere.

    Where there is room, nothing nearer than that room can be met: so that far is skipped.
    """
    length = math.hypot(bx - ax, by - ay)
    least, deepest, s = 0.5 * cell, 0.0, 0.0
    while s < length:
        share = s / length
        spare = room_at(room, cell, x0, y0, ax + share * (bx - ax), ay + share * (by - ay)) - keep
        deepest = max(deepest, -spare)
        s += max(spare, least)
    return deepest


@kernel
def equal_legs(offsets: Floats, start: Floats, goal: Floats, raw: Floats, legs: Floats) -> None:
    """Put the path of `offsets` (D,), to the left at equal stations from `start` to `goal`, into `legs` (D + 2, 2).

    Its legs are equal along the path that the offsets draw, which `raw` (D + 2, 2) holds meanwhile.
    """
    n = len(offsets) + 1
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    span = math.hypot(dx, dy)
    total = 0.0
    for k in range(n + 1):
        side = offsets[k - 1] if 0 < k < n else 0.0
        raw[k, 0] = start[0] + dx * k / n - dy / span * side
        raw[k, 1] = start[1] + dy * k / n + dx / span * side
        if k > 0:
            total += math.hypot(raw[k, 0] - raw[k - 1, 0], raw[k, 1] - raw[k - 1, 1])
    legs[0, 0], legs[0, 1] = start[0], start[1]
    legs[n, 0], legs[n, 1] = goal[0], goal[1]
    at, passed = 0, 0.0
    leg = math.hypot(raw[1, 0] - raw[0, 0], raw[1, 1] - raw[0, 1])
    for k in range(1, n):
        wanted = total * k / n
        while passed + leg < wanted and at < n - 1:
            passed += leg
            at += 1
            leg = math.hypot(raw[at + 1, 0] - raw[at, 0], raw[at + 1, 1] - raw[at, 1])
        share = (wanted - passed) / leg
        legs[k, 0] = raw[at, 0] + share * (raw[at + 1, 0] - raw[at, 0])
        legs[k, 1] = raw[at, 1] + share * (raw[at + 1, 1] - raw[at, 1])


@kernel
def shape_of(legs: Floats) -> tuple[float, float, float, float]:
    """Of a path (N, 2): its length, its largest turn [rad], and its longest and shortest leg over their mean."""
    n = len(legs) - 1
    length, longest, shortest, sharpest = 0.0, 0.0, math.inf, 0.0
    before_x, before_y = 0.0, 0.0
    for k in range(n):
        x, y = legs[k + 1, 0] - legs[k, 0], legs[k + 1, 1] - legs[k, 1]
        leg = math.hypot(x, y)
        length += leg
        longest, shortest = max(longest, leg), min(shortest, leg)
        if k > 0:
            sharpest = max(sharpest, abs(math.atan2(before_x * y - before_y * x, before_x * x + before_y * y)))
        before_x, before_y = x, y
    return length, sharpest, longest * n / length, shortest * n / length


@kernel
def judge(
    offsets: Floats, start: Floats, goal: Floats, room: Floats, cell: float, x0: float, y0: float, keep: float,
    gentle: float, max_turn: float, max_range: float, cost: Floats, length: Floats, kept: Bools,
) -> None:  # fmt: skip
    """Cost, length and whether it keeps every limit, of each path of `offsets` (N, D).

    The cost is the length and, weighted, the depth of each leg in what is forbidden, the turns beyond `gentle` [rad] in
    lengths of a leg, and the length beyond `max_range`. The limits are `keep`, `max_turn` [rad], `max_range` and legs
    of equal length.
    """
    count, n = offsets.shape[0], offsets.shape[1] + 1
    raw, legs = np.empty((n + 1, 2)), np.empty((n + 1, 2))
    for i in range(count):
        equal_legs(offsets[i], start, goal, raw, legs)
        length[i], sharpest, longest, shortest = shape_of(legs)
        depth, turned = 0.0, 0.0
        for k in range(n):
            x, y = legs[k + 1, 0] - legs[k, 0], legs[k + 1, 1] - legs[k, 1]
            depth += depth_along(room, cell, x0, y0, legs[k, 0], legs[k, 1], legs[k + 1, 0], legs[k + 1, 1], keep)
            if k > 0:
                before_x, before_y = legs[k, 0] - legs[k - 1, 0], legs[k, 1] - legs[k - 1, 1]
                turn = abs(math.atan2(before_x * y - before_y * x, before_x * x + before_y * y))
                turned += max(turn - gentle, 0.0)
        beyond = max(length[i] - max_range, 0.0)
        cost[i] = length[i] + HAZARD * depth + TURN * turned * length[i] / n + RANGE * beyond
        even = longest <= 1.0 + EVEN and shortest >= 1.0 - EVEN
        kept[i] = depth == 0.0 and sharpest <= max_turn and beyond == 0.0 and even
