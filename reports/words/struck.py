"""What a vehicle came too close to: an obstacle, or the edge of where it may be."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from planners.clearance import clearance
from tracking.metric import Metric
from tracking.outcome import Outcome

OBSTACLE, EDGE, UNKNOWN = "an obstacle", "the map's edge", "an obstacle or the map's edge"
_SAME = 1e-6  # [m]


def struck(outcome: Outcome, metric: Metric) -> str:
    """To what the clearance `metric` was that small; `UNKNOWN` where the track has no sample of that time."""
    area, track = outcome.obstacles, outcome.track
    if area is None or not len(track) or not math.isfinite(metric.t):
        return UNKNOWN
    late = np.abs(track["t"] - metric.t)
    index = int(np.nanargmin(late))
    pose = np.array([[float(track[column][index]) for column in ("x", "y", "heading")]])
    if late[index] > 1.0 or not np.isfinite(pose).all():
        return UNKNOWN
    obstacles = replace(area, keep_in=(), keep_in_circles=(), bounds=None)
    to_obstacles = float(clearance(obstacles, pose, outcome.limits.footprint)[0])
    return OBSTACLE if to_obstacles <= metric.value + _SAME else EDGE
