"""Kernels on straight segments over a grid of cells, in units of cells: column x, row y."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, Ints, kernel


@kernel
def _lines(start: float, end: float) -> tuple[int, float, float]:
    """In one axis: the way to the next cell, the share of the segment between grid lines, and that up to the first."""
    span, cell = end - start, math.floor(start)
    if span == 0.0:
        return 1, math.inf, math.inf
    if span > 0.0:
        return 1, 1.0 / span, (cell + 1 - start) / span
    return -1, -1.0 / span, (cell - start) / span


@kernel
def is_free(blocked: Bools, x0: float, y0: float, x1: float, y1: float) -> bool:
    """Whether the segment meets no blocked cell and stays on the grid.

    Exact (Amanatides and Woo 1987): every cell that it passes through is looked at, and where it passes through a
    corner, both cells beside it too, so that nothing slips between two blocked cells that touch.
    """
    rows, columns = blocked.shape
    column, row = math.floor(x0), math.floor(y0)
    if column < 0 or row < 0 or column >= columns or row >= rows or blocked[row, column]:
        return False
    step_x, per_x, next_x = _lines(x0, x1)
    step_y, per_y, next_y = _lines(y0, y1)
    left = abs(math.floor(x1) - column) + abs(math.floor(y1) - row)
    while left > 0:
        if abs(next_x - next_y) < 1e-9 and left > 1:
            beside = column + step_x
            if beside < 0 or beside >= columns or blocked[row, beside]:
                return False
            above = row + step_y
            if above < 0 or above >= rows or blocked[above, column]:
                return False
            column, row = beside, above
            next_x += per_x
            next_y += per_y
            left -= 2
        elif next_x < next_y:
            column += step_x
            next_x += per_x
            left -= 1
        else:
            row += step_y
            next_y += per_y
            left -= 1
        if column < 0 or row < 0 or column >= columns or row >= rows or blocked[row, column]:
            return False
    return True


@kernel
def cells_of(x0: float, y0: float, x1: float, y1: float, found: Ints) -> int:
    """How many cells, column and row, the segment passes through after its first; they are put in `found` (N, 2)."""
    column, row = math.floor(x0), math.floor(y0)
    step_x, per_x, next_x = _lines(x0, x1)
    step_y, per_y, next_y = _lines(y0, y1)
    count = abs(math.floor(x1) - column) + abs(math.floor(y1) - row)
    for i in range(count):
        if next_x < next_y:
            column += step_x
            next_x += per_x
        else:
            row += step_y
            next_y += per_y
        found[i, 0], found[i, 1] = column, row
    return count


@kernel
def polyline_length(nodes: Floats) -> float:
    """Length of `nodes` (N, 2)."""
    total = 0.0
    for i in range(1, len(nodes)):
        total += math.hypot(nodes[i, 0] - nodes[i - 1, 0], nodes[i, 1] - nodes[i - 1, 1])
    return total


@kernel
def without_needless(blocked: Bools, nodes: Floats, step: int) -> Floats:
    """`nodes` (N, 2) without those between any node and the one `step` farther on, where the straight line is free."""
    kept = np.empty_like(nodes)
    kept[0, 0], kept[0, 1] = nodes[0, 0], nodes[0, 1]
    n, at, count = len(nodes), 0, 1
    while at < n - 1:
        far = min(at + step, n - 1)
        if far > at + 1 and is_free(blocked, nodes[at, 0], nodes[at, 1], nodes[far, 0], nodes[far, 1]):
            at = far
        else:
            at += 1
        kept[count, 0], kept[count, 1] = nodes[at, 0], nodes[at, 1]
        count += 1
    return kept[:count]
