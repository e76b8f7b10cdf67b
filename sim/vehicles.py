"""The vehicles by name: the truck, and every aircraft that has a file."""

from __future__ import annotations

from pathlib import Path

from planners.errors import InputError
from sim.vehicle import Vehicle

ALL_VEHICLES = ("c172x", "truck")


DEFAULT_STEERING_HZ = 20.0


def make_vehicle(name: str, steering_hz: float = DEFAULT_STEERING_HZ) -> Vehicle:
    """The vehicle of that name, or the aircraft of that TOML file; raises `InputError` for an unknown one.

    `steering_hz` [Hz] is how often guidance may steer a truck. Simulators are imported here, when they are needed.
    """
    if name == "truck":
        from sim.truck import Truck

        return Truck(steering_hz)
    if steering_hz != DEFAULT_STEERING_HZ:
        raise InputError("steering-hz", f"{name} has no steering", "leave it out")
    from sim.aircraft_file import ALL_AIRCRAFT, load_aircraft
    from sim.fixed_wing import FixedWing

    if name in ALL_AIRCRAFT or Path(name).suffix == ".toml":
        return FixedWing(load_aircraft(name))
    raise InputError(
        "vehicle",
        f"there is no vehicle {name!r}",
        f"choose one of {', '.join(ALL_VEHICLES)}, or an aircraft's TOML file",
    )
