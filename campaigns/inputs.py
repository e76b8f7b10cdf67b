"""What a case names, read once: its path file or its planner, its scenario, its vehicle."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path as FilePath

from campaigns.case import Case
from planners import files
from planners.all_planners import make_planner
from planners.astar.settings import for_speed
from planners.errors import InputError
from planners.files import PathFile
from planners.outside import OutsidePlanner
from planners.planner import Planner
from planners.scenario import BUILT_IN_SCENARIOS, Scenario, load_scenario, on_planet, scaled
from planners.units import parse_speed
from sim.aircraft_file import ALL_AIRCRAFT, Aircraft, load_aircraft
from sim.planet import Planet, planet_of
from sim.vehicle import Limits
from sim.vehicles import make_vehicle


@dataclass(frozen=True, slots=True)
class Inputs:
    """`files` of a path each, none where a `planner` gives them; `vehicle` is its name, or all that its file says.

    `planet` is where it flies, and where the scenario's map lies.
    """

    files: tuple[PathFile, ...]
    planner: Planner | OutsidePlanner | None
    scenario: Scenario | None
    vehicle: str | Aircraft
    limits: Limits
    planet: Planet


@dataclass(slots=True)
class Reader:
    """Reads what cases name relative to `folder`, each file once."""

    folder: FilePath
    _files: dict[str, PathFile] = field(default_factory=dict)
    _scenarios: dict[str, Scenario] = field(default_factory=dict)
    _vehicles: dict[tuple[str, float, str], tuple[str | Aircraft, Limits, Planet]] = field(default_factory=dict)

    def read(self, case: Case) -> Inputs:
        """The inputs of `case`; raises `InputError` with the place of a fault."""
        if bool(case.path) == (case.planner is not None):
            raise InputError(case.name or "case", "a path or a planner is needed, one of them", "give path = ...")
        if case.planner is not None and case.scenario is None:
            raise InputError(case.name, "a planner needs a scenario", "add scenario = ...")
        if case.replan and case.planner is None:
            raise InputError("replan", "a path from a file is not planned", "name a planner, or leave replan out")
        if case.others and not case.path:
            raise InputError("others", "they are paths beside one", "give that as path = ...")
        paths = (case.path, *case.others) if case.path else ()
        for path in paths:
            if path not in self._files:
                self._files[path] = files.read(self.folder / path)
        if case.unit is not None and not case.scenario:
            raise InputError("unit", "it has no scenario whose map units they are", "add scenario = ...")
        given = self._scenario(case.scenario) if case.scenario else None
        named = case.planet or (given.planet if given is not None else "")
        vehicle, limits, planet = self._vehicle(case.vehicle, case.steering_hz, named)
        scenario = None if given is None else self._placed(given, case.unit, planet)
        read = tuple(self._files[path] for path in paths)
        return Inputs(read, _planner(case, limits), scenario, vehicle, limits, planet)

    def _scenario(self, name: str) -> Scenario:
        if name not in self._scenarios:
            place = name if name in BUILT_IN_SCENARIOS or not FilePath(name).suffix else self.folder / name
            self._scenarios[name] = load_scenario(place)
        return self._scenarios[name]

    def _placed(self, scenario: Scenario, unit: float | None, planet: Planet) -> Scenario:
        """The scenario at that scale and on that planet: one object for each, by which plans are told apart."""
        key = f"{scenario.files[0]} {scenario.problem} {unit!r} {planet.name}"
        if key not in self._scenarios:
            if unit is not None:
                scenario = scaled(scenario, unit)
            self._scenarios[key] = on_planet(scenario, planet.a, planet.b)
        return self._scenarios[key]

    def _vehicle(self, name: str, steering_hz: float, planet: str) -> tuple[str | Aircraft, Limits, Planet]:
        """The vehicle on the planet of that name, "" for its own, its limits there, and where that is."""
        if (name, steering_hz, planet) not in self._vehicles:
            own_file = name not in ALL_AIRCRAFT and FilePath(name).suffix == ".toml"
            vehicle = load_aircraft(str(self.folder / name)) if own_file else name
            made = make_vehicle(vehicle, steering_hz, planet_of(planet) if planet else None)
            self._vehicles[name, steering_hz, planet] = (vehicle, made.limits, made.planet)
        return self._vehicles[name, steering_hz, planet]


def _planner(case: Case, limits: Limits) -> Planner | OutsidePlanner | None:
    """The case's; one that plans for a speed, and is not set to one, plans for the case's or the vehicle's own."""
    if isinstance(case.planner, str):
        speed = limits.speed if case.speed is None else parse_speed(case.speed)
        return for_speed(make_planner(case.planner, case.set), speed)
    if case.set:
        what = "settings are those of a planner of ours"
        raise InputError("set", what, 'name it, as planner = "exact", or leave set out')
    return case.planner
