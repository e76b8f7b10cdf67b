"""Kernels of turn-aware ants: they have a heading, and go only where a turn of the vehicle's radius leads on."""

from __future__ import annotations

import math

import numpy as np

from planners.aco.roulette_kernels import TRACE, Dice, eta_limit, roulette
from planners.aco.walk_kernels import reach_of
from planners.kernel import Bools, Floats, Ints, kernel
from planners.rounding.corner_kernels import SHARPEST, is_corner_free, least_radius, turn_at
from planners.segments import is_free


@kernel
def turns(blocked: Bools, room: Floats, corner: Floats, radius: float) -> bool:
    """Whether the `corner` (3, 2) can be rounded with `radius` within half of either leg, and free of obstacles.

    `room` (rows, cols) is the distance of each cell's centre from the nearest blocked one.
    """
    before = math.hypot(corner[1, 0] - corner[0, 0], corner[1, 1] - corner[0, 1])
    after = math.hypot(corner[2, 0] - corner[1, 0], corner[2, 1] - corner[1, 1])
    turn = abs(turn_at(corner, 1))
    if turn > SHARPEST or radius * math.tan(turn / 2.0) > 0.5 * min(before, after):
        return False
    wide = radius / least_radius(turn)
    tangent = wide * math.tan(turn / 2.0)
    if tangent > 0.5 * min(before, after):
        return False
    # The piece is no farther from the vertex than its ends, and centres are half a diagonal from what they stand for
    clear = room[int(corner[1, 1]), int(corner[1, 0])] > tangent + 1.5
    return clear or is_corner_free(blocked, corner, wide, 1)


@kernel
def bearing_index(dx: float, dy: float, count: int) -> int:
    """Which of `count` cells of a ring, in the order of their bearing, lies about in the direction (dx, dy)."""
    return int(count * (math.atan2(dy, dx) / (2.0 * math.pi) + 0.5)) % count


@kernel
def leads_on(
    blocked: Bools, room: Floats, corner: Floats, goal: Floats, offsets: Ints, radius: float
) -> bool:  # fmt: skip
    """Whether from the end of the leg `corner[0]` to `corner[1]` a turn leads on, to some cell or to the goal.

    `corner` (3, 2) is overwritten in its last row.
    """
    rows, columns = blocked.shape
    x, y = corner[1, 0], corner[1, 1]
    corner[2, 0], corner[2, 1] = goal[0], goal[1]
    if is_free(blocked, x, y, goal[0], goal[1]) and turns(blocked, room, corner, radius):
        return True
    ahead = bearing_index(x - corner[0, 0], y - corner[0, 1], len(offsets))
    for i in range(len(offsets) // 2):
        k = (ahead + (i + 1) // 2 * (1 if i % 2 == 0 else -1)) % len(offsets)
        corner[2, 0], corner[2, 1] = x + offsets[k, 0], y + offsets[k, 1]
        c, r = int(corner[2, 0]), int(corner[2, 1])
        if corner[2, 0] < 0.0 or corner[2, 1] < 0.0 or c >= columns or r >= rows or blocked[r, c]:
            continue
        if turns(blocked, room, corner, radius) and is_free(blocked, x, y, corner[2, 0], corner[2, 1]):
            return True
    return False


@kernel
def walk_turning(
    blocked: Bools, room: Floats, attraction: Floats, dice: Dice, start: Floats, goal: Floats, offsets: Ints,
    alpha: float, beta: float, bias: float, longest: float, radius: float, visited: Ints, mark: int, nodes: Floats,
) -> tuple[int, bool]:  # fmt: skip
    """One ant as in `walk`, but it steps only where each of its corners can be rounded with `radius` [cells], and only
    where from there another such corner leads on.
    """
    rows, columns = blocked.shape
    reach = reach_of(offsets)
    eta, weight = np.empty(len(offsets)), np.empty(len(offsets))
    to = np.empty((len(offsets), 2), np.int64)
    corner, onward = np.zeros((3, 2)), np.empty((3, 2))
    x, y, length, n = start[0], start[1], 0.0, 1
    nodes[0, 0], nodes[0, 1] = x, y
    while True:
        column, row = int(x), int(y)
        visited[row, column] = mark
        if n > 1:
            corner[0, 0], corner[0, 1], corner[1, 0], corner[1, 1] = nodes[n - 2, 0], nodes[n - 2, 1], x, y
        home = math.hypot(goal[0] - x, goal[1] - y)
        if home <= 2.0 * reach and is_free(blocked, x, y, goal[0], goal[1]):
            corner[2, 0], corner[2, 1] = goal[0], goal[1]
            if n == 1 or turns(blocked, room, corner, radius):
                nodes[n, 0], nodes[n, 1] = goal[0], goal[1]
                return n + 1, length + home <= longest
        count = 0
        ahead = bearing_index(x - corner[0, 0], y - corner[0, 1], len(offsets))
        for i in range(len(offsets) if n == 1 else len(offsets) // 2):
            k = (ahead + i - len(offsets) // 4) % len(offsets)
            c, r = column + offsets[k, 0], row + offsets[k, 1]
            if c < 0 or r < 0 or c >= columns or r >= rows or blocked[r, c] or visited[r, c] == mark:
                continue
            corner[2, 0], corner[2, 1] = c + 0.5, r + 0.5
            if n > 1 and not turns(blocked, room, corner, radius):
                continue
            if not is_free(blocked, x, y, c + 0.5, r + 0.5):
                continue
            onward[0, 0], onward[0, 1], onward[1, 0], onward[1, 1] = x, y, c + 0.5, r + 0.5
            if not leads_on(blocked, room, onward, goal, offsets, radius):
                continue
            to[count, 0], to[count, 1] = c, r
            dx, dy = goal[0] - c - 0.5, goal[1] - r - 0.5
            eta[count] = 1.0 / max(math.sqrt(dx * dx + dy * dy), 0.5)
            count += 1
        if count == 0:
            return n, False
        limit = eta_limit(eta[:count], bias)
        for k in range(count):
            weight[k] = max(attraction[to[k, 1], to[k, 0]], TRACE) if eta[k] >= limit else 0.0
        chosen = roulette(eta[:count], weight[:count], alpha, beta, dice)
        length += math.hypot(to[chosen, 0] + 0.5 - x, to[chosen, 1] + 0.5 - y)
        x, y = to[chosen, 0] + 0.5, to[chosen, 1] + 0.5
        nodes[n, 0], nodes[n, 1] = x, y
        n += 1
        if length + math.hypot(goal[0] - x, goal[1] - y) > longest or n + 1 >= len(nodes):
            return n, False


@kernel
def prune_turning(
    blocked: Bools, room: Floats, nodes: Floats, longest: int, shortest: int, decay: float, radius: float
) -> Floats:
    """`prune`, but only where the corners at both ends can still be rounded with `radius` [cells]."""
    kept, n, rounds = np.empty_like(nodes), len(nodes), 0
    for i in range(n):
        kept[i, 0], kept[i, 1] = nodes[i, 0], nodes[i, 1]
    while True:
        step = math.floor(longest * decay**rounds)
        if step < shortest:
            return kept[:n]
        at, count = 0, 1
        while at < n - 1:
            far = min(at + step, n - 1)
            # Row count - 1 holds the node at `at`, the row before it the one kept before
            if (
                far > at + 1
                and is_free(blocked, kept[at, 0], kept[at, 1], kept[far, 0], kept[far, 1])
                and (count == 1 or _turns(blocked, room, kept, count - 2, at, far, radius))
                and (far == n - 1 or _turns(blocked, room, kept, at, far, far + 1, radius))
            ):
                at = far
            else:
                at += 1
            kept[count, 0], kept[count, 1] = kept[at, 0], kept[at, 1]
            count += 1
        n = count
        rounds += 1


@kernel
def _turns(blocked: Bools, room: Floats, nodes: Floats, a: int, b: int, c: int, radius: float) -> bool:
    corner = np.empty((3, 2))
    for axis in range(2):
        corner[0, axis], corner[1, axis], corner[2, axis] = nodes[a, axis], nodes[b, axis], nodes[c, axis]
    return turns(blocked, room, corner, radius)
