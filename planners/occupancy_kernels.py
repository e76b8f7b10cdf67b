"""Kernels that find the cells of a polygon, in units of cells."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, kernel

SNAP = 1e-9  # [cells] a border this near to a grid line lies on it, whatever rounding says


@kernel
def block_inside(inside: Bools, ring: Floats) -> None:
    """Mark the cells whose centre lies inside the polygon `ring` (N, 2), by the even-odd rule along each row."""
    rows, columns = inside.shape
    n = len(ring)
    cuts = np.empty(n)
    south, north = math.inf, -math.inf
    for i in range(n):
        south, north = min(south, ring[i, 1]), max(north, ring[i, 1])
    for row in range(max(math.floor(south), 0), min(math.ceil(north), rows)):
        y, count = row + 0.5, 0
        for i in range(n):
            x0, y0, x1, y1 = ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1]
            if (y0 > y) != (y1 > y):
                cuts[count] = x0 + (y - y0) / (y1 - y0) * (x1 - x0)
                count += 1
        sort(cuts, count)
        for i in range(0, count - 1, 2):
            # Centres column + 0.5 between the two cuts
            for column in range(max(math.ceil(cuts[i] - 0.5), 0), min(math.ceil(cuts[i + 1] - 0.5), columns)):
                inside[row, column] = True


@kernel
def block_edges(hit: Bools, ring: Floats) -> None:
    """Mark the cells that the polygon's edges pass through; along a grid line is not through.

    The grid lines cut an edge into pieces, and each piece lies in the cell of its middle.
    """
    rows, columns = hit.shape
    for i in range(len(ring)):
        x0, y0, x1, y1 = ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1]
        dx, dy = x1 - x0, y1 - y0
        length = math.hypot(dx, dy)
        low_x, high_x = math.floor(min(x0, x1)) + 1, math.ceil(max(x0, x1))
        low_y, high_y = math.floor(min(y0, y1)) + 1, math.ceil(max(y0, y1))
        cuts = np.empty(2 + max(high_x - low_x, 0) + max(high_y - low_y, 0))
        cuts[0], cuts[1], count = 0.0, 1.0, 2
        for line in range(low_x, high_x):
            cuts[count] = (line - x0) / dx
            count += 1
        for line in range(low_y, high_y):
            cuts[count] = (line - y0) / dy
            count += 1
        sort(cuts, count)
        for k in range(count - 1):
            if (cuts[k + 1] - cuts[k]) * length <= SNAP:
                continue
            middle = (cuts[k] + cuts[k + 1]) / 2.0
            x, y = x0 + middle * dx, y0 + middle * dy
            on_line = abs(x - round(x)) <= SNAP or abs(y - round(y)) <= SNAP
            column, row = math.floor(x), math.floor(y)
            if not on_line and 0 <= row < rows and 0 <= column < columns:
                hit[row, column] = True


@kernel
def sort(values: Floats, count: int) -> None:
    """Sort the first `count` values in place, by insertion: there are few, and numpy's takes seconds to compile."""
    for i in range(1, count):
        value, k = values[i], i
        while k > 0 and values[k - 1] > value:
            values[k] = values[k - 1]
            k -= 1
        values[k] = value
