"""The shortest way among polygons, by visibility graph (Lozano-Perez and Wesley 1979)."""

from __future__ import annotations

from heapq import heappop, heappush
from typing import Any

import numpy as np
import shapely

from planners.errors import TrackworthyError
from planners.kernel import Bools, Floats, Ints, kernel

STRAIGHT = 1e-6  # sines of corners at which rounding may hide a bend
ALONG = 1e-10  # sines, and shares of a line, that are rounding


def shortest(free: Any, start: Floats, goal: Floats) -> Floats:
    """The corners (N, 2) [m] of the shortest line within the polygon `free` from `start` to `goal` (2,); both included.

    Both must lie inside, not on the border, and no ring may touch another.

    A shortest line bends only at the border's reflex corners, and where it does, it is tangent to it. So the graph's
    edges are the tangents that cross no border; those of a corner are found only once the search (A*, Hart, Nilsson
    and Raphael 1968) gets there, and only where they may shorten what is known.
    """
    points, before, after, bends = _graph(free, start, goal)
    rest = np.hypot(*(points - goal).T)
    length, previous = np.full(len(points), np.inf), np.full(len(points), -1)
    done = np.zeros(len(points), dtype=bool)
    here, last = len(points) - 2, len(points) - 1
    length[here] = 0.0
    heap = [(float(rest[here]), here)]
    while heap:
        _, here = heappop(heap)
        if here == last:
            break
        if done[here]:
            continue
        done[here] = True
        within = np.where(bends, np.minimum(length, length[last] - rest) - length[here], -np.inf)
        for there in seen(here, within, points, before, after):
            length[there] = length[here] + np.hypot(*(points[there] - points[here]))
            previous[there] = here
            heappush(heap, (float(length[there] + rest[there]), int(there)))
    if previous[last] < 0:
        raise TrackworthyError("visibility graph: rounding hides every way; this is a fault of trackworthy")
    way = [last]
    while previous[way[-1]] >= 0:
        way.append(previous[way[-1]])
    return np.asarray(points[way[::-1]], dtype=float)


def _graph(free: Any, start: Floats, goal: Floats) -> tuple[Floats, Ints, Ints, Bools]:
    """Points (N, 2), the border's, then start and goal; of each the one before and after; where a line may bend."""
    polygon = shapely.geometry.polygon.orient(free)
    rings = [shapely.get_coordinates(ring)[:-1] for ring in (polygon.exterior, *polygon.interiors)]
    before, after, count = [], [], 0
    for ring in rings:
        at = count + np.arange(len(ring))
        before.append(np.roll(at, 1))
        after.append(np.roll(at, -1))
        count += len(ring)
    ends = [count, count + 1]
    points = np.vstack([*rings, start, goal])
    back, ahead = np.concatenate([*before, ends]), np.concatenate([*after, ends])
    (ax, ay), (bx, by) = (points - points[back]).T, (points[ahead] - points).T
    bends = ax * by - ay * bx <= STRAIGHT * np.hypot(ax, ay) * np.hypot(bx, by)
    bends[ends] = True
    return points, back, ahead, bends


@kernel
def seen(source: int, within: Floats, points: Floats, before: Ints, after: Ints) -> Ints:
    """Which `points` (N, 2) the one of index `source` sees along tangents, nearer than `within` (N,) [m] each.

    The border runs from each of the points but the last two, which are start and goal, to the one `after` it. A line
    that touches the border between its ends does not count: it is made of shorter ones.
    """
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
        tangent = _tangent(dx, dy, source, points, before, after) and _tangent(-dx, -dy, i, points, before, after)
        if tangent and np.hypot(dx, dy) < within[i]:
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
                hidden[i] = _crosses(points[source], points[q], points[a], points[b])
            k += 1
    return found[~hidden]


@kernel
def _bearing(dx: float, dy: float) -> float:
    """A number from 0 to 4 that grows with the bearing from east by north, and by 2 with each half turn."""
    east = dx / (abs(dx) + abs(dy))
    return 1.0 - east if dy >= 0.0 else 3.0 + east


@kernel
def _tangent(dx: float, dy: float, i: int, points: Floats, before: Ints, after: Ints) -> bool:
    """Whether the line that leaves point `i` by (dx, dy) has the border's neighbouring vertices on one side.

    A line that runs along one of their edges must end with it or before.
    """
    sides = 1.0
    for k in (before[i], after[i]):
        x, y = points[k, 0] - points[i, 0], points[k, 1] - points[i, 1]
        side = dx * y - dy * x
        if abs(side) <= ALONG * (abs(dx) + abs(dy)) * (abs(x) + abs(y)):
            side = 0.0
            if dx * x + dy * y > 0.0 and np.hypot(x, y) < (1.0 - ALONG) * np.hypot(dx, dy):
                return False
        sides *= side
    return sides >= 0.0


@kernel
def _crosses(p: Floats, q: Floats, a: Floats, b: Floats) -> bool:
    """Whether the edge from a to b crosses or touches the line from p to q short of its ends."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    ax, ay, bx, by = a[0] - p[0], a[1] - p[1], b[0] - p[0], b[1] - p[1]
    if (dx * ay - dy * ax) * (dx * by - dy * bx) > 0.0:
        return False
    whole = dx * dx + dy * dy
    along_a, along_b = (dx * ax + dy * ay) / whole, (dx * bx + dy * by) / whole
    if max(along_a, along_b) <= ALONG or min(along_a, along_b) >= 1.0 - ALONG:
        return False
    ex, ey = b[0] - a[0], b[1] - a[1]
    return bool((ex * ay - ey * ax) * (ex * (a[1] - q[1]) - ey * (a[0] - q[0])) <= 0.0)
