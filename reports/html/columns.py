"""Columns of numbers as a page carries them: few samples, as whole numbers in base64."""

from __future__ import annotations

import base64

import numpy as np

from planners.kernel import Floats, Ints
from reports.decimate import envelope, polyline
from reports.json_result import Json
from tracking.track import Track

_FINE = 20.0  # of the corridor: how far the line through the samples may leave the track
_COARSER = 2.0  # times the tolerance, until few enough points are left
_DIGITS = 9  # of what a column starts at and its step: less than the step of any of them


def samples(track: Track, corridor: float, most: int) -> Ints:
    """Indices of about `most` of the samples of `track`: even in time, at bends of its line, and where the error and
    the curvature are extreme.
    """
    count = len(track)
    if count <= most:
        return np.arange(count)
    part = most // 4
    even = np.linspace(0, count - 1, part).astype(np.int64)
    return np.unique(
        np.concatenate([
            even, _bends(track, corridor, part),
            envelope(track["s"], track["cross_track"], part // 2), envelope(track["s"], track["curvature"], part // 2),
        ])
    )  # fmt: skip


def _bends(track: Track, corridor: float, most: int) -> Ints:
    xy = np.column_stack([track["x"], track["y"]])
    known = np.flatnonzero(np.isfinite(xy).all(axis=1))
    line, tolerance = xy[known], corridor / _FINE
    while len(kept := polyline(line, tolerance, 1)) > most:
        tolerance *= _COARSER
    found: Ints = known[kept]
    return found


def packed(values: Floats, wide: bool = False) -> Json:
    """The values (N,) as [lowest, step, codes], codes being base64 of little-endian whole numbers of two bytes, or four
    where `wide`; the largest code is NaN. Codes are "" where all values are the same, the lowest then.
    """
    known = np.isfinite(values)
    low, high = (float(np.min(values[known])), float(np.max(values[known]))) if known.any() else (0.0, 0.0)
    if known.all() and low == high:
        return [_short(low), 0, ""]
    kind = np.dtype("<u4" if wide else "<u2")
    nothing = int(np.iinfo(kind).max)
    step = (high - low) / (nothing - 1) or 1.0
    codes = np.full(len(values), nothing, dtype=kind)
    codes[known] = np.clip(np.round((values[known] - low) / step), 0, nothing - 1)
    return [_short(low), _short(step), base64.b64encode(codes.tobytes()).decode()]


def _short(value: float) -> float:
    return float(f"{value:.{_DIGITS}g}")


class Pool:
    """Packed columns, each of them once."""

    def __init__(self) -> None:
        self.columns: list[Json] = []

    def add(self, values: Floats, wide: bool = False) -> int:
        """The place of the packed `values` in the pool."""
        column = packed(values, wide)
        if column not in self.columns:
            self.columns.append(column)
        return self.columns.index(column)
