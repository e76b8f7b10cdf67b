"""A map grown by a clearance, so that a point may stand for a body that keeps it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import shapely
from scipy.ndimage import binary_dilation, distance_transform_edt

from planners.errors import InputError
from planners.kernel import Floats
from planners.map import Map, Raster
from planners.offset import grown, overlay, shrunk


def inflated(area: Map, clearance: float) -> Map:
    """The map whose forbidden area holds every point nearer than `clearance` [m] to what `area` forbids.

    It is exact for circles, closed bounds and the straight sides of polygons; an arc about a vertex is drawn by its
    tangents, which adds less than 1e-3 of the clearance. A cell is blocked once any of its points is nearer than the
    clearance to a blocked cell. Open bounds limit only a vehicle's reference point and stay as they are, and so does
    a map of no clearance, which is `area` itself.

    Raises `InputError` for a clearance that is negative or not finite, and where it leaves nothing of the bounds or of
    an area to stay in.
    """
    if not (np.isfinite(clearance) and clearance >= 0.0):
        raise InputError("clearance", f"{clearance} m is not possible", "give 0 or more")
    if clearance == 0.0:
        return area
    polygons = [ring for polygon in area.polygons for ring in _rings(grown(shapely.Polygon(polygon), clearance))]
    keep_in: list[Floats] = []
    for i, ring in enumerate(area.keep_in, 1):
        inside = shrunk(shapely.Polygon(ring), clearance)
        if inside.is_empty:
            raise _nothing_left(f"keep-in polygon {i}", clearance)
        pieces = _rings(inside)
        if len(pieces) > 1:
            # A vehicle must be in all keep-in areas, but in only one of these: what is between them becomes obstacle
            around = shapely.envelope(inside)
            pieces = _rings(around)
            polygons += _rings(overlay(shapely.difference, shapely.envelope(around.buffer(clearance)), inside))
        keep_in += pieces
    bounds = area.bounds
    if bounds is not None and area.edge == "closed":
        bounds = (bounds[0] + clearance, bounds[1] + clearance, bounds[2] - clearance, bounds[3] - clearance)
        if bounds[0] >= bounds[2] or bounds[1] >= bounds[3]:
            raise _nothing_left("bounds", clearance)
    for i, circle in enumerate(area.keep_in_circles, 1):
        if circle.radius <= clearance:
            raise _nothing_left(f"keep-in circle {i}", clearance)
    return replace(
        area,
        polygons=tuple(polygons),
        circles=tuple(replace(circle, radius=circle.radius + clearance) for circle in area.circles),
        keep_in=tuple(keep_in),
        keep_in_circles=tuple(replace(circle, radius=circle.radius - clearance) for circle in area.keep_in_circles),
        bounds=bounds,
        raster=None if area.raster is None else _dilated(area.raster, clearance, area.bounds),
    )


def _rings(shape: Any) -> list[Floats]:
    """Rings (N, 2) that together are the polygons of `shape`.

    A polygon with a hole is cut into two, left and right of the hole's middle; they overlap, for one may touch a seam.
    """
    rings = []
    for polygon in shapely.get_parts(shape):
        if polygon.geom_type != "Polygon":
            continue
        x_min, y_min, x_max, y_max = polygon.bounds
        if not polygon.interiors:
            rings.append(shapely.get_coordinates(polygon.exterior)[:-1])
            continue
        left, _, right, _ = polygon.interiors[0].bounds
        for half in (
            shapely.box(x_min, y_min, (left + 2.0 * right) / 3.0, y_max),
            shapely.box((2.0 * left + right) / 3.0, y_min, x_max, y_max),
        ):
            rings += _rings(overlay(shapely.intersection, polygon, half))
    return rings


def _dilated(raster: Raster, clearance: float, bounds: tuple[float, float, float, float] | None) -> Raster:
    """The raster with every cell blocked that has a point nearer than `clearance` [m] to a blocked one.

    It reaches as far beyond its old extent as the clearance does, but not beyond the `bounds`.
    """
    rows, columns = raster.blocked.shape
    reach = np.full(4, clearance)
    if bounds is not None:
        here = (raster.x, raster.y, raster.x + columns * raster.cell, raster.y + rows * raster.cell)
        reach = np.minimum(reach, (np.array(here) - bounds) * [1.0, 1.0, -1.0, -1.0])
    west, south, east, north = np.ceil(reach / raster.cell).clip(0).astype(int).tolist()
    free = ~np.pad(raster.blocked, ((south, north), (west, east)))
    # Two squares are a cell nearer in x and in y than their centres, and so are those of a raster dilated once
    touched = ~binary_dilation(~free, np.ones((3, 3)))
    near = distance_transform_edt(touched) * raster.cell < clearance if not free.all() else ~free
    return Raster(near, raster.cell, raster.x - west * raster.cell, raster.y - south * raster.cell)


def _nothing_left(place: str, clearance: float) -> InputError:
    return InputError(place, f"a clearance of {clearance:g} m leaves nothing of it", "give less clearance")
