"""Cross-track error: signed distance to the path, weighted by the distance flown, unreached path included."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from planners.kernel import Floats
from tracking.metric import Metric, Where
from tracking.run import Run


@dataclass(frozen=True, slots=True)
class Errors:
    """Samples of the cross-track error `e` [m] with weights [m], arc lengths `s` [m] and times `t` [s].

    The first `flown` samples are of the track; the rest are the unreached path, a sample a metre, each with its
    distance to the nearest flown point and no time.
    """

    e: Floats
    weight: Floats
    s: Floats
    t: Floats
    flown: int

    def where(self, sample: int) -> Where:
        """Arc length and time of the sample of that index."""
        return Where(s=float(self.s[sample]), t=float(self.t[sample]))


def cross_track_errors(run: Run) -> Errors:
    """The track's errors, and the unreached path's."""
    track = run.track
    e, s, t = track["cross_track"], track["s"], track["t"]
    weight = centred_weights(track.distance)
    missing = unreached(run)
    xy = np.array([run.path.point_at(float(at)) for at in missing]).reshape(-1, 2)
    distance = cKDTree(np.column_stack([track["x"], track["y"]])).query(xy)[0] if len(missing) else missing
    # On the side of the bias, so that it never looks smaller for what was not flown
    bias = float(np.sum(e * weight))
    return Errors(
        np.concatenate([e, np.copysign(distance, bias)]),
        np.concatenate([weight, np.ones(len(missing))]),
        np.concatenate([s, missing]),
        np.concatenate([t, np.full(len(missing), np.nan)]),
        len(e),
    )


def centred_weights(at: Floats) -> Floats:
    """Half of the way to each neighbour, for samples at positions or times `at` (N,)."""
    if len(at) < 2:
        return np.ones(len(at))
    half = np.diff(at) / 2
    weights: Floats = np.concatenate([half, [0.0]]) + np.concatenate([[0.0], half])
    return weights


def unreached(run: Run) -> Floats:
    """Arc lengths [m], a metre apart, of the path that was not reached."""
    reached = max(float(run.track["s"].max()), 0.0)
    return np.arange(reached, run.path.length, 1.0) if reached < run.path.length else np.empty(0)


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
