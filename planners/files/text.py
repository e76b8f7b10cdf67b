"""Text files within limits: read whole, written whole."""

from __future__ import annotations

import os
import pathlib
import stat

from planners.atomic_file import atomic
from planners.errors import InputError

MAX_FILE_BYTES = 64 * 2**20  # a million points take about 40 MB as CSV with ten decimals
MAX_POINTS = 1_000_000
_OTHER_MARKS = 1000  # lines or arrays that are no points: header, comments, fence


def read_text(file: str | pathlib.Path) -> str:
    """The text of a regular file in UTF-8, with or without a byte order mark, lines ended by a line feed."""
    place = str(file)
    try:
        status = os.stat(file)
        if stat.S_ISDIR(status.st_mode):
            raise InputError(place, "is a directory", "give a file")
        if not stat.S_ISREG(status.st_mode):
            raise InputError(place, "is not a regular file", "save the data in a file first")
        _check_size(status.st_size, place)
        with open(file, "rb") as stream:
            raw = stream.read(MAX_FILE_BYTES + 1)
    except FileNotFoundError:
        raise InputError(place, "no such file", "check the name") from None
    except (OSError, ValueError) as error:
        raise InputError(place, f"cannot be read: {_reason(error)}") from None
    _check_size(len(raw), place)
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise InputError(f"{place}: line {line}", "is not UTF-8 text", "save the file as UTF-8") from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def write_text(file: str | pathlib.Path, text: str) -> None:
    """Write `text` to `file` by atomic rename, so that a reader never meets half of it."""
    with atomic(file) as part:
        part.write_text(text, encoding="utf-8", newline="\n")


def check_marks(count: int, place: str) -> None:
    """Refuse text with far more marks than `MAX_POINTS`, before it is parsed; every point has one mark."""
    check_count(max(count - _OTHER_MARKS, 0), place)


def check_count(count: int, place: str) -> None:
    """Refuse more than `MAX_POINTS` points."""
    if count > MAX_POINTS:
        raise InputError(place, f"{count} points are over the limit of {MAX_POINTS}", "split or simplify the path")


def _check_size(size: int, place: str) -> None:
    if size > MAX_FILE_BYTES:
        limit = f"the limit of {MAX_FILE_BYTES // 2**20} MiB"
        raise InputError(place, f"is larger than {limit}", "split or simplify the path")


def _reason(error: Exception) -> str:
    return (error.strerror if isinstance(error, OSError) else None) or str(error)
