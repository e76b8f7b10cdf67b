"""Path and mission files, read and written by suffix."""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from dataclasses import dataclass

from planners.atomic_file import check_folder
from planners.errors import InputError
from planners.files import csv_path, geojson, plan, waypoints
from planners.files.source import PathFile, Source
from planners.files.text import MAX_FILE_BYTES, MAX_POINTS, read_text, write_text
from planners.path import Path

__all__ = ["FORMATS", "MAX_FILE_BYTES", "MAX_POINTS", "Format", "PathFile", "check", "read", "write"]


@dataclass(frozen=True, slots=True)
class Format:
    """A kind of file: its `suffixes`, lower case, and how its text becomes a path and a path its text.

    `write` also gets the name of the file, for its errors.
    """

    name: str
    suffixes: tuple[str, ...]
    read: Callable[[Source], PathFile]
    write: Callable[[Path, str], str]


FORMATS = (
    Format("CSV", (".csv",), csv_path.read, csv_path.write),
    Format("GeoJSON", (".geojson", ".json"), geojson.read, geojson.write),
    Format("QGC WPL mission", (".waypoints", ".txt"), waypoints.read, waypoints.write),
    Format("QGroundControl plan", (".plan",), plan.read, plan.write),
)


def read(file: str | pathlib.Path) -> PathFile:
    """The path in `file`, its format told by the suffix.

    Raises `InputError` naming the file and the place in it when it cannot be read, is larger than
    `MAX_FILE_BYTES`, has more than `MAX_POINTS` points, or holds no single path.
    """
    form = _format(file)
    return form.read(Source(read_text(file), str(file), pathlib.Path(file).stem))


def write(path: Path, file: str | pathlib.Path) -> None:
    """Write `path` to `file`, whole or not at all, in the format that the suffix tells.

    Raises `InputError` when the format cannot hold the path or the file cannot be written, and
    `TrackworthyError` when the disk fails.
    """
    form = _format(file)
    write_text(file, form.write(path, str(file)))


def check(path: Path, file: str | pathlib.Path) -> None:
    """Whether `path` could be written to `file`; raises `InputError` as `write` does."""
    check_folder(file)
    _format(file).write(path, str(file))


def _format(file: str | pathlib.Path) -> Format:
    suffix = pathlib.Path(file).suffix.lower()
    for form in FORMATS:
        if suffix in form.suffixes:
            return form
    known = ", ".join(suffix for form in FORMATS for suffix in form.suffixes)
    what = f"unknown suffix {suffix!r}" if suffix else "a path file needs a suffix"
    raise InputError(str(file), what, f"known are {known}")
