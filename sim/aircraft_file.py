"""Aircraft are data: a TOML file a JSBSim model, with its envelope and the gains of its inner loops."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import msgspec

from planners.errors import InputError
from planners.footprint import Disc
from planners.typed_toml import read_toml
from sim.planet import Planet, planet_of
from sim.vehicle import Bound, Limits

AIRCRAFT_FOLDER = Path(__file__).parent / "aircraft"
ALL_AIRCRAFT = ("c172x", "ares")


Positive = Annotated[float, msgspec.Meta(gt=0.0)]
Bank = Annotated[float, msgspec.Meta(gt=0.0, lt=90.0)]  # [deg]


class Envelope(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the aircraft can do: speeds [m/s true], angles [deg], gradients [1], `corridor` half-width [m].

    `altitude` [m] is where it flies when none is given.
    """

    speed: Positive
    speed_min: Positive
    speed_max: Positive
    stall_speed: Positive
    alpha_stall: Positive
    bank_limit: Bank
    climb_gradient: Positive
    descent_gradient: Positive
    corridor: Positive
    altitude: Positive = 1000.0


class Roll(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Bank loop: times [s], `rate_limit` [deg/s], aileron per rad/s and per rad."""

    time: Positive
    rate_limit: Positive
    aileron: float
    aileron_integral: float
    response_time: Positive


class Yaw(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Turn coordination: rudder per rad/s of yaw rate and per g s of lateral acceleration, and per aileron.

    The last is what adverse yaw of the ailerons takes, as aircraft with weak directional stability need it.
    """

    rudder: float
    rudder_integral: float
    rudder_from_aileron: float = 0.0


class Pitch(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Altitude loop: times [s], climb and speed [m/s], `turn_lift` [deg/g], elevator per rad, rad/s and rad s.

    `speed_priority` [1] is the climb rate given up for the airspeed missing: in the lasting wind, beyond
    `speed_reserve`, or whatever the wind to the slowest of the envelope.
    """

    altitude_time: Positive
    climb_limit: Positive
    climb_change: Positive
    speed_reserve: float
    speed_priority: float
    climb: float
    climb_integral: float
    turn_lift: float
    elevator: float
    elevator_rate: float
    elevator_integral: float


class Throttle(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Airspeed loop: throttle per m/s, per m, per g of load factor above 1, per unit of climb gradient.

    `wind_time` [s] is how long a wind must last to count: the airspeed held is that in the mean wind of this time.
    """

    wind_time: Positive
    gain: float
    integral: float
    turn_power: float
    climb_power: float


class OwnAutopilot(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The model's own autopilot, which ours replaces: its JSBSim `systems`, and the `outputs` flight controls read."""

    systems: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()


class Operation(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a good flight keeps to: bank, stall margin [deg], load factor [g], altitude [m], airspeed error [m/s].

    `separation_min` [m] is the smallest distance wanted to another aircraft.
    """

    bank_max: Positive
    load_factor_max: Positive
    stall_margin_min: float
    altitude_error_max: Positive
    speed_error_max: Positive
    source: str
    separation_min: float = 0.0

    def bounds(self) -> tuple[Bound, ...]:
        """The same as default requirements, in SI units."""
        values = {
            "bank_max": math.radians(self.bank_max),
            "load_factor_max": self.load_factor_max,
            "altitude_error_max": self.altitude_error_max,
            "speed_error_max": self.speed_error_max,
        }
        most = tuple(Bound(metric, "<=", limit, self.source) for metric, limit in values.items())
        return (*most, Bound("stall_margin_min", ">=", math.radians(self.stall_margin_min), self.source))


class Aircraft(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One aircraft file. `root` is a JSBSim root folder beside the file; left out, JSBSim's own.

    `planet` is where it is at home, "earth" or "mars".
    """

    name: str
    model: str
    span: Positive
    envelope: Envelope
    operation: Operation
    roll: Roll
    yaw: Yaw
    pitch: Pitch
    throttle: Throttle
    own_autopilot: OwnAutopilot = OwnAutopilot()
    root: str = ""
    planet: str = "earth"

    @property
    def home(self) -> Planet:
        """The planet it is made for."""
        return planet_of(self.planet)

    @property
    def bank_limit(self) -> float:
        """Largest bank commanded [rad]."""
        return math.radians(self.envelope.bank_limit)

    def limits(self, planet: Planet) -> Limits:
        """The limits that guidance, feasibility and requirements use on `planet`."""
        envelope = self.envelope
        return Limits(
            kind="fixed-wing",
            speed=envelope.speed,
            speed_min=envelope.speed_min,
            speed_max=envelope.speed_max,
            lateral_acceleration=planet.gravity * math.tan(self.bank_limit),
            response_time=self.roll.response_time,
            equivalent_length=2.0 * envelope.speed * self.roll.response_time,
            corridor=envelope.corridor,
            footprint=Disc(self.span / 2),
            bounds=self.operation.bounds(),
            climb_gradient=envelope.climb_gradient,
            descent_gradient=envelope.descent_gradient,
            separation=self.operation.separation_min,
            altitude=envelope.altitude,
            gravity=planet.gravity,
        )


def load_aircraft(name_or_file: str) -> Aircraft:
    """A built-in aircraft by name, or one from a TOML file; raises `InputError` naming file and key."""
    built_in = name_or_file in ALL_AIRCRAFT
    file = AIRCRAFT_FOLDER / f"{name_or_file}.toml" if built_in else Path(name_or_file)
    aircraft = read_toml(file, Aircraft)
    try:
        planet_of(aircraft.planet)
    except InputError as error:
        raise InputError(str(file), *error.args[1:]) from None
    if aircraft.root:
        return msgspec.structs.replace(aircraft, root=str(file.parent / aircraft.root))
    return aircraft
