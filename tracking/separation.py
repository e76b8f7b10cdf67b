"""How far apart vehicles are that are under way at the same time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from planners.kernel import Floats
from tracking.metric import Metric
from tracking.track import Track

STEP = 0.25  # [s] between the times at which distances are shown
PLACE = ("x", "y", "z")


@dataclass(frozen=True, slots=True, eq=False)
class Separation:
    """The distances (N, P) [m] of the `pairs` of vehicles, P of them, at the times `t` (N,) [s].

    NaN while one of a pair is not under way. Vehicles are numbered from 0 here, from 1 where people read it.
    """

    t: Floats
    pairs: tuple[tuple[int, int], ...]
    distances: Floats


def separation(tracks: Sequence[Track], departures: Sequence[float]) -> Separation:
    """Those of two `tracks` or more that begin at `departures` [s] after the first time of all."""
    ends = [float(track["t"][-1]) + departure for track, departure in zip(tracks, departures, strict=True)]
    t = np.arange(0.0, max(ends) + STEP, STEP)
    places = [_at(track, t - departure) for track, departure in zip(tracks, departures, strict=True)]
    pairs = tuple(combinations(range(len(tracks)), 2))
    distances = np.column_stack([np.linalg.norm(places[i] - places[j], axis=1) for i, j in pairs])
    return Separation(t, pairs, distances)


def separation_min(apart: Separation) -> Metric:
    """The smallest distance [m] of two vehicles at the same time; infinite where never two are under way."""
    known = np.where(np.isnan(apart.distances), np.inf, apart.distances)
    row, pair = np.unravel_index(np.argmin(known), known.shape)
    first, second = apart.pairs[pair]
    least = float(known[row, pair])
    if np.isinf(least):
        return Metric("separation_min", least, "m", "higher", note="never two under way at the same time")
    who = f"{first + 1} and {second + 1}"
    return Metric("separation_min", least, "m", "higher", t=float(apart.t[row]), who=who)


def _at(track: Track, t: Floats) -> Floats:
    """Where the vehicle was (N, 3) [m] at times `t` (N,) of its own clock [s]; NaN before its start, after its end."""
    own = track["t"]
    return np.column_stack([np.interp(t, own, track[axis], left=np.nan, right=np.nan) for axis in PLACE])
