"""Missions as QGC WPL text, the plain-text format of MAVLink ground stations (mavlink.io, "File Formats")."""

from __future__ import annotations

from collections.abc import Iterator

from planners.errors import InputError
from planners.files import commands
from planners.files.mission import MissionItem, take_path, waypoint_positions
from planners.files.points import DEGREE_DIGITS, HEIGHT_DIGITS
from planners.files.source import PathFile, Source
from planners.files.text import check_marks
from planners.path import Path

HEADER = "QGC WPL"
WITH_HOME = "110"  # item 0 is home; version 120 is QGroundControl's own and has no home
FIELDS = 12  # index, current, frame, command, four parameters, latitude, longitude, altitude, autocontinue


def read(source: Source) -> PathFile:
    """The path of a QGC WPL 110 mission, whose item 0 is home, or 120, which has none."""
    check_marks(source.text.count("\n"), source.place)
    lines = _lines(source.text)
    number, header = next(lines, (1, ""))
    version = header.removeprefix(HEADER).strip()
    if not header.startswith(HEADER):
        raise _not_a_mission(header, f"{source.place}: line {number}")
    if version not in (WITH_HOME, "120"):
        place = f"{source.place}: line {number}"
        raise InputError(place, f"QGC WPL version {version!r} is not known", "export it as QGC WPL 110")
    items = [_item(line, f"{source.place}: line {number}") for number, line in lines]
    notes: list[str] = []
    home_alt: float | None = None
    if items and version == WITH_HOME:
        home = items[0]
        if home.command == commands.NAV_WAYPOINT:
            items = items[1:]
            home_alt = home.alt if home.frame in commands.ABSOLUTE_FRAMES else None
            notes.append(f"{home.label}: home, not a part of the path")
        else:
            notes.append(f"{home.label}: not home, as it should be, but a command of the mission")
    found = {item.command for item in items}
    if found and found <= commands.FENCE | commands.RALLY:
        what = "is a list of rally points" if found <= commands.RALLY else "is a geofence"
        raise InputError(source.place, f"{what}, not a mission", "give the file of the mission")
    mission = take_path(source, items, home_alt)
    return PathFile(mission.path, (*notes, *mission.notes), speed=mission.speed)


def write(path: Path, place: str) -> str:
    """The path, which must lie on Earth, as absolute waypoints, the first also home; no height is 0 m."""
    positions = [
        f"{lat:.{DEGREE_DIGITS}f}\t{lon:.{DEGREE_DIGITS}f}\t{z:.{HEIGHT_DIGITS}f}"
        for lat, lon, z in waypoint_positions(path, place)
    ]
    items = [
        f"{i}\t{int(i == 0)}\t{commands.FRAME_GLOBAL}\t{commands.NAV_WAYPOINT}\t0\t0\t0\t0\t{position}\t1"
        for i, position in enumerate([positions[0], *positions])
    ]
    return "\n".join([f"{HEADER} {WITH_HOME}", *items, ""])


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """The lines that are neither empty nor comments, with their numbers."""
    for number, line in enumerate(text.split("\n"), 1):
        stripped = line.strip()
        if stripped and not stripped.startswith("#"):
            yield number, stripped


def _item(line: str, place: str) -> MissionItem:
    cells = line.split()
    if len(cells) != FIELDS:
        raise InputError(place, f"{len(cells)} fields, an item has {FIELDS}", "correct it or export it again")
    values = [_number(cell, place) for cell in cells]
    index, _, frame, command = values[:4]
    for name, value in (("index", index), ("frame", frame), ("command", command)):
        if not value.is_integer():
            raise InputError(place, f"{name} {value} is not a whole number", "correct it or export it again")
    lat, lon, alt = values[8:11]
    return MissionItem(f"item {int(index)}", int(command), int(frame), values[5], lat, lon, alt)


def _number(cell: str, place: str) -> float:
    try:
        return float(cell)
    except ValueError:
        what = f"{cell[:40]!r} is not a number"
        raise InputError(place, what, "correct it or export it again") from None


def _not_a_mission(first: str, place: str) -> InputError:
    remedy = "give a mission saved as QGC WPL 110"
    if not first:
        return InputError(place, "the file is empty", remedy)
    if first.split()[0] == "RALLY":
        return InputError(place, "is an ArduPilot list of rally points, not a mission", remedy)
    cells = first.replace(",", " ").split()
    if len(cells) == 2 and all(cell.lstrip("+-").replace(".", "", 1).isdigit() for cell in cells):
        return InputError(place, "is a list of positions (an ArduPilot fence?), not a mission", remedy)
    return InputError(place, f"the first line is {first[:40]!r}, not 'QGC WPL 110'", remedy)
