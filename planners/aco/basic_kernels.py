"""Kernels of the basic colony: an ant among the 8 neighbours of its cell, pheromone on the ways between cells."""

from __future__ import annotations

import math

import numpy as np

from planners.aco.roulette_kernels import TRACE, Dice, roulette
from planners.kernel import Bools, Floats, Ints, kernel

NEIGHBOURS = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)])  # i + 4: the way back


@kernel
def walk_basic(
    blocked: Bools, trail: Floats, dice: Dice, start: Ints, goal: Ints, alpha: float, beta: float, to_goal: bool,
    floor: float, longest: float, visited: Ints, mark: int, cells: Ints,
) -> tuple[int, bool]:  # fmt: skip
    """One ant from the cell `start` to `goal` (2,), column and row; how many of the rows of `cells` it filled, and
    whether it arrived.

    `trail` (rows, cols, 8) is the pheromone on the way to each neighbour. The heuristic of a neighbour is 1 over its
    distance from the ant, as eq. 1 is printed, or with `to_goal` 1 over its distance from the goal, normalised over
    the open neighbours to between `floor` and 1.
    """
    rows, columns = blocked.shape
    eta, weight = np.empty(8), np.empty(8)
    column, row, length, n = start[0], start[1], 0.0, 1
    cells[0] = start
    while column != goal[0] or row != goal[1]:
        visited[row, column] = mark
        low, high = math.inf, 0.0
        for k in range(8):
            c, r = column + NEIGHBOURS[k, 0], row + NEIGHBOURS[k, 1]
            weight[k] = 0.0
            if c < 0 or r < 0 or c >= columns or r >= rows or blocked[r, c] or visited[r, c] == mark:
                continue
            if k % 2 == 1 and (blocked[row, c] or blocked[r, column]):  # it would cut the corner of a blocked cell
                continue
            weight[k] = max(trail[row, column, k], TRACE)
            apart = math.hypot(goal[0] - c, goal[1] - r) if to_goal else math.sqrt(1.0 + k % 2)
            eta[k] = 1.0 / max(apart, 0.5)
            low, high = min(low, eta[k]), max(high, eta[k])
        if high == 0.0:
            return n, False
        for k in range(8):
            if weight[k] == 0.0:
                eta[k] = 0.0
            elif to_goal:
                eta[k] = floor + (1.0 - floor) * (eta[k] - low) / (high - low) if high > low else 1.0
        chosen = roulette(eta, weight, alpha, beta, dice)
        column, row = column + NEIGHBOURS[chosen, 0], row + NEIGHBOURS[chosen, 1]
        length += math.sqrt(1.0 + chosen % 2)
        cells[n, 0], cells[n, 1] = column, row
        n += 1
        if length + math.hypot(goal[0] - column, goal[1] - row) > longest or n >= len(cells):
            return n, False
    return n, True


@kernel
def lay_on_ways(laid: Floats, amount: float, cells: Ints) -> None:
    """Add `amount` to the ways between the `cells` (N, 2), in both directions (eq. 2 and 3)."""
    for i in range(1, len(cells)):
        dx, dy = cells[i, 0] - cells[i - 1, 0], cells[i, 1] - cells[i - 1, 1]
        for k in range(8):
            if NEIGHBOURS[k, 0] == dx and NEIGHBOURS[k, 1] == dy:
                laid[cells[i - 1, 1], cells[i - 1, 0], k] += amount
                laid[cells[i, 1], cells[i, 0], (k + 4) % 8] += amount
