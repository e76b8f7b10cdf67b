"""A single-track vehicle with tyre slip: two axles, lateral and yaw dynamics, tyres that saturate at the grip.

Plane motion of a rigid body (Rajamani, Vehicle Dynamics and Control, 2nd ed. 2012, sec. 2.3, without its small
angles) on brush tyres (Fiala 1954; Pacejka, Tyre and Vehicle Dynamics, 3rd ed. 2012, sec. 3.2.1). Left out: roll and
load transfer, compliance of suspension and steering, tyre relaxation, and the grip that driving takes from cornering
(holding 45 km/h in a curve of 0.57 g takes 0.07 g, which would leave 0.797 g of 0.8 g to the sides).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

from planners.units import STANDARD_GRAVITY

SLOWEST_ROLL = 0.5  # [m/s] slip angles count as if rolling this fast: they have no meaning at rest


@dataclass(frozen=True, slots=True)
class SingleTrack:
    """A body of `mass` [kg] and `yaw_inertia` [kg m^2], its centre of gravity `front` and `rear` [m] from the axles.

    `front_stiffness` and `rear_stiffness` [1/rad] are the axles' cornering stiffness over their static load.
    """

    mass: float
    yaw_inertia: float
    front: float
    rear: float
    front_stiffness: float
    rear_stiffness: float

    @property
    def wheelbase(self) -> float:
        """Distance [m] of the axles."""
        return self.front + self.rear

    @property
    def understeer(self) -> float:
        """Understeer gradient K [rad s^2/m]: a steady turn takes steering (L + K v^2) / R (Gillespie 1992, ch. 6)."""
        return (1.0 / self.front_stiffness - 1.0 / self.rear_stiffness) / STANDARD_GRAVITY

    def course_delay(self, speed: float) -> float:
        """Mean delay [s] of the rear axle's course behind small steering at `speed` [m/s].

        It is 2 zeta / omega of the characteristic equation (Rajamani 2012, sec. 2.3; Gillespie 1992, ch. 6): the yaw
        rate's own delay and that of the slip at the rear axle, which cancels the zero of the yaw rate's response.
        """
        front_load, rear_load = self.axle_loads()
        front, rear = front_load * self.front_stiffness, rear_load * self.rear_stiffness
        lateral = (front + rear) * self.yaw_inertia
        yaw = (front * self.front**2 + rear * self.rear**2) * self.mass
        square = self.wheelbase * (self.wheelbase + self.understeer * speed**2)
        return speed * (lateral + yaw) / (front * rear * square)

    def axle_loads(self) -> tuple[float, float]:
        """Static load [N] on the front and the rear axle."""
        weight = self.mass * STANDARD_GRAVITY
        return weight * self.rear / self.wheelbase, weight * self.front / self.wheelbase


class Motion(NamedTuple):
    """The plane motion, and its rate of change in the same order.

    `x`, `y` [m] of the rear axle's centre, `heading` [rad]; `forward` and `sideways` [m/s] of the centre of gravity
    along the body and to its left; `yaw_rate` [rad/s]; `steering` [rad] of the front wheels.
    """

    x: float
    y: float
    heading: float
    forward: float
    sideways: float
    yaw_rate: float
    steering: float


class Forces(NamedTuple):
    """Lateral force [N] of the `front` and the `rear` axle, across its wheels, left positive."""

    front: float
    rear: float


class Course(NamedTuple):
    """Where the rear axle goes: `course` [rad], `speed` [m/s] and `curvature` [1/m] over the ground."""

    course: float
    speed: float
    curvature: float


def brush(slip: float, stiffness: float, friction: float) -> float:
    """Lateral force over the load of a tyre at a `slip` angle [rad]; `friction` when it slides.

    friction (1 - (1 - tan(slip) / tan(slide))^3) with tan(slide) = 3 friction / stiffness; `stiffness` [1/rad] is the
    slope at zero.
    """
    slide = 3.0 * friction / stiffness
    if abs(slip) >= math.atan(slide):
        return math.copysign(friction, slip)
    return math.copysign(friction * (1.0 - (1.0 - abs(math.tan(slip)) / slide) ** 3), slip)


def axle_forces(body: SingleTrack, now: Motion, friction: float) -> Forces:
    """What the tyres do on a road of this `friction`."""
    roll = max(now.forward, SLOWEST_ROLL)
    front_slip = now.steering - math.atan2(now.sideways + body.front * now.yaw_rate, roll)
    rear_slip = -math.atan2(rear_sideways(body, now), roll)
    front_load, rear_load = body.axle_loads()
    return Forces(
        front_load * brush(front_slip, body.front_stiffness, friction),
        rear_load * brush(rear_slip, body.rear_stiffness, friction),
    )


def rates(body: SingleTrack, now: Motion, forces: Forces, drive: float, steering_rate: float) -> Motion:
    """Rate of change of the motion under the tyres' `forces`, the `drive` [m/s^2] and the `steering_rate` [rad/s]."""
    cos_heading, sin_heading = math.cos(now.heading), math.sin(now.heading)
    across = forces.front * math.cos(now.steering)
    rear = rear_sideways(body, now)
    return Motion(
        now.forward * cos_heading - rear * sin_heading,
        now.forward * sin_heading + rear * cos_heading,
        now.yaw_rate,
        drive - cornering_drag(body, now, forces) + now.sideways * now.yaw_rate,
        (across + forces.rear) / body.mass - now.forward * now.yaw_rate,
        (body.front * across - body.rear * forces.rear) / body.yaw_inertia,
        steering_rate,
    )


def rear_sideways(body: SingleTrack, now: Motion) -> float:
    """Speed [m/s] of the rear axle to the left of the body; from a rate of change, its acceleration along with it."""
    return now.sideways - body.rear * now.yaw_rate


def rear_course(body: SingleTrack, now: Motion, change: Motion) -> Course:
    """The rear axle's course as its motion and the motion's rate of `change` have it."""
    across, across_rate = rear_sideways(body, now), rear_sideways(body, change)
    square = now.forward**2 + across**2
    speed, course = math.sqrt(square), now.heading + math.atan2(across, now.forward)
    if speed < SLOWEST_ROLL:
        return Course(course, speed, now.yaw_rate / SLOWEST_ROLL)
    course_rate = now.yaw_rate + (now.forward * across_rate - across * change.forward) / square
    return Course(course, speed, course_rate / speed)


def cornering_drag(body: SingleTrack, now: Motion, forces: Forces) -> float:
    """Deceleration [m/s^2] by the part of the front tyres' force that points backwards."""
    return forces.front * math.sin(now.steering) / body.mass


def runge_kutta(rate: Callable[[Motion], Motion], now: Motion, dt: float) -> Motion:
    """The motion `dt` [s] later, by the classical Runge-Kutta method of order four."""
    first = rate(now)
    second = rate(_moved(now, first, 0.5 * dt))
    third = rate(_moved(now, second, 0.5 * dt))
    fourth = rate(_moved(now, third, dt))
    mean = ((a + 2.0 * b + 2.0 * c + d) / 6.0 for a, b, c, d in zip(first, second, third, fourth, strict=True))
    return _moved(now, mean, dt)


def _moved(now: Motion, rate: Iterable[float], dt: float) -> Motion:
    return Motion._make(value + dt * change for value, change in zip(now, rate, strict=True))
