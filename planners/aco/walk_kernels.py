"""Kernels of the improved colony: how an ant walks, and how its way is pruned; in units of cells."""

from __future__ import annotations

import math

import numpy as np

from planners.aco.roulette_kernels import TRACE, Dice, eta_limit, roulette
from planners.kernel import Bools, Floats, Ints, kernel
from planners.segments import is_free, without_needless


def ring(step: int, sampling: int) -> Ints:
    """The cells (K, 2), column and row, of the square ring `step` cells away, sampled from its corners to the middles
    of its sides every `sampling` cells (paper 000, 2.1).

    Eq. 7 counts 48 for step 8 and sampling 2; those are 32 cells, each corner and each middle counted twice. They
    come in the order of their bearing.
    """
    half = np.arange(0, step + 1, sampling)
    along = np.unique(np.concatenate([half - step, step - half]))
    cells = [(a, b) for a in along for b in along if max(abs(a), abs(b)) == step]
    return np.array(sorted(cells, key=lambda cell: math.atan2(cell[1], cell[0])), dtype=np.int64)


@kernel
def reach_of(offsets: Ints) -> int:
    """How many cells the ring is away."""
    reach = 0
    for k in range(len(offsets)):
        reach = max(reach, abs(offsets[k, 0]), abs(offsets[k, 1]))
    return reach


@kernel
def walk(
    blocked: Bools, alert: Bools, attraction: Floats, dice: Dice, start: Floats, goal: Floats, offsets: Ints,
    alpha: float, beta: float, bias: float, longest: float, visited: Ints, mark: int, nodes: Floats,
) -> tuple[int, bool]:  # fmt: skip
    """One ant from `start` towards `goal`; how many of the rows of `nodes` it filled, and whether it arrived.

    `offsets` (K, 2) lead to the cells it may step to, `attraction` is their pheromone. It steps on no cell of its tabu
    list, which are those in `visited` that hold `mark`, and dies where it cannot step at all, or where even the
    straight way to the goal would be beyond `longest`. Where neither it nor the next cell is in the `alert` zone, no
    obstacle can be between.
    """
    rows, columns = blocked.shape
    reach = reach_of(offsets)
    eta, weight = np.empty(len(offsets)), np.empty(len(offsets))
    to, checked = np.empty((len(offsets), 2), np.int64), np.empty(len(offsets), np.bool_)
    x, y, length, n = start[0], start[1], 0.0, 1
    nodes[0, 0], nodes[0, 1] = x, y
    while True:
        column, row = int(x), int(y)
        visited[row, column] = mark
        home = math.hypot(goal[0] - x, goal[1] - y)
        if max(abs(goal[0] - x), abs(goal[1] - y)) <= reach and is_free(blocked, x, y, goal[0], goal[1]):
            nodes[n, 0], nodes[n, 1] = goal[0], goal[1]
            return n + 1, length + home <= longest
        count = 0
        for k in range(len(offsets)):
            c, r = column + offsets[k, 0], row + offsets[k, 1]
            if c < 0 or r < 0 or c >= columns or r >= rows or blocked[r, c] or visited[r, c] == mark:
                continue
            to[count, 0], to[count, 1] = c, r
            dx, dy = goal[0] - c - 0.5, goal[1] - r - 0.5
            eta[count] = 1.0 / math.sqrt(max(dx * dx + dy * dy, 0.25))  # eq. 9
            checked[count] = not (alert[row, column] or alert[r, c])
            count += 1
        # Eq. 8 needs the nearest and the farthest that can be reached; what is below its limit is not looked at
        count = _until_free(blocked, x, y, to, eta, checked, count, 1.0)
        if count == 0:
            return n, False
        count = _until_free(blocked, x, y, to, eta, checked, count, -1.0)
        limit = eta_limit(eta[:count], bias)
        for k in range(count):
            c, r = to[k, 0], to[k, 1]
            within = eta[k] >= limit and (checked[k] or is_free(blocked, x, y, c + 0.5, r + 0.5))
            weight[k] = max(attraction[r, c], TRACE) if within else 0.0
        chosen = roulette(eta[:count], weight[:count], alpha, beta, dice)
        length += math.hypot(to[chosen, 0] + 0.5 - x, to[chosen, 1] + 0.5 - y)
        x, y = to[chosen, 0] + 0.5, to[chosen, 1] + 0.5
        nodes[n, 0], nodes[n, 1] = x, y
        n += 1
        if length + math.hypot(goal[0] - x, goal[1] - y) > longest or n + 1 >= len(nodes):
            return n, False


@kernel
def _until_free(
    blocked: Bools, x: float, y: float, to: Ints, eta: Floats, checked: Bools, count: int, sign: float
) -> int:  # fmt: skip
    """Take out of the first `count` cells `to` (K, 2) those that cannot be reached, until the one with the greatest
    (`sign` 1) or least (-1) heuristic can be; how many remain.
    """
    while count > 0:
        first = 0
        for k in range(1, count):
            if sign * eta[k] > sign * eta[first]:
                first = k
        if not checked[first]:
            checked[first] = is_free(blocked, x, y, to[first, 0] + 0.5, to[first, 1] + 0.5)
        if checked[first]:
            return count
        count -= 1
        to[first, 0], to[first, 1] = to[count, 0], to[count, 1]
        eta[first], checked[first] = eta[count], checked[count]
    return 0


@kernel
def prune(blocked: Bools, nodes: Floats, longest: int, shortest: int, decay: float) -> Floats:
    """Leave out nodes wherever the straight line is free, in rounds with steps that shrink (paper 000, eq. 11)."""
    kept, rounds = nodes, 0
    while True:
        step = math.floor(longest * decay**rounds)
        if step < shortest:
            return kept
        kept = without_needless(blocked, kept, step)
        rounds += 1
