"""Kernels of the improved colony: how an ant walks, and how its way is pruned; in units of cells."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, Ints, kernel
from planners.segments import is_free

Rng = np.random.Generator


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
def walk(
    blocked: Bools, alert: Bools, attraction: Floats, rng: Rng, start: Floats, goal: Floats, offsets: Ints,
    alpha: float, beta: float, bias: float, longest: float, visited: Ints, mark: int, nodes: Floats,
) -> tuple[int, bool]:  # fmt: skip
    """One ant from `start` towards `goal`; how many of the rows of `nodes` it filled, and whether it arrived.

    `offsets` (K, 2) lead to the cells it may step to, `attraction` is their pheromone. It steps on no cell of its tabu
    list, which are those in `visited` that hold `mark`, and dies beyond `longest` or where it cannot step at all.
    Where neither it nor the next cell is in the `alert` zone, no obstacle can be between.
    """
    rows, columns = blocked.shape
    reach = np.abs(offsets).max()
    eta, weight = np.empty(len(offsets)), np.empty(len(offsets))
    to = np.empty((len(offsets), 2), np.int64)
    x, y, length, n = start[0], start[1], 0.0, 1
    nodes[0, 0], nodes[0, 1] = x, y
    while True:
        column, row = int(x), int(y)
        visited[row, column] = mark
        home = math.hypot(goal[0] - x, goal[1] - y)
        if max(abs(goal[0] - x), abs(goal[1] - y)) <= reach and is_free(blocked, x, y, goal[0], goal[1]):
            nodes[n, 0], nodes[n, 1] = goal
            return n + 1, length + home <= longest
        count = 0
        for k in range(len(offsets)):
            c, r = column + offsets[k, 0], row + offsets[k, 1]
            if c < 0 or r < 0 or c >= columns or r >= rows or blocked[r, c] or visited[r, c] == mark:
                continue
            if (alert[row, column] or alert[r, c]) and not is_free(blocked, x, y, c + 0.5, r + 0.5):
                continue
            to[count, 0], to[count, 1] = c, r
            dx, dy = goal[0] - c - 0.5, goal[1] - r - 0.5
            eta[count] = 1.0 / max(math.sqrt(dx * dx + dy * dy), 0.5)  # eq. 9
            count += 1
        if count == 0:
            return n, False
        limit = eta_limit(eta[:count], bias)
        for k in range(count):
            weight[k] = attraction[to[k, 1], to[k, 0]] if eta[k] >= limit else 0.0
        chosen = roulette(eta[:count], weight[:count], alpha, beta, rng)
        length += math.hypot(to[chosen, 0] + 0.5 - x, to[chosen, 1] + 0.5 - y)
        x, y = to[chosen, 0] + 0.5, to[chosen, 1] + 0.5
        nodes[n, 0], nodes[n, 1] = x, y
        n += 1
        if length > longest or n + 1 >= len(nodes):
            return n, False


@kernel
def eta_limit(eta: Floats, bias: float) -> float:
    """The least heuristic that the biased roulette takes (eq. 8)."""
    low, high = math.inf, 0.0
    for value in eta:
        low, high = min(low, value), max(high, value)
    return low + bias * (high - low)


@kernel
def roulette(eta: Floats, weight: Floats, alpha: float, beta: float, rng: Rng) -> int:
    """One of those with any pheromone in `weight` (K,), by the probability of eq. 1; `weight` is overwritten."""
    strongest, nearest, total = weight.max(), eta.max(), 0.0
    for k in range(len(eta)):
        if weight[k] > 0.0:
            weight[k] = power(weight[k] / strongest, alpha) * power(eta[k] / nearest, beta)
            total += weight[k]
    left = rng.random() * total
    last = 0
    for k in range(len(eta)):
        if weight[k] > 0.0:
            left -= weight[k]
            last = k
            if left < 0.0:
                break
    return last


@kernel
def power(base: float, exponent: float) -> float:
    """base ** exponent; by products where the exponent is a small whole number, which is many times as fast."""
    if exponent != math.floor(exponent) or exponent > 16.0:
        return float(base**exponent)
    product = 1.0
    for _ in range(int(exponent)):
        product *= base
    return product


@kernel
def prune(blocked: Bools, nodes: Floats, longest: int, shortest: int, decay: float) -> Floats:
    """Leave out nodes wherever the straight line is free, in rounds with steps that shrink (paper 000, eq. 11)."""
    kept, n, rounds = nodes.copy(), len(nodes), 0
    while True:
        step = math.floor(longest * decay**rounds)
        if step < shortest:
            return kept[:n].copy()
        at, count = 0, 1
        while at < n - 1:
            far = min(at + step, n - 1)
            if far > at + 1 and is_free(blocked, kept[at, 0], kept[at, 1], kept[far, 0], kept[far, 1]):
                at = far
            else:
                at += 1
            kept[count] = kept[at]
            count += 1
        n = count
        rounds += 1
