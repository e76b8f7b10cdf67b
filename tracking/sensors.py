"""What a controller gets to see: the truth, late and with errors. What it is judged by stays the truth."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

import msgspec
import numpy as np

from sim.vehicle import State

SENSOR_STREAM = 1  # of the trial's seed, apart from the simulator's own


@dataclass(frozen=True, slots=True)
class Sensors:
    """Errors between the true state and the controller.

    Standard deviations of `position` [m] (of x and y each), `heading` [rad] (of heading and course alike) and `speed`
    [m/s] (over the ground and in the air alike). The errors are first-order Gauss-Markov with `correlation_time` [s]
    (Gelb 1974, 2.2), white at 0. All arrive `latency` [s] late.
    """

    position: float = 0.0
    heading: float = 0.0
    speed: float = 0.0
    correlation_time: float = 0.0
    latency: float = 0.0

    @property
    def perfect(self) -> bool:
        """Whether the controller sees the truth."""
        return not (self.position or self.heading or self.speed or self.latency)


PERFECT = Sensors()


class Estimate:
    """The state as `sensors` show it, sampled every `period` [s]; `seed` decides the errors."""

    def __init__(self, sensors: Sensors, period: float, seed: int) -> None:
        self._sensors = sensors
        self._deviations = np.array([sensors.position, sensors.position, sensors.heading, sensors.speed])
        time = sensors.correlation_time
        self._kept = math.exp(-period / time) if time > 0.0 else 0.0
        self._rng = np.random.default_rng([seed, SENSOR_STREAM])
        self._error = self._rng.standard_normal(4) * self._deviations
        self._past: deque[State] = deque(maxlen=math.ceil(sensors.latency / period) + 2)

    def observe(self, state: State) -> State:
        """What is seen now that the truth is `state`; to be called once a period."""
        self._past.append(state)
        late = self._at(state.t - self._sensors.latency)
        x, y, heading, speed = self._error.tolist()
        fresh = self._rng.standard_normal(4) * self._deviations
        self._error = self._kept * self._error + math.sqrt(1.0 - self._kept**2) * fresh
        return msgspec.structs.replace(
            late,
            x=late.x + x,
            y=late.y + y,
            heading=late.heading + heading,
            course=late.course + heading,
            ground_speed=late.ground_speed + speed,
            airspeed=late.airspeed + speed,
            saturated=state.saturated,
        )

    def _at(self, t: float) -> State:
        """The true state at `t` [s], between samples by interpolation; before the start, on the way to it."""
        first = self._past[0]
        if t < first.t:
            back = first.ground_speed * (first.t - t)
            x, y = first.x - back * math.cos(first.course), first.y - back * math.sin(first.course)
            return msgspec.structs.replace(first, x=x, y=y)
        after = next((state for state in self._past if state.t >= t), self._past[-1])
        before = next(state for state in reversed(self._past) if state.t <= t)
        gap = after.t - before.t
        return _between(before, after, (t - before.t) / gap) if gap > 0.0 else after


def _between(before: State, after: State, share: float) -> State:
    """Linear interpolation; headings and courses go on beyond half a turn, so that they may be interpolated too."""

    def mixed(a: float, b: float) -> float:
        return a + share * (b - a)

    return msgspec.structs.replace(
        after,
        x=mixed(before.x, after.x),
        y=mixed(before.y, after.y),
        z=mixed(before.z, after.z),
        heading=mixed(before.heading, after.heading),
        course=mixed(before.course, after.course),
        ground_speed=mixed(before.ground_speed, after.ground_speed),
        airspeed=mixed(before.airspeed, after.airspeed),
        climb_rate=mixed(before.climb_rate, after.climb_rate),
        curvature=mixed(before.curvature, after.curvature),
    )
