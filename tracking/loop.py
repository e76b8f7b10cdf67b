"""The closed loop: a vehicle on a path under a controller, until it is through or lost."""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass

import numpy as np

from planners.path import Path, Projection
from sim.vehicle import NOT_A_NUMBER, Command, Conditions, Pose, State, Vehicle
from sim.wind import ground_speed_on_course
from tracking.controllers.controller import Controller
from tracking.integral import Integral
from tracking.sensors import PERFECT, Estimate, Sensors
from tracking.track import GUIDANCE_COLUMNS, STATE_COLUMNS, Track

SLOWEST = 0.1  # [m/s] below which a curvature means nothing, and the last command stands
COMPLETED, OUT_OF_TIME, LOST = "completed", "time budget spent", "corridor lost for good"


@dataclass(frozen=True, slots=True)
class Offset:
    """Where a run starts beside its path: `cross_track` [m] to the left of the start, `heading` [rad] to the left."""

    cross_track: float = 0.0
    heading: float = 0.0


ON_PATH = Offset()


def follow(
    path: Path,
    vehicle: Vehicle,
    controller: Controller,
    speed: float,
    altitude: float,
    conditions: Conditions,
    seed: int = 0,
    sensors: Sensors = PERFECT,
    offset: Offset = ON_PATH,
) -> Track:
    """Put `vehicle` on the start of `path`, or `offset` from it, and let `controller` follow it; returns the track.

    `speed` [m/s] and `altitude` [m] are commanded throughout; the altitude is the path's own where it has heights. How
    the vehicle is guided depends on its own default corridor, never on the one it is judged by. The controller sees
    the state through `sensors`; the track, and when the run ends, is the truth.

    The run ends when the path is completed, when the vehicle reports a fault, when the time budget is spent (twice the
    path's time in this wind, and a minute), or when the corridor is lost for good: no way gained along the path during
    two full circles of the vehicle. A state that is not a number ends the run and is not part of the track.
    """
    limits, period = vehicle.limits, vehicle.period
    path = path.with_tolerance(0.1 * limits.corridor)
    held_periods = round(vehicle.guidance_period / period)
    height = path.height_at if path.z is not None else None
    start = path.height_at(0.0) if height else altitude
    state = vehicle.reset(start_pose(path, offset, start), speed, conditions, seed)
    controller.reset(limits, vehicle.guidance_period)
    integral = Integral(limits, limits.corridor, vehicle.guidance_period)

    radius = limits.turn_radius(speed + conditions.wind.speed)
    window = max(2.0 * radius, 4.0 * limits.corridor)
    budget = 2.0 * _time_needed(path, speed, conditions) + 60.0
    circle = 4.0 * math.pi * radius / speed
    at = path.project(state.x, state.y, s_to=0.0)
    furthest, gained = at.s, 0.0
    estimate = None if sensors.perfect else Estimate(sensors, period, seed)
    # Path [m] that an estimate may lag: half as much again as the wind alone gives, for gusts and the inside of curves
    behind = 1.5 * (speed + conditions.wind.speed) * sensors.latency + 5.0 * sensors.position
    rows = array("d")
    curvature, ended, index = 0.0, "", 0
    while True:
        seen, seen_at = state, at
        if estimate:
            seen = estimate.observe(state)
            seen_at = path.project(seen.x, seen.y, furthest - behind, furthest + window)
        if index % held_periods == 0 and seen.ground_speed >= SLOWEST:
            curvature = controller.curvature(seen, path, seen_at)
            curvature += integral.curvature(seen_at.cross_track, seen.ground_speed, seen.saturated)
        target = height(at.s) if height else altitude
        rows.extend(_row(state, at, curvature, speed, target))
        if ended := _ended(state, at, path, budget, gained, circle):
            break
        gradient = _gradient(path, at.segment) if height else 0.0
        state = vehicle.step(Command(curvature, speed, target, gradient))
        index += 1
        if state.fault == NOT_A_NUMBER:
            ended = state.fault
            break
        at = path.project(state.x, state.y, furthest, furthest + window)
        if at.s > furthest:
            furthest, gained = at.s, state.t
    columns = (*STATE_COLUMNS, *vehicle.channels, *GUIDANCE_COLUMNS)
    return Track(columns, np.array(rows).reshape(-1, len(columns)), ended, path.frame)


def start_pose(path: Path, offset: Offset, height: float) -> Pose:
    """The pose `offset` from the start of `path`, at `height` [m]."""
    (x, y), course = path.xy[0], float(path.headings[0])
    left = offset.cross_track
    return Pose(float(x) - left * math.sin(course), float(y) + left * math.cos(course), height, course + offset.heading)


def _row(state: State, at: Projection, curvature: float, speed: float, altitude: float) -> tuple[float, ...]:
    return (
        state.t, state.x, state.y, state.z, state.heading, state.course, state.ground_speed, state.airspeed,
        state.climb_rate, state.curvature, state.saturated, *state.channels,
        at.s, at.cross_track, at.heading, curvature, speed, altitude,
    )  # fmt: skip


def _ended(state: State, at: Projection, path: Path, budget: float, gained: float, circle: float) -> str:
    if state.fault:
        return state.fault
    if at.s >= path.length:
        return COMPLETED
    if state.t - gained > circle:
        return LOST
    return OUT_OF_TIME if state.t > budget else ""


def _gradient(path: Path, segment: int) -> float:
    leg = path.s[segment + 1] - path.s[segment]
    return float((path.points[segment + 1, 2] - path.points[segment, 2]) / leg)


def _time_needed(path: Path, speed: float, conditions: Conditions) -> float:
    """Time [s] along the path at `speed` in the wind; where the wind is too strong, as if at a tenth of the speed."""
    slowest = 0.1 * speed
    legs = np.diff(path.s)
    speeds = [ground_speed_on_course(speed, float(course), conditions.wind) for course in path.headings]
    return float(np.sum(legs / np.fmax(np.array(speeds), slowest)))
