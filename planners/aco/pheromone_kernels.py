"""Kernels of pheromone: laid on cells, seen as the regional equivalent of eq. 10 in paper 000."""

from __future__ import annotations

import numpy as np

from planners.kernel import Floats, Ints, kernel
from planners.segments import cells_of


def region(radius: int, factor: float) -> Floats:
    """The weights (2 radius + 1, 2 radius + 1) of eq. 10: factor^m in the m-th square layer about the cell."""
    layer = np.abs(np.indices((2 * radius + 1, 2 * radius + 1)) - radius).max(axis=0)
    return np.asarray(np.where(layer == 0, 1.0, factor ** layer.astype(float)))


@kernel
def lay_along(laid: Floats, touched: Ints, count: int, amount: float, nodes: Floats, nodes_only: bool) -> int:
    """Add `amount` to the cells of the way `nodes` (N, 2), or of its nodes only; the start's own cell apart.

    The first `count` rows of `touched` (N, 2), column and row, hold the cells where something lies; how many now do.
    """
    passed = np.empty((laid.shape[0] + laid.shape[1], 2), np.int64)
    for i in range(1, len(nodes)):
        if nodes_only:
            cells, passed[0, 0], passed[0, 1] = 1, int(nodes[i, 0]), int(nodes[i, 1])
        else:
            cells = cells_of(nodes[i - 1, 0], nodes[i - 1, 1], nodes[i, 0], nodes[i, 1], passed)
        for k in range(cells):
            column, row = passed[k, 0], passed[k, 1]
            if laid[row, column] == 0.0:
                touched[count, 0], touched[count, 1] = column, row
                count += 1
            laid[row, column] += amount
    return count


@kernel
def evaporate_and_lay(
    seen: Floats, laid: Floats, touched: Ints, count: int, evaporation: float, weights: Floats
) -> None:  # fmt: skip
    """Eq. 4 for what the ants see: `seen` is linear in the pheromone, so it is kept up to date instead of that.

    `laid` is emptied where it was `touched`.
    """
    rows, columns = seen.shape
    radius = len(weights) // 2
    for row in range(rows):
        for column in range(columns):
            seen[row, column] *= 1.0 - evaporation
    for n in range(count):
        column, row = touched[n, 0], touched[n, 1]
        amount = laid[row, column]
        laid[row, column] = 0.0
        for i in range(max(row - radius, 0), min(row + radius + 1, rows)):
            for k in range(max(column - radius, 0), min(column + radius + 1, columns)):
                seen[i, k] += amount * weights[i - row + radius, k - column + radius]
