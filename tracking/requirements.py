"""Requirements: sensible defaults for a vehicle, and the user's own."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from planners.errors import InputError
from planners.units import STANDARD_GRAVITY, split_quantity
from sim.vehicle import Limits
from tracking.metric import Metric, Requirement

_REQUIREMENT = re.compile(r"\s*(\w+)\s*(<=|>=)\s*(\S.*?)\s*")
# Factors to SI of the units a limit may be written in, by the metric's own unit
_UNITS: dict[str, dict[str, float]] = {
    "rad": {"": math.radians(1.0), "deg": math.radians(1.0), "rad": 1.0},
    "rad/s": {"": math.radians(1.0), "deg/s": math.radians(1.0), "rad/s": 1.0},
    "m/s^2": {"": 1.0, "m/s^2": 1.0, "m/s2": 1.0, "g": STANDARD_GRAVITY},
    "m": {"": 1.0, "m": 1.0, "km": 1000.0},
    "m/s": {"": 1.0, "m/s": 1.0, "km/h": 1 / 3.6, "kt": 1852 / 3600},
    "kg": {"": 1.0, "kg": 1.0},
    "s": {"": 1.0, "s": 1.0},
    "g": {"": 1.0, "g": 1.0},
    "share": {"": 1.0, "%": 0.01},
    "1": {"": 1.0},
}


def default_requirements(limits: Limits, corridor: float, has_map: bool) -> tuple[Requirement, ...]:
    """Within the corridor, to the end, clear of obstacles where there is a map, and the vehicle's own bounds."""
    always = (
        Requirement("completion", ">=", 1.0, "the whole path"),
        Requirement("cross_track_max", "<=", corridor, "the corridor's half-width"),
    )
    clear = (Requirement("clearance_min", ">=", 0.0, "the body touches nothing"),) if has_map else ()
    own = tuple(Requirement(bound.metric, bound.comparison, bound.limit, bound.source) for bound in limits.bounds)
    return (*always, *clear, *own)


def with_user_requirements(
    defaults: Iterable[Requirement], texts: Iterable[str], metrics: dict[str, Metric]
) -> tuple[Requirement, ...]:
    """`defaults`, each replaced by the user's limit on the same metric and side if there is one, and the others added.

    `texts` are as in `cross_track_p95<=4` or `bank_max<=40deg`. Raises `InputError` for one that is not understood.
    """
    wanted = {(r.metric, r.comparison): r for r in (parse_requirement(text, metrics) for text in texts)}
    kept = [wanted.pop((default.metric, default.comparison), default) for default in defaults]
    return (*kept, *wanted.values())


def parse_requirement(text: str, metrics: dict[str, Metric]) -> Requirement:
    """A requirement from `metric<=limit[unit]`; angles are in degrees unless they say `rad`."""
    name, comparison, limit = split_requirement(text)
    if name not in metrics:
        raise InputError("require", f"there is no metric {name!r} here", f"there are {', '.join(metrics)}")
    value, unit = split_quantity(limit, "require")
    units = _UNITS[metrics[name].unit]
    if unit not in units:
        raise InputError("require", f"{text!r} has the wrong unit", f"use one of {', '.join(filter(None, units))}")
    return Requirement(name, comparison, value * units[unit], "set by the user")


def split_requirement(text: str) -> tuple[str, str, str]:
    """Metric, comparison and limit as written; raises `InputError` for what is no requirement."""
    match = _REQUIREMENT.fullmatch(text)
    if match is None:
        raise InputError(
            "require", f"{text!r} is not a requirement", "write it as cross_track_p95<=4 or bank_max<=40deg"
        )
    return match[1], match[2], match[3]
