"""Candidate paths of each aircraft to each target: along the roadmap, and shortened by line of sight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from scipy.sparse import csr_array
from scipy.sparse.csgraph import yen

from planners.kernel import Bools, Floats
from planners.units import wrap_all
from planners.voronoi.roadmap import Roadmap, lines_free

THREAT = 1e10  # of a hazard, in lengths of the edge that meets it (paper 001, eq. 2)


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A path of one `aircraft` to one `target`: `along` the roadmap (N, 2), and `short` (M, 2) by line of sight."""

    aircraft: int
    target: int
    along: Floats
    short: Floats

    @property
    def length(self) -> float:
        """Length of the short path."""
        return float(np.hypot(*np.diff(self.short, axis=0).T).sum())

    @property
    def turn(self) -> float:
        """The largest turn [rad] of the short path."""
        return largest_turn(self.short)


def largest_turn(points: Floats) -> float:
    """The largest turn angle [rad] at a vertex of `points` (N, 2)."""
    steps = np.diff(points, axis=0)
    return float(np.abs(wrap_all(np.diff(np.arctan2(steps[:, 1], steps[:, 0])))).max(initial=0.0))


def candidates(
    roadmap: Roadmap, free: Any, ends: Floats, starts: int, pairs: Bools, count: int, links: int, spacing: float
) -> list[Candidate]:
    """Up to `count` paths for each of the `pairs` (S, G) of aircraft and target: the shortest by Dijkstra and Yen 1971.

    `ends` (S + G, 2) are the starts, then the targets; each is linked to its nearest `links` vertices in sight. More
    links would lead past the roadmap. An edge costs its length (paper 001, eq. 1), and `THREAT` times that where it
    meets a hazard (eq. 2). A path that still meets one when it has been shortened, between points `spacing` apart, is
    none.
    """
    near = [_links(roadmap.vertices, end, free, links) for end in ends]
    found = []
    for aircraft, target in np.argwhere(pairs).tolist():
        start, goal = aircraft, starts + target
        for along in _paths(roadmap, ends[[start, goal]], near[start], near[goal], free, count):
            short = in_sight(along, free, spacing)
            if lines_free(free, np.stack([short[:-1], short[1:]], axis=1)).all():
                found.append(Candidate(aircraft, target, along, short))
    return found


def _links(vertices: Floats, end: Floats, free: Any, count: int) -> list[int]:
    """The `count` vertices nearest to `end` that it sees."""
    order = np.argsort(np.hypot(*(vertices - end).T), kind="stable")
    seen: list[int] = []
    for chunk in np.split(order, range(4 * count, len(order), 4 * count)):
        lines = np.stack([np.broadcast_to(end, (len(chunk), 2)), vertices[chunk]], axis=1)
        seen += chunk[lines_free(free, lines)].tolist()
        if len(seen) >= count:
            break
    return seen[:count]


def _paths(
    roadmap: Roadmap, ends: Floats, at_start: list[int], at_goal: list[int], free: Any, count: int
) -> list[Floats]:
    """The points of the `count` cheapest ways between the `ends` (2, 2)."""
    start, goal = len(roadmap.vertices), len(roadmap.vertices) + 1
    points = np.vstack([roadmap.vertices, ends])
    links = [(start, goal), *((start, i) for i in at_start), *((i, goal) for i in at_goal)]
    edges = np.vstack([roadmap.edges, np.array(links)])
    direct = lines_free(free, ends[None])
    clear = np.concatenate([roadmap.free, direct, np.ones(len(links) - 1, dtype=bool)])
    length = np.hypot(*(points[edges[:, 1]] - points[edges[:, 0]]).T)
    kept = length > 0.0
    cost = np.where(clear, length, THREAT * length)[kept]
    ij = edges[kept].T.astype(np.int32)  # yen takes no larger indices
    graph = csr_array((cost, (ij[0], ij[1])), shape=(len(points), len(points)))
    _, previous = yen(graph, start, goal, count, directed=False, return_predecessors=True)
    ways = []
    for before in previous:
        way = [goal]
        while way[-1] != start:
            way.append(int(before[way[-1]]))
        ways.append(points[way[::-1]])
    return ways


def in_sight(points: Floats, free: Any, spacing: float) -> Floats:
    """`points` (N, 2) shortened: from each place on to the farthest place, every `spacing`, that is in sight.

    The line-of-sight method of paper 001, section 2.1 (Hazelton 2004).
    """
    dense = shapely.get_coordinates(shapely.segmentize(shapely.LineString(points), spacing))
    kept, last = [0], len(dense) - 1
    while kept[-1] < last:
        here = kept[-1]
        there = np.arange(here + 1, last + 1)
        lines = np.stack([np.broadcast_to(dense[here], (len(there), 2)), dense[there]], axis=1)
        seen = there[lines_free(free, lines)]
        kept.append(int(seen[-1]) if len(seen) else here + 1)
    return np.asarray(dense[kept])
