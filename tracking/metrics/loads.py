"""What the vehicle itself went through: bank, load factor, stall margin, steering, lateral acceleration, grip."""

from __future__ import annotations

import numpy as np

from planners.kernel import Floats
from planners.needed import lateral_acceleration_needed
from tracking.metric import Metric
from tracking.run import Run


def aircraft_loads(run: Run) -> list[Metric]:
    """Bank [rad], load factor [g], stall margin [rad of angle of attack]; none for a ground vehicle."""
    if "bank" not in run.track:
        return []
    track = run.track
    return [
        _extreme("bank_max", np.abs(track["bank"]), "rad", run),
        _extreme("load_factor_max", track["load_factor"], "g", run),
        _extreme("stall_margin_min", track["stall_margin"], "rad", run, better="higher"),
    ]


def ground_loads(run: Run) -> list[Metric]:
    """Steering [rad], its rate, lateral acceleration [m/s^2] (paper 004, eq. 8), grip used [1]; none for aircraft.

    Lateral acceleration is real, demanded by the controller, and needed by the planned path at the commanded speed.
    """
    if "steering" not in run.track:
        return []
    track = run.track
    demanded = track["ground_speed"] ** 2 * np.abs(track["curvature_command"])
    return [
        _extreme("steering_max", np.abs(track["steering"]), "rad", run),
        _extreme("steering_rate_max", np.abs(track["steering_rate"]), "rad/s", run),
        _extreme("lateral_acceleration_max", np.abs(track["lateral_acceleration"]), "m/s^2", run),
        _extreme("lateral_acceleration_demanded", demanded, "m/s^2", run),
        _needed(run),
        _extreme("friction_use_max", track["friction_use"], "share", run),
    ]


def _needed(run: Run) -> Metric:
    s, needed = lateral_acceleration_needed(run.path, run.speed)
    worst = int(np.argmax(np.abs(needed)))
    return Metric("lateral_acceleration_needed", float(abs(needed[worst])), "m/s^2", s=float(s[worst]))


def saturation(run: Run) -> list[Metric]:
    """Share of the time at a limit: bank, steering angle or rate, tyres, or full throttle."""
    at_limit = run.track["saturated"] > 0.0
    if "throttle" in run.track:
        at_limit = at_limit | (run.track["throttle"] >= 1.0)
    return [Metric("control_saturation", float(np.mean(at_limit)), "share")]


def _extreme(name: str, values: Floats, unit: str, run: Run, better: str = "lower") -> Metric:
    finite = np.where(np.isfinite(values), values, -np.inf if better == "lower" else np.inf)
    worst = int(np.argmax(finite) if better == "lower" else np.argmin(finite))
    where = run.where(worst)
    return Metric(name, float(values[worst]), unit, better, **where)
