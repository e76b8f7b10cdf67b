"""A truck on highway-env's kinematic bicycle, steered through a lag, a rate limit and the tyres' grip.

The reference point is the rear axle; highway-env's own position is mid-wheelbase and its LENGTH the wheelbase.
"""

from __future__ import annotations

import math

import numpy as np
from highway_env.vehicle.kinematics import Vehicle as HighwayVehicle

from planners.units import STANDARD_GRAVITY
from sim.planet import EARTH
from sim.truck_limits import (
    ACCELERATION_LIMIT,
    BODY_WIDTH,
    SPEED_LAG,
    STEERING_LAG,
    STEERING_LIMIT,
    STEERING_RATE,
    WHEELBASE,
    road_friction,
    steering_period,
    truck_limits,
)
from sim.vehicle import NOT_A_NUMBER, Command, Conditions, Pose, State

SUBSTEPS = 5  # Euler steps a control period, 0.01 s each


class _Bicycle(HighwayVehicle):  # type: ignore[misc]
    """highway-env's vehicle with this truck's wheelbase, and without a traffic simulation's speed limit."""

    LENGTH = WHEELBASE
    WIDTH = BODY_WIDTH
    MAX_SPEED = 100.0


class Truck:
    """The `truck`: `steering_hz` is how often guidance may steer (paper 004 steers at 2 Hz)."""

    name = "truck"
    planet = EARTH
    period = 0.05
    channels: tuple[str, ...] = ("steering", "steering_rate", "lateral_acceleration", "friction_use")

    def __init__(self, steering_hz: float = 20.0) -> None:
        self.guidance_period = steering_period(steering_hz, self.period)
        self.limits = truck_limits(STEERING_LAG, WHEELBASE)

    def reset(self, pose: Pose, speed: float, conditions: Conditions, seed: int) -> State:
        """Start at `pose`, wheels straight, at `speed` [m/s]; only the friction of `conditions` is felt by a truck."""
        self._grip = road_friction(self.limits, speed, conditions) * STANDARD_GRAVITY
        ahead = WHEELBASE / 2 * np.array([math.cos(pose.course), math.sin(pose.course)])
        self._plant = _Bicycle(None, np.array([pose.x, pose.y]) + ahead, pose.course, speed)
        self._t, self._z, self._steering = 0.0, pose.z, 0.0
        return self._state(0.0, False)

    def step(self, command: Command) -> State:
        """Steer towards the commanded curvature for one control period."""
        target = math.atan(command.curvature * WHEELBASE)
        limited = max(-STEERING_LIMIT, min(STEERING_LIMIT, target))
        dt = self.period / SUBSTEPS
        reach = 1.0 - math.exp(-dt / STEERING_LAG)
        plant = self._plant
        saturated, before = limited != target, self._steering
        for _ in range(SUBSTEPS):
            turn = (limited - self._steering) * reach
            if abs(turn) > STEERING_RATE * dt:
                turn, saturated = math.copysign(STEERING_RATE * dt, turn), True
            self._steering += turn
            steering = self._grip_limited()
            slip = math.atan(0.5 * math.tan(steering))
            error = command.speed / math.cos(slip) - plant.speed
            acceleration = max(-ACCELERATION_LIMIT, min(ACCELERATION_LIMIT, error / SPEED_LAG))
            plant.action = {"steering": steering, "acceleration": acceleration}
            plant.step(dt)
        self._t, self._z = self._t + self.period, command.altitude
        return self._state((self._steering - before) / self.period, saturated)

    def _grip_limited(self) -> float:
        """The steering angle [rad] the tyres can turn into a curve; with more, the truck runs wide.

        With T = tan(delta), the rear axle moves at v / sqrt(1 + T^2 / 4) when the centre moves at v; so the lateral
        acceleration v^2 T / (L (1 + T^2 / 4)) reaches the grip at the smaller root of a quadratic in T.
        """
        square, grip = self._plant.speed**2, self._grip * WHEELBASE
        if square <= grip:
            return self._steering
        most = math.atan(2.0 * (square - math.sqrt(square * square - grip * grip)) / grip)
        return max(-most, min(most, self._steering))

    def _state(self, steering_rate: float, saturated: bool) -> State:
        plant = self._plant
        heading = float(plant.heading)
        x = float(plant.position[0]) - WHEELBASE / 2 * math.cos(heading)
        y = float(plant.position[1]) - WHEELBASE / 2 * math.sin(heading)
        held = self._grip_limited()
        curvature = math.tan(held) / WHEELBASE
        rear_speed = float(plant.speed) * math.cos(math.atan(0.5 * math.tan(held)))
        lateral = rear_speed * rear_speed * curvature
        return State(
            self._t, x, y, self._z, heading, heading, rear_speed, rear_speed, 0.0, curvature,
            saturated or held != self._steering,
            (self._steering, steering_rate, lateral, abs(lateral) / self._grip),
            "" if math.isfinite(x + y + heading) else NOT_A_NUMBER,
        )  # fmt: skip
