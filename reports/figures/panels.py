"""Which series a figure shows of a run, and the limits they are shown against."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from planners.kernel import Floats
from planners.needed import lateral_acceleration_needed
from planners.units import STANDARD_GRAVITY
from reports.words.quantity import KILO
from tracking.outcome import Outcome

_WIDE_TURN = 50.0  # [m] a vehicle whose tightest turn is wider has its curvature shown per kilometre


@dataclass(frozen=True, slots=True)
class Panel:
    """What a panel shows in its `unit`, all but the last of (N,) samples of the track.

    What was driven or flown (`values`), what was commanded, and a `limit`, or None; `grip` is what the tyres hold.
    `needed` is what the path itself needs, at arc lengths (M,) [m] of its own.
    """

    title: str
    unit: str
    values: Floats
    limit: Floats | None = None
    command: Floats | None = None
    corridor: float | None = None
    symmetric: bool = True
    grip: float | None = None
    needed: tuple[Floats, Floats] | None = None


def panels(outcome: Outcome) -> list[Panel]:
    """The panels that the track's columns allow: error, what turns the vehicle with its limits, height.

    Of a ground vehicle the first is its lateral acceleration, with what the path needs.
    """
    makers: list[Callable[[Outcome], Panel | None]] = [
        _lateral,
        error_panel,
        _curvature,
        _height,
        _bank,
        _steering,
        _steering_rate,
    ]
    return [panel for maker in makers if (panel := maker(outcome)) is not None]


def error_panel(outcome: Outcome) -> Panel:
    """The cross-track error and its corridor."""
    stated = _stated(outcome, "cross_track_max")
    limit = None if stated is None or stated == outcome.corridor else _constant(outcome, stated)
    return Panel("Cross-track error", "m", outcome.track["cross_track"], limit, corridor=outcome.corridor)


def _curvature(outcome: Outcome) -> Panel | None:
    track = outcome.track
    if "lateral_acceleration" in track:  # which is the same at a speed
        return None
    with np.errstate(divide="ignore"):
        limit = outcome.limits.lateral_acceleration / track["ground_speed"] ** 2
    limit = np.minimum(limit, outcome.limits.curvature_max)
    tightest = outcome.limits.lateral_acceleration / outcome.speed**2
    factor, unit = (KILO, "1/km") if tightest < 1.0 / _WIDE_TURN else (1.0, "1/m")
    command = factor * track["curvature_command"]
    return Panel("Curvature", unit, factor * track["curvature"], factor * limit, command)


def _lateral(outcome: Outcome) -> Panel | None:
    """In g, as paper 004 gives its limit."""
    track, g = outcome.track, STANDARD_GRAVITY
    if "lateral_acceleration" not in track:
        return None
    limit = _stated(outcome, "lateral_acceleration_max") or outcome.limits.lateral_acceleration
    s, needed = lateral_acceleration_needed(outcome.path, outcome.speed)
    friction = outcome.limits.friction if outcome.conditions.friction is None else outcome.conditions.friction
    return Panel(
        "Lateral accel.",  # with the legend it has just room
        "g",
        track["lateral_acceleration"] / g,
        _constant(outcome, limit / g),
        track["ground_speed"] ** 2 * track["curvature_command"] / g,
        grip=friction if math.isfinite(friction) else None,
        needed=(s, needed / g),
    )


def _height(outcome: Outcome) -> Panel | None:
    if outcome.path.z is None or outcome.limits.kind == "ground":
        return None
    track = outcome.track
    return Panel("Height", "m", track["z"], command=track["altitude_command"], symmetric=False)


def _bank(outcome: Outcome) -> Panel | None:
    able = math.atan(outcome.limits.lateral_acceleration / outcome.limits.gravity)
    return _angle(outcome, "Bank", "°", "bank", _stated(outcome, "bank_max") or able)


def _steering(outcome: Outcome) -> Panel | None:
    limit = _stated(outcome, "steering_max") or outcome.limits.steering_max
    return _angle(outcome, "Steering", "°", "steering", limit)


def _steering_rate(outcome: Outcome) -> Panel | None:
    limit = _stated(outcome, "steering_rate_max") or outcome.limits.steering_rate
    return _angle(outcome, "Steering rate", "°/s", "steering_rate", limit)


def _angle(outcome: Outcome, title: str, unit: str, column: str, limit: float) -> Panel | None:
    """Of a column in radians, if there is one; an infinite limit is none."""
    if column not in outcome.track:
        return None
    line = _constant(outcome, math.degrees(limit)) if math.isfinite(limit) else None
    return Panel(title, unit, np.degrees(outcome.track[column]), line)


def _stated(outcome: Outcome, metric: str) -> float | None:
    found = (margin.requirement.limit for margin in outcome.verdict.margins if margin.requirement.metric == metric)
    return next(found, None)


def _constant(outcome: Outcome, value: float) -> Floats:
    return np.full(len(outcome.track), value)
