"""Columns of coordinates to a Path and back, with errors that name the row."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from planners.errors import InputError
from planners.files.source import Source
from planners.files.text import check_count
from planners.frame import FAITHFUL_RANGE, WGS84_A, WGS84_B, Frame
from planners.kernel import Floats
from planners.path import FARTHEST, Path

DEGREE_DIGITS = 10  # decimals of a degree written: 0.01 mm on the ground
HEIGHT_DIGITS = 6  # decimals of a metre written

Column = Sequence[float] | Floats
Label = Callable[[int], str]


def local_path(source: Source, label: Label, x: Column, y: Column, z: Column | None) -> Path:
    """A path from coordinates [m], each (N,); `label` names a row by its index."""
    return _path(source, label, np.column_stack([x, y]), z, None)


def geographic_path(source: Source, label: Label, lat: Column, lon: Column, z: Column | None) -> Path:
    """A path in the frame about its first point; latitudes, longitudes [deg] and heights [m], each (N,)."""
    lat, lon = np.asarray(lat, dtype=float), np.asarray(lon, dtype=float)
    for i in np.flatnonzero(~((np.abs(lat) <= 90.0) & (np.abs(lon) <= 180.0)))[:1]:
        check_position(float(lat[i]), float(lon[i]), f"{source.place}: {label(int(i))}")
    if not len(lat):
        return _path(source, label, np.empty((0, 2)), z, None)
    frame = Frame(float(lat[0]), float(lon[0]))
    return _path(source, label, frame.to_local(lat, lon), z, frame)


def check_position(lat: float, lon: float, place: str) -> None:
    """Refuse a latitude or a longitude [deg] that is none."""
    for name, value, limit in (("latitude", lat, 90.0), ("longitude", lon, 180.0)):
        if not abs(value) <= limit:
            remedy = "give degrees, and check the order of latitude and longitude"
            raise InputError(place, f"{name} {value} is not within +-{limit:g} degrees", remedy)


def range_notes(path: Path) -> tuple[str, ...]:
    """A note for a geographic path that goes farther from its first point than its frame is faithful."""
    reach = float(np.hypot(*(path.xy - path.xy[0]).T).max())
    if path.frame is None or reach <= FAITHFUL_RANGE:
        return ()
    return (f"the path goes {reach / 1e3:.0f} km from its first point; distances across it are stretched there",)


def to_degrees(path: Path, place: str) -> Floats:
    """Latitudes and longitudes [deg] of the path, (N, 2), rounded as written."""
    if path.frame is None:
        raise InputError(place, "the path has no place on Earth, its coordinates are metres", "write it as .csv")
    if not on_earth(path):
        raise InputError(place, "the path is not on Earth, and the format knows only WGS 84", "write it as .csv")
    return np.round(path.frame.to_geographic(path.xy), DEGREE_DIGITS)


def on_earth(path: Path) -> bool:
    """Whether the frame of the path is known and is one of WGS 84."""
    return path.frame is not None and (path.frame.a, path.frame.b) == (WGS84_A, WGS84_B)


def _path(source: Source, label: Label, xy: Floats, z: Column | None, frame: Frame | None) -> Path:
    place = source.place
    check_count(len(xy), place)
    points = xy if z is None else np.column_stack([xy, np.asarray(z, dtype=float)])
    for i in np.flatnonzero(~(np.abs(points) <= FARTHEST).all(axis=1))[:1]:
        what = f"{points[i].tolist()} is beyond {FARTHEST:g} m"
        raise InputError(f"{place}: {label(int(i))}", what, "give coordinates in a local frame")
    for i in np.flatnonzero((np.diff(xy, axis=0) == 0.0).all(axis=1))[:1]:
        what = f"the point is in the same place as {label(int(i))}, or straight above it"
        raise InputError(f"{place}: {label(int(i) + 1)}", what, "leave one of them out")
    if len(xy) < 2:
        raise InputError(place, f"a path needs at least two points, this has {len(xy)}", "add points")
    return Path(points, frame, source.name)
