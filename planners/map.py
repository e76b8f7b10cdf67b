"""A map: obstacles, keep-in areas and an edge in a local frame."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import shapely

from planners.errors import InputError
from planners.frame import Frame
from planners.kernel import Bools, Floats

EDGES = ("closed", "open")


@dataclass(frozen=True, slots=True)
class Circle:
    """A round area, centre (`x`, `y`) and `radius` [m]."""

    x: float
    y: float
    radius: float


@dataclass(frozen=True, slots=True, eq=False)
class Raster:
    """Square cells of side `cell` [m], row 0 in the south, the south-west corner of all at (`x`, `y`) [m].

    `blocked` (rows, cols) marks the cells that are obstacle.
    """

    blocked: Bools
    cell: float
    x: float = 0.0
    y: float = 0.0

    def __post_init__(self) -> None:
        blocked = np.array(self.blocked, dtype=bool, order="C")
        if blocked.ndim != 2 or blocked.size == 0:
            raise InputError("raster", f"it needs rows and columns of cells, not shape {blocked.shape}")
        if not (np.isfinite([self.cell, self.x, self.y]).all() and self.cell > 0.0):
            raise InputError("raster", f"a cell of {self.cell} m at ({self.x}, {self.y}) is not possible")
        blocked.setflags(write=False)
        object.__setattr__(self, "blocked", blocked)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Map:
    """Where a vehicle may be, in a local frame [m].

    It must stay out of every obstacle: `polygons`, each (N, 2), `circles` and the blocked cells of `raster`.
    It must stay inside every one of `keep_in` and `keep_in_circles`, which is how MAVLink defines the
    inclusion zones of one group (MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, param 2) and what ArduPilot does
    by default; PX4 is content with any one of them. `bounds` is x_min, y_min, x_max, y_max: with a "closed"
    `edge` they bound the whole footprint, with an "open" one only its reference point. A map without any of
    these forbids nothing.

    Raises `InputError` for an area that is none: fewer than three vertices, edges that cross, a coordinate
    that is not finite, a radius or bounds without extent.
    """

    polygons: tuple[Floats, ...] = ()
    circles: tuple[Circle, ...] = ()
    keep_in: tuple[Floats, ...] = ()
    keep_in_circles: tuple[Circle, ...] = ()
    bounds: tuple[float, float, float, float] | None = None
    edge: str = "closed"
    raster: Raster | None = None
    frame: Frame | None = None

    def __post_init__(self) -> None:
        for name, what in (("polygons", "polygon"), ("keep_in", "keep-in polygon")):
            rings = [checked_polygon(ring, f"{what} {i}") for i, ring in enumerate(getattr(self, name), 1)]
            object.__setattr__(self, name, tuple(rings))
        for name, what in (("circles", "circle"), ("keep_in_circles", "keep-in circle")):
            circles = [checked_circle(circle, f"{what} {i}") for i, circle in enumerate(getattr(self, name), 1)]
            object.__setattr__(self, name, tuple(circles))
        if self.edge not in EDGES:
            raise InputError("edge", f"{self.edge!r} is not known", f"use {' or '.join(EDGES)}")
        if self.bounds is not None:
            object.__setattr__(self, "bounds", checked_bounds(self.bounds, "bounds"))


def checked_polygon(ring: Floats | Iterable[Iterable[float]], place: str) -> Floats:
    """The polygon as a read-only (N, 2) [m], its first vertex not repeated; `place` names it in errors."""
    points = np.array(ring, dtype=float, order="C")
    if points.ndim != 2 or points.shape[1] != 2:
        raise InputError(place, f"a polygon needs rows of x, y, not an array of shape {points.shape}")
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise InputError(place, f"vertex {bad[0] + 1} is {points[bad[0]].tolist()}", "every coordinate must be finite")
    if len(points) > 1 and (points[0] == points[-1]).all():
        points = points[:-1].copy()
    if len(points) < 3:
        raise InputError(place, f"a polygon needs at least three vertices, this has {len(points)}")
    polygon = shapely.Polygon(points)
    if not polygon.is_valid or polygon.area == 0.0:
        reason = shapely.is_valid_reason(polygon).replace("[", " at (").replace("]", ")")
        raise InputError(place, f"its edges cross or touch: {reason}", "give the vertices in order around the area")
    points.setflags(write=False)
    return points


def checked_circle(circle: Circle, place: str) -> Circle:
    """The circle itself, if it has an extent; `place` names it in errors."""
    if not np.isfinite([circle.x, circle.y, circle.radius]).all():
        raise InputError(place, f"({circle.x}, {circle.y}) with radius {circle.radius} is not finite")
    if circle.radius <= 0.0:
        raise InputError(place, f"its radius is {circle.radius}", "give a radius above 0")
    return circle


def checked_bounds(bounds: tuple[float, float, float, float], place: str) -> tuple[float, float, float, float]:
    """The bounds themselves, if they enclose an area; `place` names them in errors."""
    x_min, y_min, x_max, y_max = bounds
    if not (np.isfinite(bounds).all() and x_min < x_max and y_min < y_max):
        raise InputError(place, f"{bounds} enclose no area", "give x_min, y_min, x_max, y_max")
    return bounds
