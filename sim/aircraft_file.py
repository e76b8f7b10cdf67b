"""Aircraft are data: a TOML file a JSBSim model, with its envelope and the gains of its inner loops."""

from __future__ import annotations

import math
from pathlib import Path

import msgspec

from planners.errors import InputError
from planners.footprint import Disc
from planners.units import STANDARD_GRAVITY
from sim.vehicle import Limits

AIRCRAFT_FOLDER = Path(__file__).parent / "aircraft"
ALL_AIRCRAFT = ("c172x",)


class _Table(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    pass


class Envelope(_Table):
    """What the aircraft can do: speeds [m/s true], angles [deg], gradients [1], `corridor` half-width [m]."""

    speed: float
    speed_min: float
    speed_max: float
    stall_speed: float
    alpha_stall: float
    bank_limit: float
    climb_gradient: float
    descent_gradient: float
    corridor: float


class Roll(_Table):
    """Bank loop: times [s], `rate_limit` [deg/s], aileron per rad/s and per rad."""

    time: float
    rate_limit: float
    aileron: float
    aileron_integral: float
    response_time: float


class Yaw(_Table):
    """Turn coordination: rudder per rad/s of yaw rate and per g s of lateral acceleration."""

    rudder: float
    rudder_integral: float


class Pitch(_Table):
    """Altitude loop: times [s], `climb_limit` [m/s], `turn_lift` [deg/g], elevator per rad, rad/s and rad s."""

    altitude_time: float
    climb_limit: float
    climb: float
    climb_integral: float
    turn_lift: float
    elevator: float
    elevator_rate: float
    elevator_integral: float


class Throttle(_Table):
    """Airspeed loop: throttle per m/s, per m, per g of load factor above 1, per unit of climb gradient."""

    gain: float
    integral: float
    turn_power: float
    climb_power: float


class OwnAutopilot(_Table):
    """The model's own autopilot, which ours replaces: its JSBSim `systems`, and the `outputs` its flight controls read."""

    systems: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()


class Aircraft(_Table):
    """One aircraft file. `root` is a JSBSim root folder beside the file; left out, JSBSim's own."""

    name: str
    model: str
    span: float
    envelope: Envelope
    roll: Roll
    yaw: Yaw
    pitch: Pitch
    throttle: Throttle
    own_autopilot: OwnAutopilot = OwnAutopilot()
    root: str = ""

    @property
    def bank_limit(self) -> float:
        """Largest bank commanded [rad]."""
        return math.radians(self.envelope.bank_limit)

    def limits(self) -> Limits:
        """The limits that guidance, feasibility and requirements use."""
        envelope = self.envelope
        return Limits(
            kind="fixed-wing",
            speed=envelope.speed,
            speed_min=envelope.speed_min,
            speed_max=envelope.speed_max,
            lateral_acceleration=STANDARD_GRAVITY * math.tan(self.bank_limit),
            response_time=self.roll.response_time,
            equivalent_length=2.0 * envelope.speed * self.roll.response_time,
            corridor=envelope.corridor,
            footprint=Disc(self.span / 2),
            climb_gradient=envelope.climb_gradient,
            descent_gradient=envelope.descent_gradient,
        )


def load_aircraft(name_or_file: str) -> Aircraft:
    """A built-in aircraft by name, or one from a TOML file; raises `InputError` naming file and key."""
    built_in = name_or_file in ALL_AIRCRAFT
    file = AIRCRAFT_FOLDER / f"{name_or_file}.toml" if built_in else Path(name_or_file)
    try:
        aircraft = msgspec.toml.decode(file.read_bytes(), type=Aircraft)
    except OSError as error:
        raise InputError(str(file), f"cannot be read ({error.strerror})") from error
    except msgspec.MsgspecError as error:
        raise InputError(str(file), str(error), "an aircraft file has the keys of sim/aircraft/c172x.toml") from error
    if aircraft.root:
        return msgspec.structs.replace(aircraft, root=str(file.parent / aircraft.root))
    return aircraft
