"""Columns of numbers as a page carries them: few samples, as whole numbers in base64."""

from __future__ import annotations

import base64

import numpy as np

from planners.kernel import Floats, Ints
from reports.figures.decimate import envelope, polyline
from reports.files.json_result import Json
from tracking.track import Track

_FINE = 20.0  # of the corridor: how far the line through the samples may leave the track
_PIXELS = 1000  # across a plot
_COARSER = 2.0  # times the tolerance, until few enough points are left
_DIGITS = 9  # of what a column starts at and its step: less than the step of any of them


def samples(track: Track, corridor: float, most: int) -> Ints:
    """Indices of about `most` of the samples of `track`: even in time, and where its line, its error and its curvature
    bend most.
    """
    count = len(track)
    if count <= most:
        return np.arange(count)
    part = most // 4
    even = np.linspace(0, count - 1, part).astype(np.int64)
    series = [_bends_of_series(track["t"], track[name], part) for name in ("cross_track", "curvature")]
    return np.unique(np.concatenate([even, _bends_of_line(track, corridor, part), *series]))


def _bends_of_line(track: Track, corridor: float, most: int) -> Ints:
    xy = np.column_stack([track["x"], track["y"]])
    known = np.flatnonzero(np.isfinite(xy).all(axis=1))
    return known[_simplified(xy[known], corridor / _FINE, most)]


def _bends_of_series(t: Floats, values: Floats, most: int) -> Ints:
    """Where the plot of `values` over `t` bends, with every peak that is wider than a pixel."""
    drawn = envelope(t, values, _PIXELS)
    drawn = drawn[np.isfinite(values[drawn])]
    size = float(np.ptp(values[drawn])) if len(drawn) else 0.0
    if size == 0.0:
        return drawn[:1]
    plot = np.column_stack([t[drawn] / np.ptp(t), values[drawn] / size])
    return drawn[_simplified(plot, 1.0 / _PIXELS, most)]


def _simplified(line: Floats, tolerance: float, most: int) -> Ints:
    """Indices of `most` points that keep the line (N, 2), within `tolerance` if that is possible."""
    while len(kept := polyline(line, tolerance, 1)) > most:
        tolerance *= _COARSER
    return kept


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
