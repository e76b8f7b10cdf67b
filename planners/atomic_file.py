"""Files appear whole or not at all."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from planners.errors import InputError, TrackworthyError

DISK_FAILURES = {errno.ENOSPC, errno.EIO, errno.EDQUOT, errno.EROFS, errno.EFBIG}  # the machine's fault, not the user's


@contextmanager
def atomic(file: str | Path) -> Iterator[Path]:
    """A name in the same folder to write to; it becomes `file` when the block ends, and vanishes if the block fails.

    Raises `InputError` where the folder does not exist or may not be written to, `TrackworthyError` where the disk does
    not take the file.
    """
    check_folder(file)
    final = Path(file)
    # The process id keeps workers that write the same file at the same time out of each other's way.
    temporary = final.with_name(f".{final.name}.{os.getpid()}.tmp")
    try:
        yield temporary
        os.replace(temporary, final)
    except OSError as error:
        what = f"cannot be written: {error.strerror or error}"
        if error.errno in DISK_FAILURES:
            raise TrackworthyError(f"{final}: {what}") from error
        raise InputError(str(final), what) from error
    finally:
        temporary.unlink(missing_ok=True)


def check_folder(file: str | Path) -> None:
    """Whether `file` names a file in a folder that exists; raises `InputError` if not."""
    final = Path(file)
    if "\0" in str(file):
        raise InputError(repr(str(file)), "cannot be written: no file has such a name")
    if not final.parent.is_dir():
        raise InputError(str(file), f"the folder {final.parent} does not exist", "create it first")
    if final.is_dir():
        raise InputError(str(file), "this is a folder", "give the name of a file")
