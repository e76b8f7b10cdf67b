"""A case as a user states it, in a campaign file or on the command line, made ready to be tried."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path as FilePath
from typing import Literal

import msgspec
import numpy as np

from planners import files
from planners.combine import merge, to_frame
from planners.corners import Rounded, fly_by
from planners.errors import InputError
from planners.map import Map
from planners.path import Path
from planners.scenario import Scenario, load_scenario
from planners.units import parse_speed, split_quantity
from sim.vehicle import Limits
from sim.vehicles import make_vehicle
from sim.wind import Wind, parse_wind
from tracking.feasibility import required_radius
from tracking.trial import Trial
from tracking.verdict import TRACKWORTHY, Expectation

FLY_BY_RESERVE = 1.2  # of the required radius: a turn at the limit leaves a controller nothing to steer with
ARC_DEVIATION = 1 / 300  # of the corridor, within which arcs are drawn as points


class Case(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One path under one vehicle. Quantities are as users write them; what is left out is the vehicle's default."""

    path: str
    vehicle: str
    name: str = ""
    controller: str = "lqr"
    speed: str | float | None = None
    altitude: str | float | None = None
    corridor: str | float | None = None
    wind: str | None = None
    scenario: str | None = None
    corners: Literal["as-drawn", "fly-by"] = "as-drawn"
    steering_hz: float = 20.0
    require: tuple[str, ...] = ()
    expect: Expectation = TRACKWORTHY
    seed: int = 0


def prepare(case: Case, folder: FilePath) -> Trial:
    """Read what `case` names, relative to `folder`, and put it together; its notes tell how, one line each.

    Raises `InputError` with the place of a fault.
    """
    limits = make_vehicle(case.vehicle, case.steering_hz).limits
    wind = parse_wind(case.wind) if case.wind else Wind()
    file = files.read(folder / case.path)
    name = FilePath(case.path).name
    notes = [f"{name}: {note}" for note in file.notes]
    if case.wind and limits.kind == "ground":
        notes.append(f"wind {case.wind}: not taken, it does not move a {case.vehicle}")
    speed, note = _speed(case, file.speed, limits)
    notes += note
    scenario = load_scenario(_scenario_name(case.scenario, folder)) if case.scenario else None
    path = _in_frame_of(scenario, file.path)
    altitude = _metres(case.altitude, "altitude")
    if altitude is not None and path.z is not None:
        path = replace(path, points=path.xy)
    corridor = _metres(case.corridor, "corridor") or limits.corridor
    if case.corners == "fly-by":
        path, rounded = _rounded(path, limits, speed, wind, corridor)
        notes += [f"{name}: {_corner_note(corner)}" for corner in rounded]
    return Trial(
        name=case.name or path.name,
        path=path,
        vehicle=case.vehicle,
        controller=case.controller,
        speed=speed,
        altitude=altitude,
        corridor=corridor,
        wind=wind,
        obstacles=_obstacles(path, file.fence, scenario),
        max_range=scenario.max_range if scenario else None,
        steering_hz=case.steering_hz,
        require=case.require,
        expect=case.expect,
        seed=case.seed,
        notes=tuple(notes),
    )


def _speed(case: Case, planned: float | None, limits: Limits) -> tuple[float, Sequence[str]]:
    """The user's speed, else the mission's where the vehicle can keep it, else the vehicle's."""
    if case.speed is not None:
        return parse_speed(case.speed), ()
    if planned is None:
        return limits.speed, ()
    name = FilePath(case.path).name
    if limits.speed_min <= planned <= limits.speed_max:
        return planned, (f"{name}: flown at the {planned:g} m/s that it sets",)
    note = f"{name}: sets {planned:g} m/s, which is not a speed of this vehicle; taken at {limits.speed:g} m/s"
    return limits.speed, (note,)


def _metres(text: str | float | None, place: str) -> float | None:
    if text is None:
        return None
    value, unit = split_quantity(str(text), place)
    if unit not in ("", "m", "km"):
        raise InputError(place, f"unknown unit {unit!r} in {text!r}", "give metres, or km")
    if place == "corridor" and value <= 0.0:
        raise InputError(place, f"{text} is not a half-width", "give one above 0")
    return value * (1000.0 if unit == "km" else 1.0)


def _rounded(path: Path, limits: Limits, speed: float, wind: Wind, corridor: float) -> tuple[Path, tuple[Rounded, ...]]:
    def radius(course: float, angle: float) -> float:
        required = FLY_BY_RESERVE * required_radius(limits, speed, wind, course, angle)
        if not np.isfinite(required):
            raise InputError("wind", f"{wind.speed:.4g} m/s of wind cannot be held at {speed:.4g} m/s")
        return required

    return fly_by(path, radius, ARC_DEVIATION * corridor)


def _corner_note(corner: Rounded) -> str:
    where = f"corner at {corner.s / 1000:.2f} km, {abs(np.degrees(corner.angle)):.0f} deg"
    if corner.radius == 0.0:
        return f"{where}: left as drawn, too sharp to fly by"
    short = f" (wanted {corner.wanted:.0f} m, the legs leave no more)" if corner.radius < 0.999 * corner.wanted else ""
    return f"{where}: rounded with a radius of {corner.radius:.0f} m{short}, cut by {corner.cut:.1f} m"


def _scenario_name(name: str, folder: FilePath) -> str:
    return str(folder / name) if FilePath(name).suffix else name


def _in_frame_of(scenario: Scenario | None, path: Path) -> Path:
    """`path` in the scenario's frame, so that its map need not be moved."""
    if scenario is None or path.frame is None:
        return path
    frame = scenario.map.frame
    if frame is None:
        raise InputError(
            scenario.name, "this scenario has no place on the planet, but the path has", "give it origin = [lat, lon]"
        )
    geographic = path.frame.to_geographic(path.xy)
    xy = frame.to_local(geographic[:, 0], geographic[:, 1])
    return replace(path, points=np.column_stack([xy, path.points[:, 2:]]), frame=frame)


def _obstacles(path: Path, fence: Map | None, scenario: Scenario | None) -> Map | None:
    """The mission's fence and the scenario's map as one, in the path's frame."""
    if fence is not None and path.frame is not None:
        fence = to_frame(fence, path.frame)
    if scenario is None or fence is None:
        return fence if scenario is None else scenario.map
    return merge(scenario.map, fence)
