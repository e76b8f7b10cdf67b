"""Scenarios as JSON, for planners in any language."""

from __future__ import annotations

import math

import msgspec

from planners.kernel import Floats
from planners.map import Circle, Raster
from planners.scenario import Scenario

SCHEMA_VERSION = 1  # of `ScenarioJson`; a key that is added does not change it, one that changes its meaning does
_UNITS = "lengths in metres, x east and y north of the map's south-west corner"
_DEGREE_DIGITS = 9  # decimals of an angle written, so that 45 degrees come back from radians as 45

Point = tuple[float, float]


class CircleJson(msgspec.Struct, frozen=True):
    """A circle [m]."""

    center: Point
    radius: float


class AreaJson(msgspec.Struct, frozen=True, omit_defaults=True):
    """A polygon [m], its first vertex not repeated, or a circle; the other is left out, as in a scenario file."""

    polygon: list[list[float]] | None = None
    circle: CircleJson | None = None


class RasterJson(msgspec.Struct, frozen=True):
    """Square cells of side `cell` [m]; `origin` [m] is the south-west corner of the first cell of the first row.

    `rows` go from south to north, the first is the southernmost; each goes from west to east, "1" where the
    cell is obstacle and "0" where it is free. Ground outside the raster is free.
    """

    cell: float
    origin: Point
    rows: list[str]


class ScenarioJson(msgspec.Struct, frozen=True, kw_only=True):
    """A scenario as outside planners see it: metres, and degrees where the name says so.

    `size` is width and height, `map_unit` how many metres a map unit of the scenario's file was; nothing here
    is in map units. `origin` is latitude and longitude [deg] of the south-west corner. With a "closed" `edge`
    the whole body must stay on the map, with an "open" one its reference point. A path must keep out of all
    `obstacles` and the "1" cells of `raster`, and within every one of `keep_in`. `picture` is the file of the aerial
    image that `raster` is the truth of, for planners that find the obstacles themselves. null is none.
    """

    schema: int = SCHEMA_VERSION
    name: str
    units: str = _UNITS
    size: Point
    map_unit: float
    origin: Point | None
    edge: str
    starts: list[list[float]]
    goals: list[list[float]]
    max_range: float | None
    max_turn_angle_deg: float | None
    obstacles: list[AreaJson]
    keep_in: list[AreaJson]
    raster: RasterJson | None
    picture: str | None


def scenario_to_json(scenario: Scenario) -> ScenarioJson:
    """The scenario for outside planners."""
    area, turn = scenario.map, scenario.max_turn_angle
    return ScenarioJson(
        name=scenario.name,
        size=scenario.size,
        map_unit=scenario.unit,
        origin=(area.frame.lat, area.frame.lon) if area.frame else None,
        edge=area.edge,
        starts=scenario.starts.tolist(),
        goals=scenario.goals.tolist(),
        max_range=scenario.max_range,
        max_turn_angle_deg=None if turn is None else round(math.degrees(turn), _DEGREE_DIGITS),
        obstacles=_areas(area.polygons, area.circles),
        keep_in=_areas(area.keep_in, area.keep_in_circles),
        raster=_raster(area.raster) if area.raster else None,
        picture=str(scenario.picture.absolute()) if scenario.picture else None,
    )


def scenario_bytes(scenario: Scenario) -> bytes:
    """The scenario as JSON in UTF-8: the same bytes for the same scenario, with null for what is not finite."""
    return msgspec.json.encode(scenario_to_json(scenario))


def _areas(polygons: tuple[Floats, ...], circles: tuple[Circle, ...]) -> list[AreaJson]:
    rings = [AreaJson(polygon=ring.tolist()) for ring in polygons]
    return rings + [AreaJson(circle=CircleJson((circle.x, circle.y), circle.radius)) for circle in circles]


def _raster(raster: Raster) -> RasterJson:
    rows = ["".join("1" if cell else "0" for cell in row) for row in raster.blocked.tolist()]
    return RasterJson(raster.cell, (raster.x, raster.y), rows)
