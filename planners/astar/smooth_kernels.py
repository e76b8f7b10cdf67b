"""Kernels that linearise what a smooth path must keep to, for shifts of its points along their normals."""

from __future__ import annotations

import math

import numpy as np

from planners.astar.room_kernels import room_at
from planners.kernel import Floats, Ints, kernel

BAND = 4  # points on which a change of curvature depends


@kernel
def normals(points: Floats) -> Floats:
    """Unit vectors (N, 2) to the left of the path at its points (N, 2); none at its two ends, which stay."""
    left = np.zeros_like(points)
    for i in range(1, len(points) - 1):
        dx, dy = points[i + 1, 0] - points[i - 1, 0], points[i + 1, 1] - points[i - 1, 1]
        far = math.hypot(dx, dy)
        left[i, 0], left[i, 1] = -dy / far, dx / far
    return left


@kernel
def bends(points: Floats, left: Floats, before: Floats, after: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Curvatures (N,) [1/m] and their changes (N - 1,) [1/m^2], and how both move with shifts (N,) along `left` (N, 2).

    The first are heading change over the mean of the two legs, linear in the shifts of points i - 1, i and i + 1 by the
    rows (N, 3); the second, of curvatures i and i + 1, in those of points i - 1 to i + 2 by the rows (N - 1, 4). At an
    end the curvature is 0, unless the heading there is given: by a point (1, 2) `before` the first or `after` the last.
    """
    n = len(points)
    curvature, by_shift = np.zeros(n), np.zeros((n, 3))
    legs = np.empty(n - 1)
    for i in range(n - 1):
        legs[i] = math.hypot(points[i + 1, 0] - points[i, 0], points[i + 1, 1] - points[i, 1])
    for i in range(n):
        if (i == 0 and len(before) == 0) or (i == n - 1 and len(after) == 0):
            continue
        x0, y0 = (before[0, 0], before[0, 1]) if i == 0 else (points[i - 1, 0], points[i - 1, 1])
        x2, y2 = (after[0, 0], after[0, 1]) if i == n - 1 else (points[i + 1, 0], points[i + 1, 1])
        ax, ay, bx, by = points[i, 0] - x0, points[i, 1] - y0, x2 - points[i, 0], y2 - points[i, 1]
        aa, bb = ax * ax + ay * ay, bx * bx + by * by
        mean = 0.5 * (math.sqrt(aa) + math.sqrt(bb))
        curvature[i] = math.atan2(ax * by - ay * bx, ax * bx + ay * by) / mean
        # A leg's heading turns by the normal component of its ends' motion over its length, and the tangential one
        # makes it longer, and the curvature as much smaller
        a, b, less = math.sqrt(aa), math.sqrt(bb), 0.5 * curvature[i]
        px, py = -ay / aa + less * ax / a, ax / aa + less * ay / a
        qx, qy = -by / bb - less * bx / b, bx / bb - less * by / b
        if i > 0:
            by_shift[i, 0] = (px * left[i - 1, 0] + py * left[i - 1, 1]) / mean
        by_shift[i, 1] = -((px + qx) * left[i, 0] + (py + qy) * left[i, 1]) / mean
        if i < n - 1:
            by_shift[i, 2] = (qx * left[i + 1, 0] + qy * left[i + 1, 1]) / mean
    change, changes_by = np.empty(n - 1), np.zeros((n - 1, BAND))
    for i in range(n - 1):
        change[i] = (curvature[i + 1] - curvature[i]) / legs[i]
        for k in range(3):
            changes_by[i, k] -= by_shift[i, k] / legs[i]
            changes_by[i, k + 1] += by_shift[i + 1, k] / legs[i]
        tx, ty = (points[i + 1, 0] - points[i, 0]) / legs[i], (points[i + 1, 1] - points[i, 1]) / legs[i]
        changes_by[i, 1] += change[i] * (tx * left[i, 0] + ty * left[i, 1]) / legs[i]
        changes_by[i, 2] -= change[i] * (tx * left[i + 1, 0] + ty * left[i + 1, 1]) / legs[i]
    return curvature, by_shift, change, changes_by


@kernel
def contacts(
    points: Floats, left: Floats, field: Floats, cell: float, size: Floats, along: Floats, radius: float, near: float
) -> tuple[Ints, Floats, Floats]:  # fmt: skip
    """Where the body comes within `near` [m] of `radius`: points (M,), what room is left (M,) [m], and how it moves.

    That is linear in the shifts of points i - 1, i and i + 1, by the rows (M, 3): a disc `along` the body swings with
    the heading. The last rows are of points as near as that to the edge, of which only they themselves keep clear.
    """
    n = len(points)
    most = n * (len(along) + 4)  # the sides of the map, too
    at, left_over, by_shift = np.empty(most, dtype=np.int64), np.empty(most), np.zeros((most, 3))
    count = 0
    for i in range(n):
        before, after = max(i - 1, 0), min(i + 1, n - 1)
        tx, ty = points[after, 0] - points[before, 0], points[after, 1] - points[before, 1]
        span = math.hypot(tx, ty)
        tx, ty = tx / span, ty / span
        for k in range(len(along)):
            x, y = points[i, 0] + along[k] * tx, points[i, 1] + along[k] * ty
            room = room_at(field, cell, x, y) - radius
            if room > near:
                continue
            gx = (room_at(field, cell, x + cell, y) - room_at(field, cell, x - cell, y)) / (2.0 * cell)
            gy = (room_at(field, cell, x, y + cell) - room_at(field, cell, x, y - cell)) / (2.0 * cell)
            swing = (tx * gy - ty * gx) * along[k] / span
            at[count], left_over[count] = i, room
            by_shift[count, 1] = gx * left[i, 0] + gy * left[i, 1]
            by_shift[count, before - i + 1] -= swing * (tx * left[before, 1] - ty * left[before, 0])
            by_shift[count, after - i + 1] += swing * (tx * left[after, 1] - ty * left[after, 0])
            count += 1
        for axis in range(2):
            for side in range(2):
                sign = 1.0 - 2.0 * side
                room = sign * points[i, axis] + side * size[axis]
                if room <= near:
                    at[count], left_over[count] = i, room
                    by_shift[count, 1] = sign * left[i, axis]
                    count += 1
    return at[:count], left_over[:count], by_shift[:count]
