"""The seam to simulated vehicles: what they are told, what they answer, what they can do."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Protocol

import msgspec

from planners.footprint import Footprint
from planners.frame import Frame
from planners.units import STANDARD_GRAVITY
from sim.planet import Planet
from sim.wind import Dryden, Gust, Wind

NOT_A_NUMBER, STALL, GROUND = "not a number", "stall", "ground"  # faults of a state


class Command(msgspec.Struct, frozen=True):
    """What guidance asks for: `curvature` over the ground [1/m, left positive], `speed` [m/s], `altitude` [m].

    `gradient` is the slope of the path there, metres up per metre over the ground, as feed-forward. For aircraft
    `speed` is true airspeed, for ground vehicles speed over the ground at the reference point.
    """

    curvature: float
    speed: float
    altitude: float = 0.0
    gradient: float = 0.0


class State(msgspec.Struct, frozen=True):
    """The truth after a control period, in the local frame (a msgspec struct because it is made 20 times a second).

    Time `t` [s]; `x` east, `y` north, `z` up [m]; `heading` and `course` [rad from east, left positive];
    `ground_speed`, `airspeed`, `climb_rate` [m/s]; `curvature` over the ground [1/m]; `saturated`, whether an actuator
    or limit held the vehicle back; `channels`, the vehicle's own quantities in the order of `Vehicle.channels`;
    `fault`, why the vehicle cannot go on ("stall", "ground", "not a number"), or "".
    """

    t: float
    x: float
    y: float
    z: float
    heading: float
    course: float
    ground_speed: float
    airspeed: float
    climb_rate: float
    curvature: float
    saturated: bool
    channels: tuple[float, ...]
    fault: str = ""


@dataclass(frozen=True, slots=True)
class Pose:
    """Where a run starts: `x`, `y`, `z` [m] and the `course` to be on [rad from east]."""

    x: float
    y: float
    z: float
    course: float


@dataclass(frozen=True, slots=True)
class Conditions:
    """The world a trial runs in: steady `wind`, and the `frame` that places the local coordinates on the planet.

    Without a `frame`, the origin is at latitude 0, longitude 0. `turbulence` is the severity of Dryden turbulence on
    Earth as the number of MIL-F-8785C's probability-of-exceedance curve (3 light, 4 moderate, 6 severe), 0 for none;
    `dryden` is turbulence by its strength and length, on any planet. `mass_factor` multiplies an aircraft's mass,
    `friction` is the tyres' coefficient on this road, None the vehicle's own.
    """

    wind: Wind = field(default_factory=Wind)
    frame: Frame | None = None
    turbulence: float = 0.0
    gust: Gust | None = None
    dryden: Dryden | None = None
    mass_factor: float = 1.0
    friction: float | None = None


@dataclass(frozen=True, slots=True)
class Bound:
    """A limit that a vehicle's operation sets by default: `metric` `comparison` `limit` [SI], and its `source`."""

    metric: str
    comparison: str
    limit: float
    source: str


@dataclass(frozen=True, slots=True)
class Limits:
    """What a vehicle can do, for controllers, for the feasibility of a plan, and as default requirements.

    `kind` is "fixed-wing" or "ground". `speed` is the default, `speed_min` and `speed_max` what it accepts [m/s].
    `lateral_acceleration` [m/s^2] bounds turning: g tan(bank limit), or the ground vehicle's requirement.
    `curvature_max` [1/m] is the steering geometry's (inf for aircraft). `response_time` [s] is the lag from a
    commanded to an achieved curvature, `equivalent_length` [m] the wheelbase or what stands for it, `steering_max`
    [rad] the front wheels' (inf for aircraft),
    `climb_gradient` and `descent_gradient` [1] the steepest sustained path, `corridor` [m] the default half-width,
    `footprint` the body, `bounds` what else must hold for a run to be good, `separation` [m] the smallest distance
    wanted to another vehicle. `altitude` [m] is the default, `gravity` [m/s^2] that of where the vehicle is.
    """

    kind: str
    speed: float
    speed_min: float
    speed_max: float
    lateral_acceleration: float
    response_time: float
    equivalent_length: float
    corridor: float
    footprint: Footprint
    bounds: tuple[Bound, ...] = ()
    curvature_max: float = math.inf
    steering_max: float = math.inf
    climb_gradient: float = 0.0
    descent_gradient: float = 0.0
    separation: float = 0.0
    altitude: float = 0.0
    gravity: float = STANDARD_GRAVITY

    def turn_radius(self, ground_speed: float, crab: float = 0.0) -> float:
        """Smallest turn radius [m] at `ground_speed` [m/s] with `crab` [rad] between heading and course.

        Coordinated turn in wind: Vg^2 / (a_lat cos(crab)); ground vehicle: v^2 / a_lat, never below its steering's.
        """
        return max(ground_speed**2 / (self.lateral_acceleration * math.cos(crab)), 1.0 / self.curvature_max)


class Vehicle(Protocol):
    """A simulated plant that takes a `Command` every `period` [s] and returns the true `State`.

    Guidance renews the command every `guidance_period` [s], a multiple of `period`. `channels` names the vehicle's own
    quantities, in SI units; `limits` what it can do on the `planet` where it is.
    """

    name: str
    planet: Planet
    limits: Limits
    period: float
    guidance_period: float
    channels: tuple[str, ...]

    def reset(self, pose: Pose, speed: float, conditions: Conditions, seed: int) -> State:
        """Start in equilibrium at `pose` and `speed` [m/s]; raises `InputError` where that is impossible."""

    def step(self, command: Command) -> State:
        """Advance one control period."""
