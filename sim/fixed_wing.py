"""A fixed wing in JSBSim's six degrees of freedom: curvature becomes bank, and the truth comes back."""

from __future__ import annotations

import math
from dataclasses import replace

from planners.errors import InputError
from planners.frame import point_transform, true_north
from planners.units import METRES_PER_FOOT, STANDARD_GRAVITY, wrap
from sim.aircraft_file import Aircraft
from sim.autopilot import Autopilot
from sim.ballast import scale_mass
from sim.disturbance import gusts_of, start_turbulence
from sim.jsbsim_model import (
    KILOGRAMS_PER_POUND,
    NoEquilibriumError,
    load_model,
    property_node,
    release_level,
    start_in_equilibrium,
)
from sim.planet import EARTH, Planet
from sim.planet_air import check_planet
from sim.vehicle import GROUND, NOT_A_NUMBER, STALL, Command, Conditions, Pose, State

STEP = 1.0 / 120.0  # [s] of the simulation and, in it, of the attitude loops
STEPS = 6  # a control period: guidance at 20 Hz
NORTH_EVERY = 20  # control periods in which true north does not turn in the frame by more than 1e-5 rad


class FixedWing:
    """An aircraft of an `Aircraft` file under its autopilot, on `planet` (None: at home).

    `load_factor` is in weights on that planet, `fuel` what is left in the tanks [kg].
    """

    period = guidance_period = STEPS * STEP
    channels: tuple[str, ...] = (
        "bank",
        "pitch",
        "load_factor",
        "angle_of_attack",
        "stall_margin",
        "sideslip",
        "throttle",
        "fuel",
    )

    def __init__(self, aircraft: Aircraft, planet: Planet | None = None) -> None:
        self.name = aircraft.name
        self.planet = planet or aircraft.home
        self.limits = aircraft.limits(self.planet)
        self._aircraft = aircraft
        self._weights_per_g = STANDARD_GRAVITY / self.planet.gravity

    def reset(self, pose: Pose, speed: float, conditions: Conditions, seed: int) -> State:
        """Start in equilibrium in the wind, on the course of `pose`, at the true airspeed `speed` [m/s].

        `seed` decides the turbulence, which grows from calm in the first seconds. Off its home planet, an aircraft
        that has no equilibrium is let go level, at full throttle.
        """
        self._check(speed, pose)
        self._check_world(conditions)
        frame = conditions.frame or self.planet.frame()
        transformer = point_transform(frame)
        lon, lat = transformer.transform(pose.x, pose.y, direction="INVERSE")
        fdm = load_model(self._aircraft, STEP, self.planet)
        scale_mass(fdm, conditions.mass_factor)
        self._north = true_north(frame, lat, lon)
        convergence = self._north - math.pi / 2
        on_course = replace(pose, course=pose.course - convergence)
        try:
            start_in_equilibrium(fdm, on_course, lat, lon, speed, conditions.wind)
        except NoEquilibriumError:
            if self.planet == self._aircraft.home:
                raise
            release_level(fdm, on_course, lat, lon, speed, conditions.wind)
        check_planet(fdm, self.planet, lat, pose.z)
        start_turbulence(fdm, conditions.turbulence, seed)
        self._blow = gusts_of(fdm, conditions.gust, conditions.dryden, speed, STEP, seed)
        self._frame, self._to_local = frame, transformer.transform
        self._samples = 0
        self._autopilot = Autopilot(self._aircraft, fdm, self.period)
        self._run, self._t = fdm.run, 0.0
        names = (
            "position/long-gc-deg", "position/lat-geod-deg", "position/geod-alt-ft",
            "velocities/v-east-fps", "velocities/v-north-fps", "velocities/h-dot-fps", "velocities/vt-fps",
            "attitude/phi-rad", "attitude/theta-rad", "attitude/psi-rad",
            "accelerations/Nz", "aero/alpha-rad", "aero/beta-rad", "accelerations/gravity-ft_sec2", "position/h-agl-ft",
            "gear/wow", "propulsion/total-fuel-lbs",
        )  # fmt: skip
        self._nodes = [property_node(fdm, name).get_double_value for name in names]
        self._course = pose.course
        self._state = self._observe(False)
        return self._state

    def step(self, command: Command) -> State:
        """Bank for the commanded curvature, hold airspeed and altitude, for one control period.

        tan(bank) = Vg^2 k / (g cos(crab)), with the ground speed and the crab angle of the moment.
        """
        state = self._state
        crab = state.heading - state.course
        wanted = math.atan(state.ground_speed**2 * command.curvature / (self._gravity * math.cos(crab)))
        most = self._aircraft.bank_limit
        bank = max(-most, min(most, wanted))
        self._autopilot.command(
            -bank, state.channels[0], command.speed, state.airspeed, state.climb_rate,
            command.altitude - state.z, self._climbable(command.gradient) * state.ground_speed,
        )  # fmt: skip
        run, blow = self._run, self._blow
        for i in range(1, STEPS + 1):
            if blow is not None:
                blow(self._t + i * STEP)
            run()
        self._t += self.period
        self._state = self._observe(bank != wanted)
        return self._state

    def _climbable(self, gradient: float) -> float:
        """The path's slope as far as the aircraft can climb or descend; an autopilot arrives late, but it arrives."""
        return max(-self.limits.descent_gradient, min(self.limits.climb_gradient, gradient))

    def _observe(self, saturated: bool) -> State:
        (
            lon,
            lat,
            height,
            east,
            north,
            climb,
            airspeed,
            phi,
            theta,
            psi,
            nz,
            alpha,
            beta,
            gravity,
            above_ground,
            on_wheels,
            fuel,
        ) = [read() for read in self._nodes]
        x, y = self._to_local(lon, lat)
        if self._samples == NORTH_EVERY:
            self._north, self._samples = true_north(self._frame, lat, lon), 0
        self._samples += 1
        ground_speed = math.hypot(east, north) * METRES_PER_FOOT
        # Unwrapped, so that a turn over the period is a difference
        course = self._course + wrap(self._north - math.atan2(east, north) - self._course)
        turned = course - self._course
        curvature = turned / (ground_speed * self.period) if self._t and ground_speed else 0.0
        self._course = course
        heading = course + wrap(self._north - psi - course)
        self._gravity = gravity * METRES_PER_FOOT
        stall_margin = math.radians(self._aircraft.envelope.alpha_stall) - alpha
        return State(
            self._t, x, y, height * METRES_PER_FOOT, heading, course, ground_speed, airspeed * METRES_PER_FOOT,
            climb * METRES_PER_FOOT, curvature, saturated,
            (
                -phi, theta, nz * self._weights_per_g, alpha, stall_margin, beta, self._autopilot.throttle,
                fuel * KILOGRAMS_PER_POUND,
            ),
            _fault(x + y + height + heading, above_ground <= 0.0 or on_wheels > 0.0, stall_margin),
        )  # fmt: skip

    def _check_world(self, conditions: Conditions) -> None:
        planet = self.planet
        if conditions.turbulence and planet != EARTH:
            raise InputError(
                "turbulence",
                f"severities are those of the Earth, not of {planet.name}",
                "give dryden turbulence, its sigma and length",
            )
        frame = conditions.frame
        if frame is not None and (frame.a, frame.b) != (planet.a, planet.b):
            raise InputError(
                "frame",
                f"its ellipsoid of {frame.a:.0f} m is not that of {planet.name}, {planet.a:.0f} m",
                "fly on the path's planet",
            )

    def _check(self, speed: float, pose: Pose) -> None:
        envelope = self._aircraft.envelope
        if speed < envelope.speed_min:
            stall = "below its stall speed" if speed < envelope.stall_speed else "too close to its stall speed"
            raise InputError(
                "speed",
                f"{speed:.4g} m/s is {stall} of {envelope.stall_speed:g} m/s for the {self.name}",
                f"choose {envelope.speed_min:g} to {envelope.speed_max:g} m/s",
            )
        if speed > envelope.speed_max:
            raise InputError(
                "speed",
                f"the {self.name} cannot hold {speed:.4g} m/s",
                f"choose {envelope.speed_min:g} to {envelope.speed_max:g} m/s",
            )
        if pose.z <= 0.0:
            raise InputError("altitude", f"{pose.z:.4g} m is not above the ground", "choose an altitude above 0 m")


def _fault(finite: float, on_ground: bool, stall_margin: float) -> str:
    if not math.isfinite(finite):
        return NOT_A_NUMBER
    if on_ground:
        return GROUND
    return STALL if stall_margin <= 0.0 else ""
