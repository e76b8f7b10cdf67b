"""What of a mission is a path (MAVLink mission protocol): the step that all mission formats share."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from planners.errors import InputError
from planners.files import commands
from planners.files.points import HEIGHT_DIGITS, check_position, geographic_path, range_notes, to_degrees
from planners.files.source import PathFile, Source
from planners.path import Path

SAME_PLACE = 5e-8  # [deg] half the resolution of MISSION_ITEM_INT: the vehicle cannot tell such positions apart


@dataclass(frozen=True, slots=True)
class MissionItem:
    """One item: MAV_CMD `command` in MAV_FRAME `frame`, its place `label` in the file.

    `speed` is parameter 2; `lat`, `lon` [deg] and `alt` [m] are parameters 5 to 7. None stands for a value
    that was left out.
    """

    label: str
    command: int
    frame: int
    speed: float | None
    lat: float | None
    lon: float | None
    alt: float | None


def take_path(source: Source, items: Iterable[MissionItem], home_alt: float | None) -> PathFile:
    """The path through the waypoints of `items`, in a frame about the first one.

    Waypoints, splines (as corners) and the points of loiters are taken; take-off, landing, jumps and all
    other commands are skipped with a note, and so is an item in the place of the one before. Heights relative
    to home are lifted by `home_alt` [m], None, 0 or NaN if it is not known; so are heights over the terrain,
    of which there is no model. A height above mean sea level is taken as z: the geoid is not modelled.

    Raises `InputError` for a position that is none and for fewer than two waypoints, naming the item.
    """
    known = home_alt is not None and math.isfinite(home_alt)
    taker = _Taker(source.place, home_alt if known else None)
    for item in items:
        taker.take(item)
    return taker.result(source)


def waypoint_positions(path: Path, place: str) -> list[tuple[float, float, float]]:
    """Latitude, longitude [deg] and altitude [m] of each point, rounded as written; no height is 0 m.

    Raises `InputError` for a path that is not on Earth, and for a point at 0, 0: missions take it for none.
    """
    degrees = to_degrees(path, place)
    for i in np.flatnonzero((degrees == 0.0).all(axis=1))[:1]:
        what = f"point {i + 1} is at latitude 0, longitude 0: no position in a mission"
        raise InputError(place, what, "write it as .csv or .geojson")
    z = np.zeros(len(degrees)) if path.z is None else np.round(path.z, HEIGHT_DIGITS)
    return [(lat, lon, height) for (lat, lon), height in zip(degrees.tolist(), z.tolist(), strict=True)]


@dataclass(slots=True)
class _Taker:
    place: str
    home_alt: float | None
    labels: list[str] = field(default_factory=list)
    lat: list[float] = field(default_factory=list)
    lon: list[float] = field(default_factory=list)
    z: list[float] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)
    read_as: dict[str, list[str]] = field(default_factory=dict)
    last_z: float | None = None
    speed: float | None = None

    def take(self, item: MissionItem) -> None:
        """Add the point of one item, or say why there is none."""
        if item.command == commands.DO_CHANGE_SPEED:
            self._take_speed(item)
        elif item.command not in commands.TAKEN:
            self._skip_command(item)
        elif item.lat is None or item.lon is None or item.lat == item.lon == 0.0:
            self._skip(item, "no position")
        elif _reference(item.frame) is None:
            self._skip(item, f"frame {item.frame} gives no latitude and longitude")
        else:
            self._take_point(item, item.lat, item.lon)

    def result(self, source: Source) -> PathFile:
        """The path of all items taken."""
        count = len(self.labels)
        if count < 2:
            what = f"a path needs at least two waypoints, this mission has {count or 'none'}"
            first = f" (skipped: {len(self.skipped)}, first {self.skipped[0]})" if self.skipped else ""
            raise InputError(self.place, what + first, "add waypoints (NAV_WAYPOINT, 16) with a position")
        path = geographic_path(source, self.labels.__getitem__, self.lat, self.lon, self.z)
        read_as = [f"{_joined(labels)}: {how}" for how, labels in self.read_as.items()]
        return PathFile(path, (*self.skipped, *read_as, *range_notes(path)), speed=self.speed)

    def _take_point(self, item: MissionItem, lat: float, lon: float) -> None:
        place = f"{self.place}: {item.label}"
        check_position(lat, lon, place)
        z = self._height(item, place)
        self.last_z = z
        if self.labels and _same_place(lat, lon, self.lat[-1], self.lon[-1]):
            climb = ", only the height differs" if z != self.z[-1] else ""
            self._skip(item, f"the same place as {self.labels[-1]}{climb}")
            return
        self.labels.append(item.label)
        self.lat.append(lat)
        self.lon.append(lon)
        self.z.append(z)
        if item.command in commands.LOITERS:
            self._skip(item, "its point is taken, the circles are not flown")
        elif item.command == commands.NAV_SPLINE_WAYPOINT:
            self._read_as(item, "a spline is taken as a corner, its curve is not modelled")

    def _height(self, item: MissionItem, place: str) -> float:
        if item.alt is None:
            if self.last_z is None:
                self._read_as(item, "no altitude, taken as that of home")
                return self.home_alt or 0.0
            self._read_as(item, "no altitude, taken as that of the item before")
            return self.last_z
        if not math.isfinite(item.alt):
            raise InputError(place, f"altitude {item.alt} is not a finite number", "give metres")
        reference = _reference(item.frame)
        if reference == "absolute":
            return item.alt
        if reference == "terrain":
            self._read_as(item, "heights above the terrain are taken as above home, there is no terrain model")
        if not self.home_alt:
            self._read_as(item, "the altitude of home is not known, heights relative to it are taken as above 0 m")
        return item.alt + (self.home_alt or 0.0)

    def _take_speed(self, item: MissionItem) -> None:
        if item.speed is None or not 0.0 < item.speed < math.inf:
            self._skip(item, "it sets no speed")
        elif len(self.labels) > 1:
            self._skip(item, f"a change to {item.speed:g} m/s along the path is not flown")
        else:
            self.speed = item.speed

    def _skip_command(self, item: MissionItem) -> None:
        if item.command in commands.TAKEOFFS:
            if item.alt is not None and math.isfinite(item.alt) and _reference(item.frame) is not None:
                relative = _reference(item.frame) != "absolute"
                self.last_z = item.alt + ((self.home_alt or 0.0) if relative else 0.0)
            self._skip(item, "the take-off is not flown, the path starts at the first waypoint")
        elif item.command in commands.LANDINGS:
            self._skip(item, "the landing is not flown, the path ends at the last waypoint")
        elif item.command == commands.NAV_RETURN_TO_LAUNCH:
            self._skip(item, "the way home is not flown")
        elif item.command == commands.DO_JUMP:
            self._skip(item, "loops are flown once")
        elif item.command in commands.FENCE | commands.RALLY:
            self._skip(item, "fence and rally points are not part of a path")
        elif item.command in commands.NAMES:
            self._skip(item, "it is no waypoint")
        else:
            self._skip(item, "unknown command")

    def _skip(self, item: MissionItem, why: str) -> None:
        name = commands.NAMES.get(item.command, "command")
        self.skipped.append(f"{item.label}: {name} ({item.command}): {why}")

    def _read_as(self, item: MissionItem, how: str) -> None:
        self.read_as.setdefault(how, []).append(item.label)


def _reference(frame: int) -> str | None:
    """What altitudes in MAV_FRAME `frame` are above; None if it has no latitudes and longitudes."""
    if frame in commands.ABSOLUTE_FRAMES:
        return "absolute"
    if frame in commands.RELATIVE_FRAMES:
        return "home"
    return "terrain" if frame in commands.TERRAIN_FRAMES else None


def _same_place(lat: float, lon: float, other_lat: float, other_lon: float) -> bool:
    across = abs((lon - other_lon + 180.0) % 360.0 - 180.0)
    return abs(lat - other_lat) <= SAME_PLACE and across <= SAME_PLACE


def _joined(labels: list[str]) -> str:
    return labels[0] if len(labels) == 1 else f"{labels[0]} and {len(labels) - 1} more"
