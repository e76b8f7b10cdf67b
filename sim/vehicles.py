"""The vehicles by name: the trucks, and every aircraft that has a file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from planners.errors import InputError
from sim.aircraft_file import ALL_AIRCRAFT, Aircraft, load_aircraft
from sim.planet import EARTH, Planet
from sim.vehicle import Vehicle

DEFAULT_STEERING_HZ = 20.0


def _truck(steering_hz: float) -> Vehicle:
    from sim.truck import Truck

    return Truck(steering_hz)


def _truck_dynamic(steering_hz: float) -> Vehicle:
    from sim.truck_dynamic import TruckDynamic

    return TruckDynamic(steering_hz)


ALL_TRUCKS: dict[str, Callable[[float], Vehicle]] = {"truck": _truck, "truck-dynamic": _truck_dynamic}
ALL_VEHICLES = (*ALL_AIRCRAFT, *ALL_TRUCKS)


def make_vehicle(
    vehicle: str | Aircraft, steering_hz: float = DEFAULT_STEERING_HZ, planet: Planet | None = None
) -> Vehicle:
    """The vehicle of that name, the aircraft of that TOML file, or the aircraft given; `InputError` for an unknown one.

    `steering_hz` [Hz] is how often guidance may steer a truck; `planet` is where to be, None at home. Simulators are
    imported here, when they are needed.
    """
    if isinstance(vehicle, str) and vehicle in ALL_TRUCKS:
        if planet not in (None, EARTH):
            raise InputError("planet", f"the {vehicle} drives on earth only", "leave the planet out")
        return ALL_TRUCKS[vehicle](steering_hz)
    if steering_hz != DEFAULT_STEERING_HZ:
        name = vehicle.name if isinstance(vehicle, Aircraft) else vehicle
        raise InputError("steering-hz", f"{name} has no steering", "leave it out")
    from sim.fixed_wing import FixedWing

    if isinstance(vehicle, Aircraft):
        return FixedWing(vehicle, planet)
    if vehicle in ALL_AIRCRAFT or Path(vehicle).suffix == ".toml":
        return FixedWing(load_aircraft(vehicle), planet)
    raise InputError(
        "vehicle",
        f"there is no vehicle {vehicle!r}",
        f"choose one of {', '.join(ALL_VEHICLES)}, or an aircraft's TOML file",
    )
