"""The geofence of a QGroundControl plan, version 2, as a Map."""

from __future__ import annotations

import msgspec
import numpy as np

from planners.errors import InputError
from planners.files.points import check_position
from planners.frame import Frame
from planners.kernel import Floats
from planners.map import Circle, Map, checked_circle, checked_polygon
from planners.path import Path


class _Polygon(msgspec.Struct):
    polygon: list[list[float]]
    inclusion: bool = True


class _Disc(msgspec.Struct):
    center: list[float]
    radius: float


class _Circle(msgspec.Struct):
    circle: _Disc
    inclusion: bool = True


class GeoFence(msgspec.Struct):
    """The `geoFence` of a plan; `polygon` is the one of version 1."""

    polygons: list[_Polygon] = []
    circles: list[_Circle] = []
    polygon: list[msgspec.Raw] = []


def fence_map(fence: GeoFence, path: Path, place: str, notes: list[str]) -> Map | None:
    """The fence in the frame of `path`: inclusions to stay in, exclusions to stay out of; None without areas.

    Raises `InputError` naming the area that is none, at `place`.
    """
    if path.frame is None:
        return None
    if fence.polygon:
        notes.append("geoFence: a fence of version 1 is skipped; save the plan again with a newer QGroundControl")
    rings: dict[bool, list[Floats]] = {True: [], False: []}
    circles: dict[bool, list[Circle]] = {True: [], False: []}
    for i, polygon in enumerate(fence.polygons, 1):
        at = f"{place}: geoFence polygon {i}"
        ring = checked_polygon(_local(polygon.polygon, path.frame, at), at)
        rings[polygon.inclusion].append(ring)
    for i, circle in enumerate(fence.circles, 1):
        at = f"{place}: geoFence circle {i}"
        x, y = _local([circle.circle.center], path.frame, at)[0].tolist()
        circles[circle.inclusion].append(checked_circle(Circle(x, y, circle.circle.radius), at))
    if len(rings[True]) + len(circles[True]) > 1:
        notes.append("geoFence: the path must stay inside all inclusion areas; PX4 is content with any one of them")
    if not any([*rings.values(), *circles.values()]):
        return None
    return Map(
        polygons=tuple(rings[False]),
        circles=tuple(circles[False]),
        keep_in=tuple(rings[True]),
        keep_in_circles=tuple(circles[True]),
        frame=path.frame,
    )


def _local(positions: list[list[float]], frame: Frame, place: str) -> Floats:
    """Positions of latitude, longitude[, altitude] [deg, m] as x, y [m], (N, 2)."""
    for position in positions:
        if len(position) < 2:
            raise InputError(place, f"{position} is not a position", "give latitude, longitude")
        check_position(position[0], position[1], place)
    columns = np.array([position[:2] for position in positions], dtype=float).reshape(-1, 2)
    return frame.to_local(columns[:, 0], columns[:, 1])
