"""Fuel: what was really burned, and how far all of it would last."""

from __future__ import annotations

import math

from tracking.metric import Metric
from tracking.run import Run


def fuel(run: Run) -> list[Metric]:
    """Fuel used [kg], and the range [m] of all that was on board at this consumption; none for what burns none.

    The range is over the ground, so wind counts; paper 001, eq. 3, limits the length of a path in its stead.
    """
    if "fuel" not in run.track:
        return []
    left = run.track["fuel"]
    used = float(left[0] - left[-1])
    if not used > 0.0:
        note = "no fuel was burned"
        return [Metric("fuel_used", used, "kg"), Metric("fuel_range", math.nan, "m", "higher", valid=False, note=note)]
    flown = float(run.track.distance[-1])
    return [Metric("fuel_used", used, "kg"), Metric("fuel_range", flown * float(left[0]) / used, "m", "higher")]
