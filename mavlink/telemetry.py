"""A track as an autopilot would report it: geographic, clockwise from north, at 10 Hz."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from planners.frame import Frame
from planners.kernel import Floats, Ints
from planners.units import wrap
from tracking.outcome import Outcome
from tracking.track import Track

RATE = 10.0  # [Hz] what autopilots usually send


@dataclass(frozen=True, slots=True)
class Sample:
    """One report: degrees for `lat`, `lon`, `compass`, `path_bearing` and `roll_wanted`, otherwise SI and radians.

    `roll` is positive to the right, `yaw` and `compass` run clockwise from north, `height_gained` is above
    the start, `cross_track` positive to the left, `distance_left` along the path to its end; errors are
    wanted minus flown.
    """

    t: float
    lat: float
    lon: float
    z: float
    height_gained: float
    north_speed: float
    east_speed: float
    climb_rate: float
    roll: float
    pitch: float
    yaw: float
    roll_rate: float
    pitch_rate: float
    yaw_rate: float
    compass: float
    airspeed: float
    ground_speed: float
    throttle: float
    roll_wanted: float
    path_bearing: float
    distance_left: float
    altitude_error: float
    speed_error: float
    cross_track: float


def samples(outcome: Outcome, frame: Frame) -> Iterator[Sample]:
    """Yield the finite samples of the track at `RATE`, the first and the last among them."""
    track = outcome.track
    rows = _rows(track)
    if not len(rows):
        return
    column = {name: track[name][rows] for name in track.columns}
    t, heading, z = column["t"], column["heading"], column["z"]
    places = frame.to_geographic(np.column_stack([column["x"], column["y"]]))
    roll = -column["bank"] if "bank" in track else np.zeros(len(rows))
    pitch = column.get("pitch", np.arctan2(column["climb_rate"], np.fmax(column["ground_speed"], 1e-3)))
    throttle = column.get("throttle", np.zeros(len(rows)))
    rates = [_rate(values, t) for values in (roll, pitch, -np.unwrap(heading))]
    wanted = _roll_wanted(outcome, column)
    for i in range(len(rows)):
        course = column["course"][i]
        yield Sample(
            t=float(t[i]), lat=float(places[i, 0]), lon=float(places[i, 1]), z=float(z[i]),
            height_gained=float(z[i] - z[0]),
            north_speed=float(column["ground_speed"][i] * math.sin(course)),
            east_speed=float(column["ground_speed"][i] * math.cos(course)),
            climb_rate=float(column["climb_rate"][i]),
            roll=float(roll[i]), pitch=float(pitch[i]), yaw=wrap(math.pi / 2 - float(heading[i])),
            roll_rate=float(rates[0][i]), pitch_rate=float(rates[1][i]), yaw_rate=float(rates[2][i]),
            compass=_compass(heading[i]), airspeed=float(column["airspeed"][i]),
            ground_speed=float(column["ground_speed"][i]), throttle=float(np.clip(throttle[i], 0.0, 1.0)),
            roll_wanted=float(wanted[i]), path_bearing=_compass(column["path_heading"][i]),
            distance_left=float(outcome.path.length - column["s"][i]),
            altitude_error=float(column["altitude_command"][i] - z[i]),
            speed_error=float(column["speed_command"][i] - column["airspeed"][i]),
            cross_track=float(column["cross_track"][i]),
        )  # fmt: skip


def _rows(track: Track) -> Ints:
    """The first sample of every tenth of a second, and the last; samples that are not numbers are never reported."""
    good = np.flatnonzero(np.isfinite(track.data).all(axis=1))
    if not len(good):
        return good
    tick = np.floor((track["t"][good] - track["t"][good[0]]) * RATE + 1e-6)
    first = np.concatenate([[True], tick[1:] != tick[:-1]])
    first[-1] = True
    chosen: Ints = good[first]
    return chosen


def _rate(values: Floats, t: Floats) -> Floats:
    if len(t) < 2 or (np.diff(t) <= 0.0).any():
        return np.zeros(len(t))
    return np.gradient(values, t)


def _roll_wanted(outcome: Outcome, column: dict[str, Floats]) -> Floats:
    """The roll [deg] that the commanded curvature asks of an aircraft in a coordinated turn; a truck wants none."""
    if outcome.limits.kind != "fixed-wing":
        return np.zeros(len(column["t"]))
    wanted: Floats = -np.degrees(
        np.arctan(column["ground_speed"] ** 2 * column["curvature_command"] / outcome.limits.gravity)
    )
    return wanted


def _compass(heading: float) -> float:
    """Degrees clockwise from north, 0 to 360, of a heading [rad from east]."""
    return (90.0 - math.degrees(heading)) % 360.0
