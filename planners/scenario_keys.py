"""The keys of a scenario file, and the map they describe."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import Annotated, Literal

import msgspec
import numpy as np

from planners.errors import InputError
from planners.frame import ELLIPSOIDS, Frame
from planners.kernel import Floats
from planners.map import Circle, Map, Raster, checked_circle, checked_polygon
from planners.segmentation.settings import Segmentation
from planners.typed_toml import suggestion

LARGEST = 1e9  # [map units, m] anything longer is a slip, infinity among it; no planet is that large

Point = tuple[float, float]
Length = Annotated[float, msgspec.Meta(gt=0.0, le=LARGEST)]


class CircleKeys(msgspec.Struct, forbid_unknown_fields=True):
    """A circle [map units]."""

    center: Point
    radius: float


class AreaKeys(msgspec.Struct, forbid_unknown_fields=True):
    """One `[[obstacle]]` or `[[keep_in]]`: a polygon or a circle."""

    polygon: list[list[float]] | None = None
    circle: CircleKeys | None = None


class ScenarioKeys(msgspec.Struct, forbid_unknown_fields=True):
    """A scenario file as it is written: lengths in map units, angles in degrees."""

    name: str
    size: tuple[Length, Length] | None = None
    unit: Length = 1.0
    planet: str = ""
    start: Point | None = None
    goal: Point | None = None
    vehicles: list[Point] | None = None
    targets: list[Point] | None = None
    max_range: Length | None = None
    max_turn_angle: Annotated[float, msgspec.Meta(gt=0.0, le=180.0)] | None = None
    obstacle: list[AreaKeys] = []
    keep_in: list[AreaKeys] = []
    image: str | None = None
    truth: str | None = None
    segment: Segmentation | None = None
    edge: Literal["closed", "open"] = "closed"
    origin: tuple[float, float] | None = None


def map_from_keys(keys: ScenarioKeys, size: Point, raster: Raster | None, file: FilePath) -> Map:
    """The map in metres, of that `size` [map units] and with the `raster`.

    Raises `InputError` that names `file` and key for an area that is none.
    """
    polygons, circles = _areas(keys.obstacle, keys.unit, f"{file}: obstacle")
    keep_in, keep_in_circles = _areas(keys.keep_in, keys.unit, f"{file}: keep_in")
    width, height = size
    return Map(
        polygons=polygons,
        circles=circles,
        keep_in=keep_in,
        keep_in_circles=keep_in_circles,
        bounds=(0.0, 0.0, width * keys.unit, height * keys.unit),
        edge=keys.edge,
        raster=raster,
        frame=_frame(keys, file),
    )


def _areas(areas: list[AreaKeys], unit: float, place: str) -> tuple[tuple[Floats, ...], tuple[Circle, ...]]:
    polygons, circles = [], []
    for i, area in enumerate(areas):
        here = f"{place}[{i}]"
        if (area.polygon is None) == (area.circle is None):
            raise InputError(here, "it needs either a polygon or a circle")
        if area.polygon is not None:
            if any(len(vertex) != 2 for vertex in area.polygon):
                raise InputError(f"{here}.polygon", "every vertex must be [x, y]")
            polygons.append(checked_polygon(np.array(area.polygon) * unit, f"{here}.polygon"))
        if area.circle is not None:
            (x, y), radius = area.circle.center, area.circle.radius
            circles.append(checked_circle(Circle(x * unit, y * unit, radius * unit), f"{here}.circle"))
    return tuple(polygons), tuple(circles)


def _frame(keys: ScenarioKeys, file: FilePath) -> Frame | None:
    if keys.planet and keys.planet not in ELLIPSOIDS:
        remedy = suggestion(keys.planet, ELLIPSOIDS)
        raise InputError(f"{file}: planet", f"there is no planet {keys.planet!r}", remedy)
    if keys.origin is None:
        return None
    lat, lon = keys.origin
    if not (abs(lat) <= 90.0 and abs(lon) <= 180.0):
        raise InputError(f"{file}: origin", f"[{lat}, {lon}] is no place", "give [latitude, longitude] in degrees")
    return Frame(lat, lon, *ELLIPSOIDS[keys.planet or "earth"])
