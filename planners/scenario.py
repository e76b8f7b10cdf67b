"""Scenarios: a map with starts, goals, scale and limits, from a TOML file or built in."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path as FilePath

import numpy as np

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.frame import Frame
from planners.kernel import Floats
from planners.map import Circle, Map, Raster
from planners.movingai import Problem, is_movingai, read_problem
from planners.scenario_keys import Point, ScenarioKeys, map_from_keys
from planners.scenario_picture import raster_of, size_of
from planners.typed_toml import read_toml, suggestion

BUILT_IN_SCENARIOS = (
    "mars-gap",
    "mars-hazards-15",
    "mars-hazards-25",
    "nofly-1000x660",
    "slalom-1000x600",
    "target-vehicle-640m",
    "target-vehicle-71m",
)

_FOLDER = FilePath(__file__).parent / "scenarios"


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Scenario:
    """A planning problem in metres: from `starts` (S, 2) to `goals` (G, 2) over `map`.

    `size` is the width and height of the map [m], whose south-west corner is the origin, `unit` [m] how long
    a map unit of the file is. `max_range` [m] limits the length of a path, `max_turn_angle` [rad] the turn at
    its vertices; None where there is no limit. `planet` is where the map lies, "" for anywhere. `picture` is
    the aerial image of a map whose truth is known, for planners that find the obstacles in it; `files` all
    that was read, the scenario's own first, and `problem` which one that is of the several in it.
    """

    name: str
    map: Map
    starts: Floats
    goals: Floats
    size: tuple[float, float]
    unit: float = 1.0
    max_range: float | None = None
    max_turn_angle: float | None = None
    planet: str = ""
    picture: FilePath | None = None
    files: tuple[FilePath, ...] = ()
    problem: int | None = None


def load_scenario(name_or_file: str | FilePath) -> Scenario:
    """The built-in scenario of that name, that of a TOML file, or movingai.com's problem `FILE.scen:NUMBER`.

    Raises `InputError` naming file, key and remedy: a file or picture that is missing, a key that is unknown
    or of the wrong kind, an area that is none, a start or goal in an obstacle or off the map.
    """
    if is_movingai(str(name_or_file)):
        return _of_problem(read_problem(str(name_or_file)))
    file = find_scenario(name_or_file)
    keys = read_toml(file, ScenarioKeys)
    size = size_of(keys, file)
    area = map_from_keys(keys, size, raster_of(keys, size, file), file)
    starts = _places(keys, size, file, area, "start", keys.start, "vehicles", keys.vehicles)
    goals = _places(keys, size, file, area, "goal", keys.goal, "targets", keys.targets)
    pictures = [file.parent / name for name in (keys.image, keys.truth) if name is not None]
    picture = pictures[0] if len(pictures) == 2 and keys.segment is None else None
    if picture is not None and not picture.is_file():
        raise InputError(f"{file}: image", f"there is no picture {picture}", "put it beside the scenario file")
    return Scenario(
        name=keys.name,
        map=area,
        starts=starts,
        goals=goals,
        size=(size[0] * keys.unit, size[1] * keys.unit),
        unit=keys.unit,
        max_range=None if keys.max_range is None else keys.max_range * keys.unit,
        max_turn_angle=None if keys.max_turn_angle is None else math.radians(keys.max_turn_angle),
        planet=keys.planet,
        picture=picture,
        files=(file, *pictures),
    )


def stem_of(name_or_file: str) -> str:
    """What a scenario is called before it is read: as its file, with the number of a problem."""
    file, _, number = name_or_file.partition(".scen:")
    return f"{FilePath(file).stem} {number}" if number else FilePath(name_or_file).stem


def _of_problem(problem: Problem) -> Scenario:
    """The scenario of a problem, in map units of 1 m; its start and goal are known to be free."""
    rows, columns = problem.blocked.shape
    starts, goals = np.array([problem.start]), np.array([problem.goal])
    for places in (starts, goals):
        places.setflags(write=False)
    return Scenario(
        name=problem.name,
        map=Map(raster=Raster(problem.blocked, 1.0), bounds=(0.0, 0.0, float(columns), float(rows))),
        starts=starts,
        goals=goals,
        size=(float(columns), float(rows)),
        files=problem.files,
        problem=problem.number,
    )


def find_scenario(name_or_file: str | FilePath) -> FilePath:
    """The file of a built-in scenario, or the file itself; raises `InputError` for a name that is neither."""
    name = str(name_or_file)
    if name in BUILT_IN_SCENARIOS:
        return _FOLDER / f"{name}.toml"
    file = FilePath(name)
    if not file.suffix and not file.exists():
        raise InputError(name, "there is no such scenario", suggestion(name, BUILT_IN_SCENARIOS))
    return file


def _places(
    keys: ScenarioKeys, size: Point, file: FilePath, area: Map,
    one: str, single: Point | None, many: str, several: list[Point] | None,
) -> Floats:  # fmt: skip
    """The places (N, 2) [m] given by one of two keys, each on free ground."""
    if single is not None and several is not None:
        raise InputError(f"{file}: {one}", f"{many} is given too", f"leave {one} or {many} out")
    if single is None and not several:
        raise InputError(str(file), f"{one} is missing", f"add {one} = [x, y] or {many} = [[x, y], ...]")
    given = [single] if single is not None else several or []
    points = np.array(given, dtype=float) * keys.unit
    clear = clearance(area, np.column_stack([points, np.zeros(len(points))]), Disc(0.0))
    for i, (place, room) in enumerate(zip(given, clear, strict=True)):
        key = one if single is not None else f"{many}[{i}]"
        on_map = all(0.0 <= value <= side for value, side in zip(place, size, strict=True))
        if not on_map:
            raise InputError(f"{file}: {key}", f"{list(place)} is off the map", f"keep it within {list(size)}")
        if room < 0.0:
            what = f"{list(place)} is {-room / keys.unit:.3g} map units deep in an obstacle or a forbidden area"
            raise InputError(f"{file}: {key}", what, "move it to free ground")
    points.setflags(write=False)
    return points


def scaled(scenario: Scenario, unit: float) -> Scenario:
    """The same scenario with map units of `unit` [m]; its picture stays as it is."""
    factor, area = unit / scenario.unit, scenario.map
    left, south, right, north = area.bounds or (0.0, 0.0, 0.0, 0.0)
    raster = area.raster
    resized = replace(
        area,
        polygons=tuple(ring * factor for ring in area.polygons),
        circles=tuple(_scaled(circle, factor) for circle in area.circles),
        keep_in=tuple(ring * factor for ring in area.keep_in),
        keep_in_circles=tuple(_scaled(circle, factor) for circle in area.keep_in_circles),
        bounds=area.bounds and (left * factor, south * factor, right * factor, north * factor),
        raster=raster and Raster(raster.blocked, raster.cell * factor, raster.x * factor, raster.y * factor),
    )
    return replace(
        scenario,
        map=resized,
        starts=scenario.starts * factor,
        goals=scenario.goals * factor,
        size=(scenario.size[0] * factor, scenario.size[1] * factor),
        unit=unit,
        max_range=None if scenario.max_range is None else scenario.max_range * factor,
    )


def on_planet(scenario: Scenario, a: float, b: float) -> Scenario:
    """The same scenario on the ellipsoid with semi-axes `a`, `b` [m]: its map keeps its metres, and its origin."""
    frame = scenario.map.frame
    if frame is None or (frame.a, frame.b) == (a, b):
        return scenario
    return replace(scenario, map=replace(scenario.map, frame=Frame(frame.lat, frame.lon, a, b)))


def _scaled(circle: Circle, factor: float) -> Circle:
    return Circle(circle.x * factor, circle.y * factor, circle.radius * factor)
