"""The Voronoi roadmap: halfway between the hazards, and along the map's edge (paper 001, section 1.1)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from scipy.spatial import Voronoi

from planners.exact import free_space
from planners.fleet import fleet_ends
from planners.kernel import Bools, Floats, Ints
from planners.map import Map
from planners.scenario import Scenario
from planners.voronoi.sites import mirrored, sites_of


@dataclass(frozen=True, slots=True, eq=False)
class Roadmap:
    """`vertices` (V, 2) [m], `edges` (E, 2) between them, and which of these are `free` (E,)."""

    vertices: Floats
    edges: Ints
    free: Bools


def roadmap_of(scenario: Scenario, clearance: float) -> Roadmap:
    """The roadmap of a scenario, with `clearance` [m] to all that is forbidden.

    Raises `InputError` for a start or goal without it.
    """
    ends = fleet_ends(scenario, clearance, "roadmap")
    return roadmap_in(scenario.map, free_space(scenario.map, clearance, ends))


def roadmap_in(area: Map, free: Any) -> Roadmap:
    """The roadmap of an area whose `free` space keeps the clearance.

    The hazards are mirrored in the sides of the free space's box: so no edge is infinite, and the sides are edges too.
    """
    if shapely.is_empty(free):
        return Roadmap(np.empty((0, 2)), np.empty((0, 2), np.int64), np.empty(0, np.bool_))
    box = box_of(free)
    points = sites_of(area, free, box)
    if not len(points):
        return Roadmap(np.empty((0, 2)), np.empty((0, 2), np.int64), np.empty(0, np.bool_))
    diagram = Voronoi(mirrored(points, box))
    x_min, y_min, x_max, y_max = box
    slack = 1e-9 * max(x_max - x_min, y_max - y_min)
    x, y = diagram.vertices.T
    inside = (x > x_min - slack) & (x < x_max + slack) & (y > y_min - slack) & (y < y_max + slack)
    edges = np.array([ridge for ridge in diagram.ridge_vertices if min(ridge) >= 0], dtype=np.int64).reshape(-1, 2)
    edges = edges[inside[edges].all(axis=1)]
    used, flat = np.unique(edges, return_inverse=True)
    # To lie on a side counts as inside, whatever rounding says
    vertices = np.clip(diagram.vertices[used], [x_min, y_min], [x_max, y_max])
    edges = flat.reshape(-1, 2)
    return Roadmap(vertices, edges, lines_free(free, vertices[edges]))


def box_of(free: Any) -> tuple[float, float, float, float]:
    """x_min, y_min, x_max, y_max around the `free` space."""
    x_min, y_min, x_max, y_max = shapely.bounds(free).tolist()
    return x_min, y_min, x_max, y_max


def lines_free(free: Any, lines: Floats) -> Bools:
    """Which of the straight `lines` (N, 2, 2) lie in `free`."""
    shapely.prepare(free)
    return np.asarray(shapely.covers(free, shapely.linestrings(lines)), dtype=bool).reshape(len(lines))
