"""Containment: how much of the path was followed within the corridor, and how far it was left."""

from __future__ import annotations

import numpy as np

from tracking.metric import Metric, Where
from tracking.metrics.errors import centred_weights, cross_track_errors
from tracking.run import Run


def corridor(run: Run) -> list[Metric]:
    """Share of the path within the corridor and the excursions beyond it (ICAO PBN containment).

    Unreached path counts as its length beyond the corridor, as one more excursion, and with its distance.
    """
    errors, track = cross_track_errors(run), run.track
    flown = errors.flown
    outside = np.abs(errors.e[:flown]) > run.corridor
    progress = np.clip(np.diff(track["s"], prepend=track["s"][:1]), 0.0, None)
    inside = min(float(progress[~outside].sum()) / run.path.length, 1.0)
    worst = int(np.argmax(np.abs(errors.e)))
    excess = max(float(np.abs(errors.e[worst])) - run.corridor, 0.0)
    missing = float(errors.weight[flown:].sum())
    where = errors.where(worst) if excess > 0.0 else Where()
    distance = float(centred_weights(track.distance)[outside].sum()) + missing
    time = float(centred_weights(track["t"])[outside].sum())
    return [
        Metric("corridor_fraction", inside, "share", "higher", **where),
        Metric("corridor_violation_count", excursions(outside) + (missing > 0.0), "1", **where),
        Metric("corridor_violation_time", time, "s", **where),
        Metric("corridor_violation_distance", distance, "m", **where),
        Metric("corridor_violation_worst", excess, "m", **where),
    ]


def excursions(outside: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> float:
    """How many separate runs of True there are."""
    return float(np.count_nonzero(outside[1:] & ~outside[:-1]) + (len(outside) > 0 and bool(outside[0])))


def completion(run: Run) -> list[Metric]:
    """Arc length reached over the path's length, with the waypoints passed in order."""
    reached = float(np.clip(run.track["s"].max(), 0.0, run.path.length))
    passed = int(np.searchsorted(run.path.s, reached, side="right"))
    note = f"{passed} of {len(run.path.s)} waypoints; {run.track.ended}"
    end = float(run.track["t"][-1])
    return [Metric("completion", reached / run.path.length, "share", "higher", s=reached, t=end, note=note)]


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
