"""Quantities at the edges: parsing of speeds and angles, and the few constants everybody shares."""

from __future__ import annotations

import math
import re

import numpy as np

from planners.errors import InputError
from planners.kernel import Floats

STANDARD_GRAVITY = 9.80665  # [m/s^2], CGPM 1901: the "g" of load factors and of lateral limits
METRES_PER_FOOT = 0.3048  # exact, international foot
SECONDS_PER_HOUR = 3600.0

_SPEED_UNITS = {
    "": 1.0,
    "m/s": 1.0,
    "mps": 1.0,
    "km/h": 1 / 3.6,
    "kmh": 1 / 3.6,
    "kt": 1852 / 3600,
    "kn": 1852 / 3600,
}
_QUANTITY = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")


def wrap(angle: float) -> float:
    """Angle [rad] to [-pi, pi)."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def wrap_all(angles: Floats) -> Floats:
    """Angles (N,) [rad] to [-pi, pi)."""
    return (angles + np.pi) % (2.0 * np.pi) - np.pi


def split_quantity(text: str, place: str) -> tuple[float, str]:
    """The number and the unit of `text`, as in "30km/h" -> (30.0, "km/h")."""
    match = _QUANTITY.fullmatch(text)
    if match is None or not math.isfinite(float(match[1])):
        raise InputError(place, f"{text!r} is not a number with an optional unit")
    return float(match[1]), match[2]


def parse_speed(text: str | float, place: str = "speed") -> float:
    """Speed [m/s] from `55`, `55m/s`, `30km/h` or `100kt`."""
    value, unit = split_quantity(str(text), place)
    if unit not in _SPEED_UNITS:
        raise InputError(place, f"unknown unit {unit!r} in {text!r}", "use m/s, km/h or kt")
    if value <= 0.0:
        raise InputError(place, f"{text} is not a speed to travel at", "give a speed above 0")
    return value * _SPEED_UNITS[unit]


def degrees(value: float, unit: str) -> tuple[float, str]:
    """A value for machines to read: SI, but angles in degrees, with the unit's name."""
    if unit.startswith("rad"):
        return math.degrees(value), "deg" + unit.removeprefix("rad")
    return value, unit
