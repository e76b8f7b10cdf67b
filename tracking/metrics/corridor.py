"""Containment: how much of the path was followed within the corridor, and how far it was left."""

from __future__ import annotations

import numpy as np

from planners.kernel import Bools, Floats
from tracking.metric import Metric, Where
from tracking.metrics.errors import centred_weights, cross_track_errors, gaps
from tracking.run import Run


def corridor(run: Run) -> list[Metric]:
    """Share of the path within the corridor and the excursions beyond it (ICAO PBN containment).

    Path that was left out beyond the corridor counts with its length and its distance, each gap as one more excursion.
    """
    errors, track = cross_track_errors(run), run.track
    flown, missed = errors.flown, errors.missed(run.corridor)
    outside = np.abs(errors.e[:flown]) > run.corridor
    progress = np.clip(np.diff(np.clip(track["s"], 0.0, run.path.length), prepend=0.0), 0.0, None)
    for _, _, sample in gaps(run):
        progress[sample + 1 : sample + 2] = 0.0
    near = float(errors.weight[flown:][~missed[flown:]].sum())
    inside = (float(progress[~outside].sum()) + near) / run.path.length
    worst = int(np.argmax(np.abs(errors.e)))
    excess = max(float(np.abs(errors.e[worst])) - run.corridor, 0.0)
    where = errors.where(worst) if excess > 0.0 else Where()
    distance = float(centred_weights(track.distance)[outside].sum() + errors.weight[missed].sum())
    time = float(centred_weights(track["t"])[outside].sum())
    return [
        Metric("corridor_fraction", min(inside, 1.0), "share", "higher", **where),
        Metric("corridor_violation_count", excursions(outside) + excursions(missed), "1", **where),
        Metric("corridor_violation_time", time, "s", **where),
        Metric("corridor_violation_distance", distance, "m", **where),
        Metric("corridor_violation_worst", excess, "m", **where),
    ]


def _among(s: Floats, samples: Floats) -> Bools:
    """Which of `s` lie within half a metre of one of the ascending `samples`, which are a metre apart or less."""
    if not len(samples):
        return np.zeros(len(s), dtype=bool)
    after = np.clip(np.searchsorted(samples, s), 0, len(samples) - 1)
    before = np.clip(after - 1, 0, None)
    near = np.minimum(np.abs(samples[after] - s), np.abs(samples[before] - s)) <= 0.5
    return np.asarray(near)


def excursions(outside: Bools) -> float:
    """How many separate runs of True there are."""
    return float(np.count_nonzero(outside[1:] & ~outside[:-1]) + (len(outside) > 0 and bool(outside[0])))


def completion(run: Run) -> list[Metric]:
    """Share of the path that was followed, with the waypoints passed in order.

    Path that was left out counts as followed where the vehicle came within the corridor of it, as it does at a corner
    that it cuts; what was not reached in the end never does.
    """
    errors = cross_track_errors(run)
    reached = float(np.clip(run.track["s"][-1], 0.0, run.path.length))
    missed = errors.missed(run.corridor) | (errors.s > reached)
    lost = float(errors.weight[missed & np.isnan(errors.t)].sum())
    passed = int(np.count_nonzero(~_among(run.path.s, np.sort(errors.s[missed]))))
    note = f"{passed} of {len(run.path.s)} waypoints; {run.track.ended}"
    end = float(run.track["t"][-1])
    return [Metric("completion", 1.0 - lost / run.path.length, "share", "higher", s=reached, t=end, note=note)]


def lengths(run: Run) -> list[Metric]:
    """Length of the path, of the track, and their ratio; range used where the scenario limits it (paper 001, eq. 3)."""
    path, track = run.path.length, float(run.track.distance[-1])
    metrics = [
        Metric("path_length", path, "m", "neither"),
        Metric("track_length", track, "m", "neither"),
        Metric("length_ratio", track / path, "1", "neither"),
    ]
    if run.max_range is not None:
        metrics.append(Metric("range_used", track / run.max_range, "share"))
    return metrics
