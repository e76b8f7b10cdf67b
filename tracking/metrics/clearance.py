"""Clearance of the vehicle's body to obstacles and map edge, over the whole track."""

from __future__ import annotations

import math

import numpy as np

from planners.clearance import clearance
from tracking.metric import Metric, Where
from tracking.metrics.corridor import excursions
from tracking.metrics.errors import centred_weights
from tracking.run import Run

NAMES = {"clearance_min": "m", "incursion_count": "1", "incursion_time": "s", "incursion_depth": "m"}


def body_clearance(run: Run) -> list[Metric]:
    """Smallest signed distance of the footprint [m], and the incursions where it is negative."""
    if run.obstacles is None:
        note = "no map was given"
        return [
            Metric(name, math.nan, unit, "higher" if name == "clearance_min" else "lower", valid=False, note=note)
            for name, unit in NAMES.items()
        ]
    track = run.track
    poses = np.column_stack([track["x"], track["y"], track["heading"]])
    distance = clearance(run.obstacles, poses, run.limits.footprint)
    worst = int(np.nanargmin(distance))
    where = run.where(worst)
    inside = distance < 0.0
    within = where if inside.any() else Where()
    return [
        Metric("clearance_min", float(distance[worst]), "m", "higher", **where),
        Metric("incursion_count", excursions(inside), "1", **within),
        Metric("incursion_time", float(centred_weights(track["t"])[inside].sum()), "s", **within),
        Metric("incursion_depth", max(-float(distance[worst]), 0.0), "m", **within),
    ]
