"""One way to compile numeric kernels: plain arrays and floats in, cached on disk."""

from __future__ import annotations

import hashlib
import os
import shutil
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import ParamSpec, TypeVar, cast

import numba
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]
Bytes = NDArray[np.uint8]

DAY = 86_400.0  # [s]

P = ParamSpec("P")
R = TypeVar("R")


def kernel(function: Callable[P, R]) -> Callable[P, R]:
    """Compile with numba, without fast-math, so that every machine and every run gives the same bits."""
    return cast("Callable[P, R]", numba.njit(cache=True)(function))


def _cache_folder(code: Path) -> Path | None:
    """Where compiled kernels of just this code are kept; None where no place takes them but numba's own.

    A compiled kernel holds the kernels it calls, but numba looks at no file but its own to see whether it is stale: a
    change in another would leave old machine code, or crash. So the folder is named after all files.
    """
    digest = hashlib.sha256()
    for file in sorted(code.rglob("*.py")):
        digest.update(file.read_bytes())
    for base in (code / "__pycache__", Path.home() / ".cache" / "trackworthy"):
        folder = base / f"kernels-{digest.hexdigest()[:16]}"
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError:
            continue
        if os.access(folder, os.W_OK):
            _forget_others(folder)
            return folder
    return None


def _forget_others(folder: Path) -> None:
    """Remove the kernels of code that has not been run for a day; what is younger may be of a process still at work."""
    folder.touch()
    for other in folder.parent.glob("kernels-*"):
        with suppress(OSError):
            if other.stat().st_mtime < time.time() - DAY:
                shutil.rmtree(other)


if not getattr(numba.config, "CACHE_DIR", ""):  # a user's NUMBA_CACHE_DIR counts
    setattr(numba.config, "CACHE_DIR", str(_cache_folder(Path(__file__).parent) or ""))  # noqa: B010, it is made at run time
