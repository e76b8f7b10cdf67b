"""One way to compile numeric kernels: plain arrays and floats in, cached on disk."""

from __future__ import annotations

import hashlib
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import ParamSpec, TypeVar, cast

import numba
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]

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
    beside = code / "__pycache__"
    for base in (beside, Path.home() / ".cache" / "trackworthy"):
        folder = base / f"kernels-{digest.hexdigest()[:16]}"
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError:
            continue
        if os.access(folder, os.W_OK):
            if base == beside:
                for old in base.glob("kernels-*"):
                    if old != folder:
                        shutil.rmtree(old, ignore_errors=True)
            return folder
    return None


if not getattr(numba.config, "CACHE_DIR", ""):  # a user's NUMBA_CACHE_DIR counts
    setattr(numba.config, "CACHE_DIR", str(_cache_folder(Path(__file__).parent) or ""))  # noqa: B010, it is made at run time
