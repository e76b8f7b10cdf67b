"""The shortest way among polygons, by visibility graph (Lozano-Perez and Wesley 1979)."""

from __future__ import annotations

from heapq import heappop, heappush
from typing import Any

import numpy as np
import shapely

from planners.errors import TrackworthyError
from planners.kernel import Floats, Ints
from planners.sight import reflex, seen

NOISE = 1e-14  # [largest coordinates] what rounding may move a vertex by


def shortest(free: Any, start: Floats, goal: Floats) -> Floats:
    """The corners (N, 2) [m] of the shortest line within the polygon `free` from `start` to `goal` (2,); both included.

    Both must lie inside, not on the border, and no ring may touch another.

    A shortest line bends only at the border's reflex corners, and where it does, it is tangent to it. So the graph's
    edges are the tangents that cross no border; those of a corner are found only once the search (A*, Hart, Nilsson
    and Raphael 1968) gets there, and only where they may shorten what is known.
    """
    points, before, after = _graph(free, start, goal)
    noise = NOISE * float(np.abs(points).max())
    bends = reflex(points, before, after, noise)
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
        for there in seen(here, within, points, before, after, noise):
            length[there] = length[here] + np.hypot(*(points[there] - points[here]))
            previous[there] = here
            heappush(heap, (float(length[there] + rest[there]), int(there)))
    if previous[last] < 0:
        raise TrackworthyError("visibility graph: rounding hides every way; this is a fault of trackworthy")
    way = [last]
    while previous[way[-1]] >= 0:
        way.append(previous[way[-1]])
    return np.asarray(points[way[::-1]], dtype=float)


def _graph(free: Any, start: Floats, goal: Floats) -> tuple[Floats, Ints, Ints]:
    """The border's vertices, then start and goal (N, 2), and the index (N,) of the one before and after each."""
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
    return points, np.concatenate([*before, ends]), np.concatenate([*after, ends])
