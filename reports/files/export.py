"""A run for other programs, by the file's suffix: spreadsheets, Google Earth, GIS and ground stations."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from planners.atomic_file import check_folder
from planners.errors import InputError
from planners.path import Path as PlannedPath
from reports.files.geographic import frame_of
from tracking.outcome import Outcome


def export(outcome: Outcome, file: str | Path) -> None:
    """Write `outcome` to `file` as `.csv`, `.kml`, `.geojson` or `.tlog`, whole or not at all.

    Raises `InputError` as `check` does.
    """
    check(outcome.path, file)
    SUFFIXES[Path(file).suffix.lower()](outcome, file)


def check(path: PlannedPath, file: str | Path) -> None:
    """Whether a run on `path` can be exported to `file`, so that it is known before the run.

    Raises `InputError` for an unknown suffix, for a path without a place on the planet, which all but CSV need, and
    where the folder does not exist.
    """
    suffix = Path(file).suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(
            str(file), f"cannot export {suffix or 'a file without a suffix'}", f"use {', '.join(SUFFIXES)}"
        )
    if suffix != ".csv":
        frame_of(path, f"a {suffix} file")
    check_folder(file)


def _csv(outcome: Outcome, file: str | Path) -> None:
    from reports.files.csv_file import write_csv

    write_csv(outcome, file)


def _kml(outcome: Outcome, file: str | Path) -> None:
    from reports.files.kml import write_kml

    write_kml(outcome, file)


def _geojson(outcome: Outcome, file: str | Path) -> None:
    from reports.files.geojson import write_geojson

    write_geojson(outcome, file)


def _tlog(outcome: Outcome, file: str | Path) -> None:
    from mavlink.tlog import write_tlog
    from planners.atomic_file import atomic

    with atomic(file) as temporary, open(temporary, "wb") as stream:
        write_tlog(outcome, stream)


SUFFIXES: dict[str, Callable[[Outcome, str | Path], None]] = {
    ".csv": _csv, ".kml": _kml, ".geojson": _geojson, ".tlog": _tlog,
}  # fmt: skip
