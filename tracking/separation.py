"""How far apart vehicles are that are under way at the same time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from planners.kernel import Floats
from planners.path import FARTHEST
from tracking.metric import Metric
from tracking.track import Track

STEP = 0.05  # [s] between the times at which distances are taken
PLACE = ("x", "y", "z")


@dataclass(frozen=True, slots=True, eq=False)
class Separation:
    """The `vectors` (P, N, 3) [m] from one to the other of the `pairs` of vehicles, at the times `t` (N,) [s].

    NaN while one of a pair is not under way. Vehicles are numbered from 0 here, from 1 where people read it.
    """

    t: Floats
    pairs: tuple[tuple[int, int], ...]
    vectors: Floats

    @property
    def distances(self) -> Floats:
        """The distances (N, P) [m] of the pairs."""
        return np.asarray(np.linalg.norm(self.vectors, axis=2).T)


def separation(tracks: Sequence[Track], departures: Sequence[float]) -> Separation:
    """Those of two `tracks` or more that begin at `departures` [s] after the first time of all."""
    ends = [float(track["t"][-1]) + departure for track, departure in zip(tracks, departures, strict=True)]
    t = np.arange(0.0, max(ends) + STEP, STEP)
    places = [_at(track, t - departure) for track, departure in zip(tracks, departures, strict=True)]
    pairs = tuple(combinations(range(len(tracks)), 2))
    return Separation(t, pairs, np.stack([places[i] - places[j] for i, j in pairs]))


def separation_min(apart: Separation) -> Metric:
    """The smallest distance [m] of two vehicles at the same time, also between the times shown.

    Where never two are under way, they are as far apart as on any planet.
    """
    found = [(*nearest(vectors), i) for i, vectors in enumerate(apart.vectors)]
    least, step, pair = min(found, key=lambda one: one[0])
    if np.isinf(least):
        return Metric("separation_min", FARTHEST, "m", "higher", note="never two under way at the same time")
    first, second = apart.pairs[pair]
    return Metric("separation_min", least, "m", "higher", t=STEP * step, who=f"{first + 1} and {second + 1}")


def nearest(apart: Floats) -> tuple[float, float]:
    """The smallest length [m] of a vector that moves straight between the places `apart` (N, 3), and after how many
    steps; infinite where none of them is known.
    """
    moved = np.diff(apart, axis=0)
    along = np.einsum("ij,ij->i", moved, moved)
    share = np.clip(-np.einsum("ij,ij->i", apart[:-1], moved) / np.where(along > 0.0, along, 1.0), 0.0, 1.0)
    between = np.linalg.norm(apart[:-1] + share[:, None] * moved, axis=1)
    lengths = np.concatenate([between, np.linalg.norm(apart, axis=1)])
    lengths[np.isnan(lengths)] = np.inf
    least = int(np.argmin(lengths)) if len(lengths) else -1
    if least < 0 or np.isinf(lengths[least]):
        return float("inf"), 0.0
    return float(lengths[least]), float(least + share[least]) if least < len(between) else float(least - len(between))


def _at(track: Track, t: Floats) -> Floats:
    """Where the vehicle was (N, 3) [m] at times `t` (N,) of its own clock [s]; NaN before its start, after its end."""
    own = track["t"]
    return np.column_stack([np.interp(t, own, track[axis], left=np.nan, right=np.nan) for axis in PLACE])
