"""Which series a figure shows of a run, and the limits they are shown against."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from planners.kernel import Floats
from reports.quantity import KILO
from tracking.outcome import Outcome

_WIDE_TURN = 50.0  # [m] a vehicle whose tightest turn is wider has its curvature shown per kilometre


@dataclass(frozen=True, slots=True)
class Panel:
    """What a panel shows: `column` times `factor`, under a `limit` (N,) in the `unit` shown, or None."""

    title: str
    unit: str
    column: str
    factor: float
    limit: Floats | None
    command: str | None = None
    corridor: float | None = None
    symmetric: bool = True


def panels(outcome: Outcome) -> list[Panel]:
    """The panels that the track's columns allow: error and curvature always, then height and the vehicle's own."""
    makers: list[Callable[[Outcome], Panel | None]] = [
        _error,
        _curvature,
        _height,
        _bank,
        _steering,
        _lateral,
    ]
    return [panel for maker in makers if (panel := maker(outcome)) is not None]


def _error(outcome: Outcome) -> Panel:
    stated = _stated(outcome, "cross_track_max")
    limit = None if stated is None or stated == outcome.corridor else _constant(outcome, stated)
    return Panel("Cross-track error", "m", "cross_track", 1.0, limit, corridor=outcome.corridor)


def _curvature(outcome: Outcome) -> Panel:
    with np.errstate(divide="ignore"):
        limit = outcome.limits.lateral_acceleration / outcome.track["ground_speed"] ** 2
    limit = np.minimum(limit, outcome.limits.curvature_max)
    tightest = outcome.limits.lateral_acceleration / outcome.speed**2
    factor, unit = (KILO, "1/km") if tightest < 1.0 / _WIDE_TURN else (1.0, "1/m")
    return Panel("Curvature", unit, "curvature", factor, factor * limit, command="curvature_command")


def _height(outcome: Outcome) -> Panel | None:
    if outcome.path.z is None:
        return None
    return Panel("Height", "m", "z", 1.0, None, command="altitude_command", symmetric=False)


def _bank(outcome: Outcome) -> Panel | None:
    able = math.atan(outcome.limits.lateral_acceleration / outcome.limits.gravity)
    return _own(outcome, "Bank", "°", "bank", math.degrees(1.0), _stated(outcome, "bank_max") or able)


def _steering(outcome: Outcome) -> Panel | None:
    limit = _stated(outcome, "steering_max")
    if limit is None and math.isfinite(outcome.limits.steering_max):
        limit = outcome.limits.steering_max
    return _own(outcome, "Steering", "°", "steering", math.degrees(1.0), limit)


def _lateral(outcome: Outcome) -> Panel | None:
    limit = _stated(outcome, "lateral_acceleration_max") or outcome.limits.lateral_acceleration
    return _own(outcome, "Lateral acceleration", "m/s²", "lateral_acceleration", 1.0, limit)


def _own(outcome: Outcome, title: str, unit: str, column: str, factor: float, limit: float | None) -> Panel | None:
    if column not in outcome.track:
        return None
    line = None if limit is None else _constant(outcome, factor * limit)
    return Panel(title, unit, column, factor, line)


def _stated(outcome: Outcome, metric: str) -> float | None:
    found = (margin.requirement.limit for margin in outcome.verdict.margins if margin.requirement.metric == metric)
    return next(found, None)


def _constant(outcome: Outcome, value: float) -> Floats:
    return np.full(len(outcome.track), value)
