"""A truck on highway-env's kinematic bicycle, steered through a lag, a rate limit and the tyres' grip.

The reference point is the rear axle; highway-env's own position is mid-wheelbase and its LENGTH the wheelbase.
"""

from __future__ import annotations

import math

import numpy as np
from highway_env.vehicle.kinematics import Vehicle as HighwayVehicle

from planners.errors import InputError
from planners.footprint import Rectangle
from planners.units import STANDARD_GRAVITY
from sim.planet import EARTH
from sim.vehicle import NOT_A_NUMBER, Bound, Command, Conditions, Limits, Pose, State

WHEELBASE = 4.5  # [m] a two-axle 7 m truck
BODY_LENGTH, BODY_WIDTH = 7.0, 2.5  # [m]; 2.5 m is the legal width in most countries (EU 96/53/EC: 2.55 m)
STEERING_LIMIT = math.radians(45.0)
STEERING_RATE = math.radians(30.0)  # [rad/s] at the front wheels
STEERING_LAG = 0.2  # [s] first-order
FRICTION = 0.8  # tyre on dry asphalt; the 0.6 g of paper 004 eq. 8 is a requirement, this is the plant
LATERAL_REQUIREMENT = 0.6 * STANDARD_GRAVITY  # [m/s^2] paper 004 eq. 8
SPEED_LAG, ACCELERATION_LIMIT = 0.5, 2.0  # [s], [m/s^2] of the cruise control
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
        held_periods = 1.0 / (steering_hz * self.period) if steering_hz > 0.0 else 0.0
        if held_periods < 1.0 or abs(held_periods - round(held_periods)) > 1e-6:
            remedy = f"choose {1 / self.period:g} divided by a whole number, as 2"
            raise InputError("steering-hz", f"{steering_hz:g} is not a rate to steer at", remedy)
        self.guidance_period = round(held_periods) * self.period
        self.limits = Limits(
            kind="ground",
            speed=45.0 / 3.6,
            speed_min=1.0,
            speed_max=40.0,
            lateral_acceleration=LATERAL_REQUIREMENT,
            response_time=STEERING_LAG,
            equivalent_length=WHEELBASE,
            corridor=0.5,
            footprint=Rectangle(BODY_LENGTH, BODY_WIDTH, ahead=WHEELBASE / 2),
            bounds=(Bound("lateral_acceleration_max", "<=", LATERAL_REQUIREMENT, "paper 004, eq. 8: 0.6 g"),),
            curvature_max=math.tan(STEERING_LIMIT) / WHEELBASE,
            steering_max=STEERING_LIMIT,
            steering_rate=STEERING_RATE,
            friction=FRICTION,
        )

    def reset(self, pose: Pose, speed: float, conditions: Conditions, seed: int) -> State:
        """Start at `pose`, wheels straight, at `speed` [m/s]; only the friction of `conditions` is felt by a truck."""
        if not self.limits.speed_min <= speed <= self.limits.speed_max:
            raise InputError(
                "speed",
                f"the truck cannot drive at {speed:.4g} m/s",
                f"choose {self.limits.speed_min:g} to {self.limits.speed_max:g} m/s",
            )
        friction = FRICTION if conditions.friction is None else conditions.friction
        if not 0.0 < friction < math.inf:
            raise InputError("friction", f"{friction:g} is no coefficient of friction", "choose one above 0, as 0.8")
        self._grip = friction * STANDARD_GRAVITY
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
