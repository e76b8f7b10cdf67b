"""How well heading, course, altitude and speed followed their commands."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Floats
from planners.units import wrap_all
from tracking.metric import Metric
from tracking.run import Run


def angles(run: Run) -> list[Metric]:
    """Heading and course error [rad] against the path's heading; for aircraft course counts, since crab is no error."""
    track = run.track
    return [
        metric
        for name in ("heading", "course")
        for metric in _rms_and_max(f"{name}_error", wrap_all(track[name] - track["path_heading"]), "rad", run)
    ]


def altitude(run: Run) -> list[Metric]:
    """Flown minus commanded altitude [m]; only aircraft have one."""
    if run.limits.kind == "ground":
        note = "a ground vehicle commands no altitude"
        return [Metric(f"altitude_error_{kind}", math.nan, "m", valid=False, note=note) for kind in ("rms", "max")]
    return _rms_and_max("altitude_error", run.track["z"] - run.track["altitude_command"], "m", run)


def speed(run: Run) -> list[Metric]:
    """Flown minus commanded speed [m/s]: true airspeed of aircraft, speed over the ground of ground vehicles."""
    flown = run.track["ground_speed" if run.limits.kind == "ground" else "airspeed"]
    return _rms_and_max("speed_error", flown - run.track["speed_command"], "m/s", run)


def _rms_and_max(name: str, error: Floats, unit: str, run: Run) -> list[Metric]:
    finite = np.where(np.isfinite(error), np.abs(error), 0.0)
    worst = int(np.argmax(finite))
    return [
        Metric(f"{name}_rms", float(np.sqrt(np.mean(finite**2))), unit),
        Metric(f"{name}_max", float(finite[worst]), unit, **run.where(worst)),
    ]
