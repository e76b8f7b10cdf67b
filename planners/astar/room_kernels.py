"""Kernels that ask whether a body fits: at a pose, and along an arc. Positions are from the grid's corner [m]."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Floats, kernel

SPACING = 0.5  # [m] between the poses at which an arc is looked at


@kernel
def room_at(field: Floats, cell: float, x: float, y: float) -> float:
    """The `field` (rows, cols) [m] at (`x`, `y`), linear between the cells' centres; beyond them that of the edge."""
    rows, columns = field.shape
    u = min(max(x / cell - 0.5, 0.0), columns - 1.0)
    v = min(max(y / cell - 0.5, 0.0), rows - 1.0)
    column, row = min(int(u), columns - 2), min(int(v), rows - 2)
    a, b = u - column, v - row
    south = field[row, column] * (1.0 - a) + field[row, column + 1] * a
    north = field[row + 1, column] * (1.0 - a) + field[row + 1, column + 1] * a
    between: float = south * (1.0 - b) + north * b
    return between


@kernel
def fits(
    field: Floats, cell: float, size: Floats, along: Floats, radius: float, x: float, y: float, heading: float
) -> bool:
    """Whether the discs of `radius` [m], `along` (D,) [m] ahead, are free, and the reference point on the map."""
    if x < 0.0 or y < 0.0 or x > size[0] or y > size[1]:
        return False
    ahead, left = math.cos(heading), math.sin(heading)
    for k in range(len(along)):  # noqa: SIM110, numba compiles no generator
        if room_at(field, cell, x + along[k] * ahead, y + along[k] * left) < radius:
            return False
    return True


@kernel
def along_arc(x: float, y: float, heading: float, curvature: float, s: float) -> tuple[float, float, float]:
    """The pose (x, y, heading) after `s` [m] on the arc of `curvature` [1/m] that starts at a pose."""
    half = 0.5 * curvature * s
    chord = s if abs(half) < 1e-9 else s * math.sin(half) / half
    return x + chord * math.cos(heading + half), y + chord * math.sin(heading + half), heading + curvature * s


@kernel
def drawn(nodes: Floats, spacing: float) -> Floats:
    """Points (N, 2) at most `spacing` [m] apart on the arcs between `nodes` (M, 5).

    A node is x, y, heading, the way to it, and the curvature of the arc that ends there.
    """
    total = 1
    for i in range(1, len(nodes)):
        total += math.ceil((nodes[i, 3] - nodes[i - 1, 3]) / spacing)
    points = np.empty((total, 2))
    points[0] = nodes[0, :2]
    k = 1
    for i in range(1, len(nodes)):
        length = nodes[i, 3] - nodes[i - 1, 3]
        count = math.ceil(length / spacing)
        for j in range(1, count):
            x, y, _ = along_arc(nodes[i - 1, 0], nodes[i - 1, 1], nodes[i - 1, 2], nodes[i, 4], length * j / count)
            points[k, 0], points[k, 1] = x, y
            k += 1
        points[k] = nodes[i, :2]
        k += 1
    return points


@kernel
def arc_fits(
    field: Floats, cell: float, size: Floats, along: Floats, radius: float, middle: float, around: float,
    x: float, y: float, heading: float, curvature: float, length: float,
) -> bool:  # fmt: skip
    """Whether the body fits all along an arc of `length` [m], but for its start; one look is enough in the open.

    A disc of `around` [m] at `middle` [m] ahead holds the body.
    """
    far_x, far_y, far = along_arc(x, y, heading, curvature, length)
    if not fits(field, cell, size, along, radius, far_x, far_y, far):
        return False
    near_x, near_y, near = along_arc(x, y, heading, curvature, 0.5 * length)
    # No pose is farther along than half of the arc, and turning about the reference point moves the middle no more
    reach = around + 0.5 * length * (1.0 + abs(curvature * middle))
    inside = min(near_x, near_y, size[0] - near_x, size[1] - near_y) > 0.5 * length
    if inside and room_at(field, cell, near_x + middle * math.cos(near), near_y + middle * math.sin(near)) > reach:
        return True
    count = math.ceil(length / SPACING)
    for i in range(1, count):
        at_x, at_y, at = along_arc(x, y, heading, curvature, length * i / count)
        if not fits(field, cell, size, along, radius, at_x, at_y, at):
            return False
    return True
