"""A truck whose tyres slip: what the kinematic truck hides.

A military two-axle truck, MAN KAT1 5t, as Project Chrono models it (chrono_models/vehicle/man, BSD-3; the numbers
only). Masses and inertias are the sums of its parts, unladen; its wheelbase is the kinematic truck's. Size, steering
and cruise control are the kinematic truck's too, so that the two differ by their tyres alone.
"""

from __future__ import annotations

import math

from planners.units import STANDARD_GRAVITY
from sim.planet import EARTH
from sim.single_track import (
    Motion,
    SingleTrack,
    axle_forces,
    cornering_drag,
    rates,
    rear_course,
    rear_sideways,
    runge_kutta,
)
from sim.truck_limits import (
    ACCELERATION_LIMIT,
    SPEED,
    SPEED_LAG,
    STEERING_LAG,
    STEERING_LIMIT,
    STEERING_RATE,
    road_friction,
    steering_period,
    truck_limits,
)
from sim.vehicle import NOT_A_NUMBER, Command, Conditions, Pose, State

# Chassis 7085 kg and 29 395 kg m^2, 1.748 m behind the front axle; axles with wheels and tyres 1239 and 1198 kg.
# Tyres 14.00R20: Chrono's pattern of truck tyres (ChTMeasyTire.cpp, 2023, after Pacejka) at the static wheel loads of
# 27.3 and 19.4 kN, nominal 16.1 kN at 4.5 bar. Payload, and the compliance that would add understeer, are left out.
MAN_KAT1 = SingleTrack(
    mass=9522.0, yaw_inertia=43_680.0, front=1.867, rear=2.633, front_stiffness=7.02, rear_stiffness=7.29
)
RESPONSE_TIME = STEERING_LAG + MAN_KAT1.course_delay(SPEED)  # [s] from curvature commanded to curvature driven
# A truck on slipping tyres swings like a longer one: as for aircraft, so that Stanley's gain on the course stays below
# what the delay allows. With the wheelbase, Stanley goes astray at 60 km/h and 0.3 g.
EQUIVALENT_LENGTH = 2.0 * SPEED * RESPONSE_TIME  # [m]
SUBSTEPS = 4  # Runge-Kutta steps a control period, 0.0125 s each: stable down to SLOWEST_ROLL


class TruckDynamic:
    """The `truck-dynamic`: `steering_hz` is how often guidance may steer.

    A commanded curvature k becomes the steering atan(k L), as in the kinematic truck: who steers does not know the
    tyres, so understeer shows. `lateral_acceleration` is that of the centre of gravity across the body (ISO 8855):
    what the tyres give, in steady turns speed times yaw rate. `friction_use` is that of the axle that uses more of it.
    """

    name = "truck-dynamic"
    planet = EARTH
    period = 0.05
    channels: tuple[str, ...] = ("steering", "steering_rate", "lateral_acceleration", "friction_use", "yaw_rate")

    def __init__(self, steering_hz: float = 20.0) -> None:
        self.guidance_period = steering_period(steering_hz, self.period)
        self.limits = truck_limits(RESPONSE_TIME, EQUIVALENT_LENGTH)

    def reset(self, pose: Pose, speed: float, conditions: Conditions, seed: int) -> State:
        """Start at `pose`, wheels straight, at `speed` [m/s]; only the friction of `conditions` is felt by a truck."""
        self._friction = road_friction(self.limits, speed, conditions)
        self._t, self._z = 0.0, pose.z
        self._motion = Motion(pose.x, pose.y, pose.course, speed, 0.0, 0.0, 0.0)
        return self._state(Command(0.0, speed), 0.0, False)

    def step(self, command: Command) -> State:
        """Steer towards the commanded curvature for one control period."""
        before = self._motion.steering
        target = math.atan(command.curvature * MAN_KAT1.wheelbase)
        held_back = abs(target) > STEERING_LIMIT or abs(target - before) > STEERING_RATE * STEERING_LAG
        for _ in range(SUBSTEPS):
            self._motion = runge_kutta(lambda now: self._rates(now, command), self._motion, self.period / SUBSTEPS)
        self._t, self._z = self._t + self.period, command.altitude
        return self._state(command, (self._motion.steering - before) / self.period, held_back)

    def _rates(self, now: Motion, command: Command) -> Motion:
        """The motion's rates with the steering gear and the cruise control at work."""
        forces = axle_forces(MAN_KAT1, now, self._friction)
        target = _limited(math.atan(command.curvature * MAN_KAT1.wheelbase), STEERING_LIMIT)
        steering_rate = _limited((target - now.steering) / STEERING_LAG, STEERING_RATE)
        speed = math.hypot(now.forward, rear_sideways(MAN_KAT1, now))
        # The speed's rate wanted, and what the curve takes from it
        drive = (
            (command.speed - speed) / SPEED_LAG + cornering_drag(MAN_KAT1, now, forces) - now.sideways * now.yaw_rate
        )
        most = min(ACCELERATION_LIMIT, self._friction * STANDARD_GRAVITY)
        return rates(MAN_KAT1, now, forces, _limited(drive, most), steering_rate)

    def _state(self, command: Command, steering_rate: float, held_back: bool) -> State:
        now, change = self._motion, self._rates(self._motion, command)
        forces = axle_forces(MAN_KAT1, now, self._friction)
        front, rear = (abs(f) / (self._friction * load) for f, load in zip(forces, MAN_KAT1.axle_loads(), strict=True))
        lateral = change.sideways + now.forward * now.yaw_rate
        rear_axle = rear_course(MAN_KAT1, now, change)
        return State(
            self._t, now.x, now.y, self._z, now.heading, rear_axle.course, rear_axle.speed, rear_axle.speed, 0.0,
            rear_axle.curvature, held_back or max(front, rear) >= 1.0,
            (now.steering, steering_rate, lateral, max(front, rear), now.yaw_rate),
            "" if math.isfinite(now.x + now.y + now.heading) else NOT_A_NUMBER,
        )  # fmt: skip


def _limited(value: float, most: float) -> float:
    return max(-most, min(most, value))
