"""Steady wind, a gust on top of it, and the triangle that wind makes with air and ground velocity."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from planners.errors import InputError

LARGEST = 1e6  # [m/s, deg]: beyond all that blows, and finite
_WIND = re.compile(r"\s*(\d+\.?\d*|\.\d+)\s*(m/s)?\s*@\s*([-+]?\d+\.?\d*)\s*(deg)?\s*")


@dataclass(frozen=True, slots=True)
class Wind:
    """A steady horizontal wind: velocity [m/s] it blows *towards*, east and north."""

    east: float = 0.0
    north: float = 0.0

    @staticmethod
    def blowing_from(speed: float, direction_deg: float) -> Wind:
        """Wind of `speed` [m/s] from `direction_deg`, degrees true clockwise from north, as in weather reports."""
        angle = math.radians(direction_deg)
        return Wind(-speed * math.sin(angle), -speed * math.cos(angle))

    @property
    def speed(self) -> float:
        """Wind speed [m/s]."""
        return math.hypot(self.east, self.north)

    @property
    def from_deg(self) -> float:
        """Direction it blows from [deg true, 0 to 360)."""
        return math.degrees(math.atan2(-self.east, -self.north)) % 360.0


@dataclass(frozen=True, slots=True)
class Gust:
    """A 1-cosine gust on top of the wind (FAR 25.341, MIL-F-8785C 3.7.1.3): V/2 (1 - cos(2 pi (t - start) / duration)).

    `east`, `north` and `up` [m/s] are the components of its peak V, where it blows towards; `start` and `duration` [s].
    """

    east: float
    north: float
    up: float
    start: float
    duration: float

    def share(self, t: float) -> float:
        """Share of the peak at time `t` [s]; 0 before and after."""
        phase = (t - self.start) / self.duration
        return 0.5 * (1.0 - math.cos(2.0 * math.pi * phase)) if 0.0 < phase < 1.0 else 0.0


@dataclass(frozen=True, slots=True)
class Dryden:
    """Dryden turbulence on any planet: standard deviation `sigma` [m/s] and length scale `length` [m].

    `sigma` is one for all axes, or (along, across, up): along and across the aircraft's heading.
    """

    sigma: float | tuple[float, float, float]
    length: float

    @property
    def sigmas(self) -> tuple[float, float, float]:
        """Standard deviations [m/s] along, across, up."""
        return self.sigma if isinstance(self.sigma, tuple) else (self.sigma, self.sigma, self.sigma)


def parse_wind(text: str, place: str = "wind") -> Wind:
    """Wind from `10@270` or `10m/s@270`: 10 m/s from the west."""
    match = _WIND.fullmatch(text)
    if match is None:
        raise InputError(place, f"{text!r} is not a wind", "write speed@direction as in 10@270, m/s from degrees true")
    speed, direction = float(match[1]), float(match[3])
    if speed > LARGEST or abs(direction) > LARGEST:
        raise InputError(place, f"{text[:40]!r} is out of range", "write speed@direction as in 10@270")
    return Wind.blowing_from(speed, direction)


def ground_speed_on_course(airspeed: float, course: float, wind: Wind) -> float:
    """Ground speed [m/s] on a `course` [rad from east] at `airspeed` [m/s] in `wind`; NaN if it cannot be held."""
    along = wind.east * math.cos(course) + wind.north * math.sin(course)
    across = -wind.east * math.sin(course) + wind.north * math.cos(course)
    if abs(across) >= airspeed:
        return math.nan
    return math.sqrt(airspeed**2 - across**2) + along


def heading_for_course(airspeed: float, course: float, wind: Wind) -> float:
    """Heading [rad from east] that makes good `course` [rad] at `airspeed` [m/s] in `wind`; NaN if none does."""
    across = -wind.east * math.sin(course) + wind.north * math.cos(course)
    if abs(across) >= airspeed:
        return math.nan
    return course - math.asin(across / airspeed)
