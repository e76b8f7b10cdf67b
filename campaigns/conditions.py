"""The conditions of a case as a user states them, and one trial's draw from them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import msgspec
import numpy as np

from campaigns.distribution import Distribution, Value, drawn
from planners.errors import InputError
from sim.vehicle import Conditions
from sim.wind import Dryden, Gust, Wind, parse_wind
from tracking.loop import Offset
from tracking.sensors import Sensors

SEVERITIES = {"light": 3.0, "moderate": 4.0, "severe": 6.0}  # MIL-F-8785C: exceeded once in 1e2, 1e3, 1e5 encounters
CONDITIONS_STREAM = 2  # of the trial's seed, apart from the simulator's and the sensors'
LONGEST = 1e5  # [m] of turbulence: beyond, it does not change within a flight
LARGEST = 1e6  # of any condition: beyond all that means something, and finite


class WindKeys(msgspec.Struct, frozen=True, forbid_unknown_fields=True, rename={"origin": "from"}):
    """A steady wind: `speed` [m/s] and where it blows `from` [deg true]."""

    speed: Value
    origin: Value = 0.0


class GustKeys(msgspec.Struct, frozen=True, forbid_unknown_fields=True, rename={"origin": "from"}):
    """A 1-cosine gust: its peak `speed` [m/s] `from` [deg true] and `up` [m/s], its `start` and `duration` [s]."""

    speed: Value = 0.0
    origin: Value = 0.0
    up: Value = 0.0
    start: Value = 10.0
    duration: Value = 4.0


class DrydenKeys(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Dryden turbulence of standard deviation `sigma` [m/s] about all axes and of `length` [m], on any planet.

    As they are, those of a day on Mars, with the sources in `sim/planet.py`.
    """

    sigma: Value = 3.0
    length: Value = 533.4


class ConditionKeys(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a trial meets; a number, or a distribution that every trial draws from.

    `wind` is steady, as "10@270" or a table; `turbulence` light, moderate, severe or the number of MIL-F-8785C's curve
    (0 to 7), on Earth; `dryden` is turbulence by its numbers, anywhere; offsets of the start in metres and degrees to
    the left; `mass` a factor on an aircraft's, `friction` the tyres' coefficient. What stands between the truth and the
    controller: standard deviations of `position_noise` [m], `heading_noise` [deg] and `speed_noise` [m/s], their
    `noise_time` [s] of correlation, and `latency` [s].
    """

    wind: str | WindKeys = WindKeys(0.0)
    turbulence: Literal["light", "moderate", "severe"] | Value = 0.0
    gust: GustKeys | None = None
    dryden: DrydenKeys | None = None
    cross_track_offset: Value = 0.0
    heading_offset: Value = 0.0
    mass: Value = 1.0
    friction: Value | None = None
    position_noise: Value = 0.0
    heading_noise: Value = 0.0
    speed_noise: Value = 0.0
    noise_time: Value = 0.0
    latency: Value = 0.0


CALM = ConditionKeys()


@dataclass(frozen=True, slots=True)
class Draw:
    """One trial's conditions."""

    conditions: Conditions
    offset: Offset
    sensors: Sensors


def draw(keys: ConditionKeys, seed: int) -> Draw:
    """The conditions that the trial of that seed meets; raises `InputError` naming the key that is impossible."""
    rng = np.random.default_rng([seed, CONDITIONS_STREAM])

    def number(name: str, value: Value, low: float, high: float = LARGEST) -> float:
        return drawn(value, rng, f"conditions.{name}", low, high)

    named = SEVERITIES[keys.turbulence] if isinstance(keys.turbulence, str) else keys.turbulence
    severity = number("turbulence", named, 0.0, 7.0)
    if isinstance(named, Distribution):
        severity = float(round(severity))  # the curves have whole numbers
    elif not severity.is_integer():
        raise InputError("conditions.turbulence", f"there is no curve {severity:g}", "give a whole number from 0 to 7")
    conditions = Conditions(
        wind=_wind(keys.wind, rng),
        turbulence=severity,
        gust=_gust(keys.gust, rng) if keys.gust else None,
        dryden=_dryden(keys.dryden, rng) if keys.dryden else None,
        mass_factor=number("mass", keys.mass, 0.01, 100.0),
        friction=None if keys.friction is None else number("friction", keys.friction, 0.01, 10.0),
    )
    offset = Offset(
        number("cross_track_offset", keys.cross_track_offset, -LARGEST),
        math.radians(number("heading_offset", keys.heading_offset, -180.0, 180.0)),
    )
    sensors = Sensors(
        position=number("position_noise", keys.position_noise, 0.0),
        heading=math.radians(number("heading_noise", keys.heading_noise, 0.0, 180.0)),
        speed=number("speed_noise", keys.speed_noise, 0.0),
        correlation_time=number("noise_time", keys.noise_time, 0.0),
        latency=number("latency", keys.latency, 0.0, 60.0),
    )
    return Draw(conditions, offset, sensors)


def known_wind(keys: ConditionKeys) -> Wind | None:
    """The wind a plan may count on: the steady one; None where every trial draws its own."""
    wind = keys.wind
    if isinstance(wind, str):
        return parse_wind(wind, "conditions.wind")
    if isinstance(wind.speed, Distribution) or (wind.speed and isinstance(wind.origin, Distribution)):
        return None
    return Wind.blowing_from(wind.speed, 0.0 if isinstance(wind.origin, Distribution) else wind.origin)


def _wind(keys: str | WindKeys, rng: np.random.Generator) -> Wind:
    if isinstance(keys, str):
        return parse_wind(keys, "conditions.wind")
    speed = drawn(keys.speed, rng, "conditions.wind.speed", 0.0, LARGEST)
    return Wind.blowing_from(speed, drawn(keys.origin, rng, "conditions.wind.from", -LARGEST, LARGEST))


def _gust(keys: GustKeys, rng: np.random.Generator) -> Gust:
    def number(name: str, value: Value, low: float) -> float:
        return drawn(value, rng, f"conditions.gust.{name}", low, LARGEST)

    blow = Wind.blowing_from(number("speed", keys.speed, 0.0), number("from", keys.origin, -LARGEST))
    up, start, duration = number("up", keys.up, -LARGEST), number("start", keys.start, 0.0), keys.duration
    return Gust(blow.east, blow.north, up, start, number("duration", duration, 0.01))


def _dryden(keys: DrydenKeys, rng: np.random.Generator) -> Dryden:
    sigma = drawn(keys.sigma, rng, "conditions.dryden.sigma", 0.0, LARGEST)
    return Dryden(sigma, drawn(keys.length, rng, "conditions.dryden.length", 1.0, LONGEST))
