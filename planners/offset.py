"""Polygons grown and shrunk by a distance, never by less."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from planners.kernel import Floats
from planners.map import Circle

ARC = np.radians(4.5)  # between the tangents that stand for an arc: it is outside by at most 1/cos(ARC/2) - 1 = 7.7e-4
SPECK = 1e-12  # [areas of the polygon] a hole this small is none


def overlay(operation: Any, *shapes: Any) -> Any:
    """A union, difference or intersection of shapes by GEOS.

    Where rounding defeats it, with or without its notice, vertices snap to a grid of 1e-12 of the largest coordinate.
    """
    try:
        result = operation(*shapes)
        if result.is_valid:
            return result
    except shapely.GEOSException:
        pass
    return operation(*shapes, grid_size=1e-12 * float(np.abs(shapely.total_bounds(np.hstack(shapes))).max()))


def grown(shape: Any, clearance: float, step: float = ARC, towards: Floats | None = None) -> Any:
    """All that is nearer than `clearance` [m] to a polygon or several, arcs as by `tangents`."""
    if clearance == 0.0:
        return shape
    shape = shapely.remove_repeated_points(shape)  # an edge without length has no side
    union = overlay(shapely.union_all, [shape, *_rim(shape, clearance, step, towards)])
    return shapely.MultiPolygon([_without_specks(polygon) for polygon in shapely.get_parts(union)])


def shrunk(polygon: Any, clearance: float, step: float = ARC, towards: Floats | None = None) -> Any:
    """All of a polygon without holes that is `clearance` [m] or more from its border, arcs as by `tangents`."""
    if clearance == 0.0:
        return polygon
    # What is outside grows: to take what grew from the polygon would leave slivers along the border, by rounding
    frame = shapely.envelope(shapely.buffer(shapely.envelope(polygon), clearance + polygon.length))
    around = grown(shapely.Polygon(frame.exterior, [polygon.exterior]), clearance, step, towards)
    return shapely.MultiPolygon([shapely.Polygon(hole) for part in around.geoms for hole in part.interiors])


def tangents(
    circle: Circle, first: float = 0.0, turn: float = 2.0 * np.pi, step: float = ARC, towards: Floats | None = None
) -> Floats:
    """The corners (N, 2) [m] of the tangents on an arc of `circle`, from bearing `first` on and left by `turn` [rad].

    They touch the circle at its `bearings`.
    """
    at = bearings(circle, first, turn, step, towards)
    middle, far = (at[1:] + at[:-1]) / 2.0, circle.radius / np.cos(np.diff(at) / 2.0)
    return np.column_stack([circle.x + far * np.cos(middle), circle.y + far * np.sin(middle)])


def bearings(circle: Circle, first: float, turn: float, step: float, towards: Floats | None) -> Floats:
    """Ascending bearings (N,) [rad] on an arc, at most `step` apart.

    Those of the points `towards` (M, 2) are among them, so that polygons at these bearings cut off none of the points.
    """
    even = np.linspace(first, first + turn, int(np.ceil(turn / step)) + 1)
    if towards is None:
        return even
    own = first + (np.arctan2(towards[:, 1] - circle.y, towards[:, 0] - circle.x) - first) % (2.0 * np.pi)
    return np.asarray(np.unique(np.concatenate([even, own[own < first + turn]])))


def _without_specks(polygon: Any) -> Any:
    """The polygon without the holes that are rounding."""
    holes = [hole for hole in polygon.interiors if shapely.Polygon(hole).area > SPECK * polygon.area]
    return shapely.Polygon(polygon.exterior, holes)


def _rim(shape: Any, width: float, step: float, towards: Floats | None) -> list[Any]:
    """Polygons that cover all outside of `shape` within `width` [m] of its border, and nothing beyond.

    A strip lies along every edge, and a fan about every corner at which two strips gape. All reach inwards a little,
    for where parts only share an edge, rounding may leave slivers between them.
    """
    parts = []
    for polygon in shapely.get_parts(shape):
        polygon = shapely.geometry.polygon.orient(polygon)
        for ring in (polygon.exterior, *polygon.interiors):
            start = shapely.get_coordinates(ring)[:-1]
            end = np.roll(start, -1, axis=0)
            edge = end - start
            out = width * edge / np.hypot(*edge.T)[:, None] @ [[0.0, -1.0], [1.0, 0.0]]
            strips = np.stack([start - out / 2.0, end - out / 2.0, end + out, start + out], axis=1)
            parts += shapely.polygons(strips).tolist()
            first = np.arctan2(*np.roll(out, 1, axis=0).T[::-1])
            turn = (np.arctan2(*out.T[::-1]) - first + np.pi) % (2.0 * np.pi) - np.pi
            for i in np.flatnonzero(turn > 0.0):
                x, y = start[i].tolist()
                arc = tangents(Circle(x, y, width), float(first[i]), float(turn[i]), step, towards)
                apex = start[i] - (out[i - 1] + out[i]) / 4.0
                parts.append(shapely.Polygon([apex, start[i] + out[i - 1], *arc, start[i] + out[i]]))
    return parts
