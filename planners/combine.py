"""Maps put together: one inside another's frame, and two that both apply."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from planners.errors import InputError
from planners.frame import Frame
from planners.kernel import Floats
from planners.map import Circle, Map
from planners.outline import box_ring


def merge(a: Map, b: Map) -> Map:
    """The map that forbids what `a` or `b` forbids; both must have the same frame.

    Of two bounds with the same edge the part common to both remains; with different edges, the closed ones
    become a keep-in area. Raises `InputError` for two frames, two rasters, or bounds with nothing in common.
    """
    if a.frame != b.frame:
        raise InputError("map", "two maps in different frames cannot apply at once", "re-express one with to_frame")
    if a.raster is not None and b.raster is not None:
        raise InputError("map", "two rasters cannot be put together", "leave one of the maps out")
    if a.bounds is not None and b.bounds is not None and a.edge != b.edge:
        a, b = (_edge_as_keep_in(m) if m.edge == "closed" else m for m in (a, b))
    return Map(
        polygons=a.polygons + b.polygons,
        circles=a.circles + b.circles,
        keep_in=a.keep_in + b.keep_in,
        keep_in_circles=a.keep_in_circles + b.keep_in_circles,
        bounds=_common(a, b),
        edge=a.edge if a.bounds is not None else b.edge,
        raster=a.raster if a.raster is not None else b.raster,
        frame=a.frame,
    )


def to_frame(area: Map, frame: Frame) -> Map:
    """The same map in another frame: vertices and centres stay where they are on the ellipsoid.

    Sides stay straight; within 200 km of both origins the middle of a side of 10 km moves by less than 0.05
    m. Raises `InputError` for a map without a frame, or with a raster or bounds, whose sides follow the axes
    of their own frame.
    """
    if area.frame == frame:
        return area
    if area.frame is None:
        raise InputError("map", "it has no origin, so it cannot be placed on the ellipsoid", "give it an origin")
    if area.raster is not None or area.bounds is not None:
        raise InputError("map", "a raster or bounds cannot be turned into another frame", "re-express the other map")

    old = area.frame

    def moved(points: Floats) -> Floats:
        return frame.to_local(*old.to_geographic(points).T)

    def moved_circle(circle: Circle) -> Circle:
        x, y = moved(np.array([[circle.x, circle.y]]))[0]
        return Circle(float(x), float(y), circle.radius)

    return replace(
        area,
        polygons=tuple(moved(ring) for ring in area.polygons),
        circles=tuple(moved_circle(circle) for circle in area.circles),
        keep_in=tuple(moved(ring) for ring in area.keep_in),
        keep_in_circles=tuple(moved_circle(circle) for circle in area.keep_in_circles),
        frame=frame,
    )


def _edge_as_keep_in(area: Map) -> Map:
    if area.bounds is None:
        return area
    return replace(area, keep_in=(*area.keep_in, box_ring(area.bounds)), bounds=None)


def _common(a: Map, b: Map) -> tuple[float, float, float, float] | None:
    if a.bounds is None or b.bounds is None:
        return a.bounds or b.bounds
    low, high = np.maximum(a.bounds, b.bounds)[:2], np.minimum(a.bounds, b.bounds)[2:]
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])
