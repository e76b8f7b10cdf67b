"""Kernels on a border of polygons: its reflex corners, and which of them a point sees along tangents.

The border is an array of points (N, 2) [m] with the index of the one `before` and `after` each (N,), the free area on
the left; the last two are start and goal, which are on no border and are their own neighbours. What is within `noise`
[m] of a line is on it, for rounding moves vertices by that. So a line that meets vertices between its ends need not
count as free: it is made of shorter lines that do.
"""

from __future__ import annotations

import numpy as np

from planners.kernel import Bools, Floats, Ints, kernel


@kernel
def reflex(points: Floats, before: Ints, after: Ints, noise: float) -> Bools:
    """Which corners (N,) a line may bend at: those that turn right, or not by more than `noise` [m], and both ends."""
    bends = np.ones(len(points), np.bool_)
    for i in range(len(points) - 2):
        bends[i] = _side(points[before[i]], points[i], points[after[i]], noise) <= 0.0
    return bends


@kernel
def seen(source: int, within: Floats, points: Floats, before: Ints, after: Ints, noise: float) -> Ints:
    """The points that the one of index `source` sees along tangents, each nearer than `within` (N,) [m]."""
    n = len(points)
    x, y = points[source]
    bearing = np.empty(n)
    found = np.empty(n, np.int64)
    count = 0
    for i in range(n):
        dx, dy = points[i, 0] - x, points[i, 1] - y
        if i == source:
            continue
        bearing[i] = _bearing(dx, dy)
        if np.sqrt(dx * dx + dy * dy) < within[i] and _tangent(source, i, points, before, after, noise):
            found[count] = i
            count += 1
    found = found[:count][np.argsort(bearing[found[:count]])]
    around = np.concatenate((bearing[found], bearing[found] + 4.0))
    hidden = np.zeros(count, np.bool_)
    for a in range(n - 2):
        b = after[a]
        if a == source or b == source:
            continue
        low, high = min(bearing[a], bearing[b]), max(bearing[a], bearing[b])
        if high - low > 2.0:
            low, high = high, low + 4.0
        elif low < 1.0:
            low, high = low + 4.0, high + 4.0
        k = np.searchsorted(around, low - 1e-9)
        while k < 2 * count and around[k] <= high + 1e-9:
            i = k % count
            q = found[i]
            if not hidden[i] and q != a and q != b:
                hidden[i] = _crosses(points[source], points[q], points[a], points[b], noise)
            k += 1
    return found[~hidden]


@kernel
def _bearing(dx: float, dy: float) -> float:
    """A number from 0 to 4 that grows with the bearing from east by north, and by 2 with each half turn."""
    east = dx / (abs(dx) + abs(dy))
    return 1.0 - east if dy >= 0.0 else 3.0 + east


@kernel
def _tangent(a: int, b: int, points: Floats, before: Ints, after: Ints, noise: float) -> bool:
    """Whether the line between two points has each one's neighbours on the border on one side.

    A line that runs along an edge must end with it or before.
    """
    for here, there in ((a, b), (b, a)):
        sides = 1.0
        for k in (before[here], after[here]):
            side = _side(points[there], points[here], points[k], noise)
            if side == 0.0 and k != here:
                dx, dy = points[there, 0] - points[here, 0], points[there, 1] - points[here, 1]
                x, y = points[k, 0] - points[here, 0], points[k, 1] - points[here, 1]
                if dx * x + dy * y > 0.0 and np.hypot(x, y) + noise < np.hypot(dx, dy):
                    return False
            sides *= side
        if sides < 0.0:
            return False
    return True


@kernel
def _side(a: Floats, b: Floats, c: Floats, noise: float) -> float:
    """Twice the area of the triangle a, b, c, positive if it turns left; 0 if it is as flat as `noise` [m]."""
    ax, ay, bx, by = b[0] - a[0], b[1] - a[1], c[0] - b[0], c[1] - b[1]
    area = float(ax * by - ay * bx)
    if abs(area) > noise * (abs(ax) + abs(ay) + abs(bx) + abs(by)):
        return area
    longest = max(np.hypot(ax, ay), np.hypot(bx, by), np.hypot(ax + bx, ay + by))
    return 0.0 if abs(area) <= noise * longest else area


@kernel
def _crosses(p: Floats, q: Floats, a: Floats, b: Floats, noise: float) -> bool:
    """Whether the edge from a to b crosses or touches the line from p to q more than `noise` [m] before its ends."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    ax, ay, bx, by = a[0] - p[0], a[1] - p[1], b[0] - p[0], b[1] - p[1]
    if (dx * ay - dy * ax) * (dx * by - dy * bx) > 0.0:
        return False
    length = np.hypot(dx, dy)
    along_a, along_b = (dx * ax + dy * ay) / length, (dx * bx + dy * by) / length
    if max(along_a, along_b) <= noise or min(along_a, along_b) >= length - noise:
        return False
    ex, ey = b[0] - a[0], b[1] - a[1]
    return bool((ex * ay - ey * ax) * (ex * (a[1] - q[1]) - ey * (a[0] - q[0])) <= 0.0)
