"""Cross-track error: signed distance to the path, weighted by the distance flown, unreached path included."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.spatial import cKDTree

from planners.kernel import Bools, Floats
from tracking.metric import Metric, Where
from tracking.run import Run

LEAST = 20  # samples of a gap, however short
SKIPPED = 3.0  # times the distance flown: where the projection moves on by more, path was left out


@dataclass(frozen=True, slots=True)
class Errors:
    """Samples of the cross-track error `e` [m] with weights [m], arc lengths `s` [m] and times `t` [s].

    The first `flown` samples are of the track; the rest are path that was skipped or not reached, a sample a metre or
    denser, each with its distance to where the vehicle was from then on, and no time.
    """

    e: Floats
    weight: Floats
    s: Floats
    t: Floats
    flown: int

    def where(self, sample: int) -> Where:
        """Arc length and time of the sample of that index."""
        return Where(s=float(self.s[sample]), t=float(self.t[sample]))

    def missed(self, corridor: float) -> Bools:
        """Which samples are path that the vehicle did not come near, and never passed: beyond `corridor` [m]."""
        left_out = np.arange(len(self.e)) >= self.flown
        return np.asarray(left_out & (np.abs(self.e) > corridor))


@lru_cache(maxsize=1)
def cross_track_errors(run: Run) -> Errors:
    """The track's errors, and those of the path that it left out; three metrics ask for the same run's."""
    track = run.track
    e, s, t = track["cross_track"], track["s"], track["t"]
    weight = centred_weights(track.distance)
    # On the side of the bias, so that it never looks smaller for what was not flown
    bias = float(np.sum(e * weight))
    pieces = [_left_out(run, *gap) for gap in gaps(run)]
    at, length, distance = (np.concatenate([[], *(piece[k] for piece in pieces)]) for k in range(3))
    return Errors(
        np.concatenate([e, np.copysign(distance, bias)]),
        np.concatenate([weight, length]),
        np.concatenate([s, at]),
        np.concatenate([t, np.full(len(at), np.nan)]),
        len(e),
    )


def gaps(run: Run) -> list[tuple[float, float, int]]:
    """Stretches of path, from and to [m], that were left out after the track's sample of that index.

    The projection moves along the path as the vehicle does, or a little faster inside a curve; where it leaps, the
    vehicle took a shortcut. What lies beyond the last sample was not reached.
    """
    s = np.clip(run.track["s"], 0.0, run.path.length)
    leaps = np.flatnonzero(np.diff(s) > SKIPPED * np.diff(run.track.distance) + 1e-6)
    found = [(float(s[i]), float(s[i + 1]), int(i)) for i in leaps]
    if s[-1] < run.path.length:
        found.append((float(s[-1]), run.path.length, len(s) - 1))
    return found


def _left_out(run: Run, s_from: float, s_to: float, sample: int) -> tuple[Floats, Floats, Floats]:
    """Samples of a gap: arc lengths, weights, and distances to the nearest point flown from then on."""
    count = max(LEAST, int(np.ceil(s_to - s_from)))
    edges = np.linspace(s_from, s_to, count + 1)
    middles = (edges[1:] + edges[:-1]) / 2
    xy = np.column_stack([np.interp(middles, run.path.s, column) for column in run.path.xy.T])
    later = np.column_stack([run.track["x"], run.track["y"]])[sample:]
    return middles, np.diff(edges), cKDTree(later).query(xy)[0]


def centred_weights(at: Floats) -> Floats:
    """Half of the way to each neighbour, for samples at positions or times `at` (N,)."""
    if len(at) < 2:
        return np.ones(len(at))
    half = np.diff(at) / 2
    weights: Floats = np.concatenate([half, [0.0]]) + np.concatenate([[0.0], half])
    return weights


def weighted_quantile(values: Floats, weight: Floats, share: float) -> float:
    """The smallest value that at least `share` of the weight does not exceed."""
    order = np.argsort(values, kind="stable")
    cumulative = np.cumsum(weight[order])
    index = np.searchsorted(cumulative, share * cumulative[-1] * (1.0 - 1e-12))
    return float(values[order[min(index, len(order) - 1)]])


def cross_track(run: Run) -> list[Metric]:
    """Mean (bias), rms, percentiles and maximum of the cross-track error [m].

    ISO 12188-2; MAVLink `xtrack_error`; the 95th percentile is the flight technical error of ICAO's PBN manual.
    """
    errors = cross_track_errors(run)
    size, weight = np.abs(errors.e), errors.weight
    total = weight.sum()
    if total == 0.0:
        weight, total = np.ones(len(size)), float(len(size))
    worst = int(np.argmax(size))
    values = {
        "mean": float(np.sum(errors.e * weight) / total),
        "rms": float(np.sqrt(np.sum(size**2 * weight) / total)),
        "p50": weighted_quantile(size, weight, 0.50),
        "p95": weighted_quantile(size, weight, 0.95),
        "p99": weighted_quantile(size, weight, 0.99),
    }
    better = {"mean": "neither"}
    metrics = [Metric(f"cross_track_{name}", value, "m", better.get(name, "lower")) for name, value in values.items()]
    return [*metrics, Metric("cross_track_max", float(size[worst]), "m", **errors.where(worst))]
