"""What every truck shares, whatever simulates it: size, steering, cruise control, requirements."""

from __future__ import annotations

import math

from planners.errors import InputError
from planners.footprint import Rectangle
from planners.units import STANDARD_GRAVITY
from sim.vehicle import Bound, Conditions, Limits

WHEELBASE = 4.5  # [m] a two-axle 7 m truck
BODY_LENGTH, BODY_WIDTH = 7.0, 2.5  # [m]; 2.5 m is the legal width in most countries (EU 96/53/EC: 2.55 m)
STEERING_LIMIT = math.radians(45.0)
STEERING_RATE = math.radians(30.0)  # [rad/s] at the front wheels
STEERING_LAG = 0.2  # [s] first-order
FRICTION = 0.8  # tyre on dry asphalt; the 0.6 g of paper 004 eq. 8 is a requirement, this is the plant
LATERAL_REQUIREMENT = 0.6 * STANDARD_GRAVITY  # [m/s^2] paper 004 eq. 8
SPEED = 45.0 / 3.6  # [m/s] by default, the middle one of paper 004
SPEED_LAG, ACCELERATION_LIMIT = 0.5, 2.0  # [s], [m/s^2] of the cruise control


def truck_limits(response_time: float, equivalent_length: float) -> Limits:
    """The limits of a truck; its `response_time` [s] and `equivalent_length` [m] are as in `Limits`."""
    return Limits(
        kind="ground",
        speed=SPEED,
        speed_min=1.0,
        speed_max=40.0,
        lateral_acceleration=LATERAL_REQUIREMENT,
        response_time=response_time,
        equivalent_length=equivalent_length,
        corridor=0.5,
        footprint=Rectangle(BODY_LENGTH, BODY_WIDTH, ahead=WHEELBASE / 2),
        bounds=(Bound("lateral_acceleration_max", "<=", LATERAL_REQUIREMENT, "paper 004, eq. 8: 0.6 g"),),
        curvature_max=math.tan(STEERING_LIMIT) / WHEELBASE,
        steering_max=STEERING_LIMIT,
        steering_rate=STEERING_RATE,
        friction=FRICTION,
    )


def steering_period(steering_hz: float, period: float) -> float:
    """Time [s] between two steering commands, a multiple of the control `period` [s]; `InputError` for what is none."""
    held_periods = 1.0 / (steering_hz * period) if steering_hz > 0.0 else 0.0
    if held_periods < 1.0 or abs(held_periods - round(held_periods)) > 1e-6:
        remedy = f"choose {1 / period:g} divided by a whole number, as 2"
        raise InputError("steering-hz", f"{steering_hz:g} is not a rate to steer at", remedy)
    return round(held_periods) * period


def road_friction(limits: Limits, speed: float, conditions: Conditions) -> float:
    """The tyres' coefficient of friction in these `conditions`; `InputError` where no truck can start so."""
    if not limits.speed_min <= speed <= limits.speed_max:
        raise InputError(
            "speed",
            f"the truck cannot drive at {speed:.4g} m/s",
            f"choose {limits.speed_min:g} to {limits.speed_max:g} m/s",
        )
    friction = FRICTION if conditions.friction is None else conditions.friction
    if not 0.0 < friction < math.inf:
        raise InputError("friction", f"{friction:g} is no coefficient of friction", "choose one above 0, as 0.8")
    return friction
