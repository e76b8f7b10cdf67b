"""Paths as CSV: columns x, y[, z] in metres, or lat, lon[, alt] in degrees and metres."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator

from planners.errors import InputError
from planners.files.points import (
    DEGREE_DIGITS,
    HEIGHT_DIGITS,
    geographic_path,
    local_path,
    on_earth,
    range_notes,
    to_degrees,
)
from planners.files.source import PathFile, Source
from planners.files.text import check_marks
from planners.path import Path

_COLUMNS = {
    "x": "x", "y": "y", "z": "z",
    "lat": "lat", "latitude": "lat", "lon": "lon", "lng": "lon", "long": "lon", "longitude": "lon",
    "alt": "z", "altitude": "z", "height": "z", "elevation": "z", "ele": "z",
}  # fmt: skip
_METRES = {"", "m", "metre", "metres", "meter", "meters"}
_DEGREES = {"", "deg", "degree", "degrees", "°"}
_FOREIGN = {
    "ft",
    "feet",
    "foot",
    "yd",
    "in",
    "mm",
    "cm",
    "km",
    "mi",
    "nm",
    "nmi",
    "rad",
    "radians",
    "e7",
    "1e7",
}
_TITLE = re.compile(r"([a-z]+)[\s_]*[\[(]?\s*([a-z0-9°]*)\s*[\])]?")
_KNOWN = "name the columns x, y[, z] in metres or lat, lon[, alt] in degrees and metres"


def read(source: Source) -> PathFile:
    """A path from CSV with a header, in any order of columns, or without one as x, y[, z] in metres.

    `#` starts a comment; a comment that only names columns, before the first row, is a header. Columns with
    other names are ignored with a note. Degrees are on WGS 84.
    """
    check_marks(source.text.count("\n"), source.place)
    rows = _rows(source)
    first_line, first = next(rows, (0, []))
    if not first:
        raise InputError(source.place, "is empty", "give one point a line")
    headless = all(_is_number(cell) for cell in first)
    if headless and len(first) not in (2, 3):
        raise InputError(f"{source.place}: line {first_line}", f"{len(first)} columns and no header", _KNOWN)
    titles = ["x", "y", "z"][: len(first)] if headless else first
    notes = ["no header: the columns are taken as x, y[, z] in metres"] if headless else []
    columns = _columns(titles, f"{source.place}: line {first_line}", notes)
    values: dict[str, list[float]] = {name: [] for name in columns}
    lines: list[int] = []
    if headless:
        rows = _rows(source)
    for line, row in rows:
        if len(row) != len(first):
            what = f"{len(row)} columns where line {first_line} has {len(first)}"
            raise InputError(f"{source.place}: line {line}", what, "give every line the same columns")
        for name, at in columns.items():
            values[name].append(_number(row[at], f"{source.place}: line {line}"))
        lines.append(line)

    def label(i: int) -> str:
        return f"line {lines[i]}"

    z = values.get("z")
    if "x" in columns:
        return PathFile(local_path(source, label, values["x"], values["y"], z), tuple(notes))
    path = geographic_path(source, label, values["lat"], values["lon"], z)
    return PathFile(path, (*notes, *range_notes(path)))


def write(path: Path, place: str) -> str:
    """The path as lat, lon[, alt] where it lies on Earth, else as x, y[, z] [m] without loss."""
    if on_earth(path):
        title = "lat,lon"
        rows = [f"{lat:.{DEGREE_DIGITS}f},{lon:.{DEGREE_DIGITS}f}" for lat, lon in to_degrees(path, place).tolist()]
    else:
        title = "x,y"
        rows = [f"{x!r},{y!r}" for x, y in path.xy.tolist()]
    if path.z is not None:
        title += ",alt" if on_earth(path) else ",z"
        heights = path.z.tolist()
        tails = [f"{z:.{HEIGHT_DIGITS}f}" for z in heights] if on_earth(path) else [repr(z) for z in heights]
        rows = [f"{row},{tail}" for row, tail in zip(rows, tails, strict=True)]
    return "\n".join([title, *rows, ""])


def _rows(source: Source) -> Iterator[tuple[int, list[str]]]:
    """The rows that are not empty, without comments, each with the number of its line."""
    reader = csv.reader(_lines(source.text))
    try:
        for row in reader:
            cells = [cell.strip() for cell in row]
            if any(cells):
                yield reader.line_num, cells
    except csv.Error as error:
        raise InputError(f"{source.place}: line {reader.line_num}", f"broken CSV: {error}") from None


def _lines(text: str) -> Iterator[str]:
    started = False
    for line in text.split("\n"):
        data, mark, comment = line.partition("#")
        if mark and not started and not data.strip() and _names_columns(comment):
            data = comment  # numpy.savetxt writes its header so
        started = started or bool(data.strip())
        yield data


def _names_columns(comment: str) -> bool:
    titles = [_TITLE.fullmatch(cell.strip().lower()) for cell in comment.split(",")]
    return len(titles) > 1 and all(title is not None and title[1] in _COLUMNS for title in titles)


def _columns(titles: list[str], place: str, notes: list[str]) -> dict[str, int]:
    """Where x, y or lat, lon, and z are; `place` names the header."""
    if len(titles) < 2:
        raise InputError(place, "there is only one column", "separate columns by commas")
    columns: dict[str, int] = {}
    for at, title in enumerate(titles):
        match = _TITLE.fullmatch(title.lower())
        name, unit = (_COLUMNS.get(match[1]), match[2]) if match else (None, "")
        units = _DEGREES if name in ("lat", "lon") else _METRES
        if name is None or unit not in units | _FOREIGN:
            notes.append(f"column {title!r} is ignored")
            continue
        if unit not in units:
            remedy = f"convert it to {'degrees' if units is _DEGREES else 'metres'}"
            raise InputError(place, f"column {title!r} has another unit", remedy)
        if name in columns:
            raise InputError(place, f"columns {titles[columns[name]]!r} and {title!r} mean the same", "leave one out")
        columns[name] = at
    metric, geographic = {"x", "y"} & columns.keys(), {"lat", "lon"} & columns.keys()
    if metric and geographic:
        raise InputError(place, "metres (x, y) and degrees (lat, lon) are mixed", "leave one pair out")
    if len(metric | geographic) < 2:
        raise InputError(place, f"no x and y, no lat and lon among {', '.join(map(repr, titles[:6]))}", _KNOWN)
    return columns


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell  # float() takes 1_000


def _number(cell: str, place: str) -> float:
    if not _is_number(cell):
        raise InputError(place, f"{cell[:40]!r} is not a number", "write numbers as 12.5")
    value = float(cell)
    if not math.isfinite(value):
        raise InputError(place, f"{cell!r} is not a finite number", "every coordinate must be finite")
    return value
