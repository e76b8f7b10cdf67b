"""What goes where: results on standard output, everything else on standard error."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path


def tell(notes: Iterable[str]) -> None:
    """Each note as a line on standard error."""
    for note in notes:
        print(note, file=sys.stderr)


def numbered(file: str, count: int) -> list[str]:
    """The files of a fleet of `count`, numbered before the suffix; that of a single vehicle is `file` itself."""
    name = Path(file)
    return [str(name.with_stem(f"{name.stem}-{i}")) for i in range(1, count + 1)] if count > 1 else [file] * count


def protect(output: str, *inputs: str) -> None:
    """Refuse an output that would overwrite one of the inputs; raises `InputError`."""
    from planners.errors import InputError

    for file in inputs:
        if os.path.exists(output) and os.path.exists(file) and os.path.samefile(output, file):
            raise InputError(output, "it would overwrite what is read", "give another name")


def check_picture(file: str) -> None:
    """Whether `file` can be a picture; raises `InputError` for another suffix, or a folder that does not exist."""
    from planners.atomic_file import check_folder
    from planners.errors import InputError

    if os.path.splitext(file)[1].lower() not in (".png", ".svg"):
        raise InputError(file, "a picture is a .png or a .svg file", "give it one of these suffixes")
    check_folder(file)


@contextmanager
def chatter_to_stderr() -> Iterator[None]:
    """Send what simulators print on standard output, from C++ too, to standard error instead."""
    sys.stdout.flush()
    kept = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
