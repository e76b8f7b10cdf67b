"""The borders of a map as indexed line segments, built once for each map."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import shapely

from planners.kernel import Bools, Floats
from planners.map import Map, Raster


@dataclass(frozen=True, slots=True, eq=False)
class Border:
    """Line segments `ends` (E, 2, 2) [m] and a tree over them."""

    ends: Floats
    tree: Any


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """What distances are measured to.

    `border` holds the edges of every polygon, `raster_border` those between blocked and free cells; None
    where there are none. `obstacles` is a tree over the obstacle polygons, `keep_in` the polygons to stay
    inside of, with the bounds among them where the edge is closed.
    """

    border: Border | None
    raster_border: Border | None
    obstacles: Any
    keep_in: tuple[Any, ...]


# A map never changes and equals only itself, so its outline may be kept; a campaign has a handful of maps.
@lru_cache(maxsize=16)
def outline(area: Map) -> Outline:
    """The outline of `area`."""
    keep_in = list(area.keep_in)
    if area.bounds is not None and area.edge == "closed":
        keep_in.append(box_ring(area.bounds))
    rings = [np.stack([ring, np.roll(ring, -1, axis=0)], axis=1) for ring in (*area.polygons, *keep_in)]
    inside = tuple(shapely.Polygon(ring) for ring in keep_in)
    for polygon in inside:
        shapely.prepare(polygon)
    return Outline(
        border=_border(np.concatenate(rings)) if rings else None,
        raster_border=_border(raster_edges(area.raster)) if area.raster is not None else None,
        obstacles=shapely.STRtree([shapely.Polygon(ring) for ring in area.polygons]),
        keep_in=inside,
    )


def box_ring(bounds: tuple[float, float, float, float]) -> Floats:
    """The corners (4, 2) of x_min, y_min, x_max, y_max, counter-clockwise."""
    x_min, y_min, x_max, y_max = bounds
    return np.array([[x_min, y_min], [x_max, y_min], [x_max, y_max], [x_min, y_max]])


def raster_edges(raster: Raster) -> Floats:
    """The segments (E, 2, 2) [m] between blocked and free cells, joined along lines; outside is free."""
    padded = np.pad(raster.blocked, 1)
    upright = padded[1:-1, 1:] != padded[1:-1, :-1]
    level = padded[1:, 1:-1] != padded[:-1, 1:-1]
    column, low, high = _runs(upright.T)
    row, left, right = _runs(level)
    ends = np.concatenate([
        np.stack([np.column_stack([column, low]), np.column_stack([column, high])], axis=1),
        np.stack([np.column_stack([left, row]), np.column_stack([right, row])], axis=1),
    ])  # fmt: skip
    return np.asarray(ends * raster.cell + np.array([raster.x, raster.y]), dtype=float)


def _runs(marked: Bools) -> tuple[Any, Any, Any]:
    """Row, first and one past the last column of each run of marked cells."""
    steps = np.diff(np.pad(marked, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, first = np.nonzero(steps == 1)
    return row, first, np.nonzero(steps == -1)[1]


def _border(ends: Floats) -> Border | None:
    if not len(ends):
        return None
    return Border(ends, shapely.STRtree(shapely.linestrings(ends)))
