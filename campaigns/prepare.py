"""Makes a case ready to be tried: quantities in SI units, corners rounded, obstacles in the path's frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce
from pathlib import Path as FilePath
from typing import Any

import msgspec

from campaigns.case import Case
from campaigns.conditions import ConditionKeys, WindKeys, draw
from campaigns.fly_by import fly_by_corners
from campaigns.inputs import Inputs
from campaigns.limits import DEFAULT_LIMITS, NO_DIRECTION
from planners.combine import merge, to_frame
from planners.errors import InputError
from planners.in_frame import in_frame_of, in_frame_with, on_ellipsoid
from planners.map import Map
from planners.outside import OutsidePlanner
from planners.path import Path
from planners.scenario import Scenario
from planners.typed_toml import suggestion
from planners.units import parse_speed, split_quantity
from sim.planet import EARTH
from sim.vehicle import Limits
from tracking.controllers import make_controller
from tracking.requirements import split_requirement
from tracking.trial import Trial


def settled(case: Case, inputs: Inputs) -> tuple[Case, tuple[str, ...]]:
    """`case` with every quantity in SI units and every default written out, and notes on where they come from."""
    make_controller(case.controller)
    check_metric_names(case.require)
    if case.conditions.turbulence and inputs.planet != EARTH:
        what = f"its severities are those of the Earth, not of {inputs.planet.name}"
        raise InputError("conditions.turbulence", what, "give dryden = { sigma = ..., length = ... }")
    speed, notes = _speed(case, inputs)
    altitude = _metres(case.altitude, "altitude")
    corridor = _metres(case.corridor, "corridor") or inputs.limits.corridor
    name = case.name or FilePath(case.path or case.scenario or "").stem + (
        f" and {len(case.others)} more" if case.others else ""
    )
    case = msgspec.structs.replace(
        case, name=name, set=_settings(inputs), speed=speed, altitude=altitude, corridor=corridor
    )
    return case, (*notes, *_idle(case, inputs.limits))


def assemble(case: Case, inputs: Inputs, planned: tuple[Path, ...] = ()) -> Trial:
    """The trial of `case`, with its path from `inputs` or those `planned`; its notes tell how, one line each.

    Its conditions are those of a trial with seed 0. Raises `InputError` with the place of a fault.
    """
    case, remarks = settled(case, inputs)
    given = tuple(file.path for file in inputs.files) or planned
    if not given:
        raise InputError(case.name, "it has no path yet")
    sources = _sources(case, inputs, len(given))
    notes = [f"{source}: {note}" for source, file in zip(sources, inputs.files, strict=False) for note in file.notes]
    notes += remarks
    flown: list[Path] = []
    for source, one in zip(sources, given, strict=True):
        path, corners = _to_fly(one, case, inputs, flown[0] if flown else None)
        notes += [f"{source}: {corner}" for corner in corners]
        flown.append(path)
    path, *others = flown
    notes += _alone(case) if not others else []
    trial = Trial(
        name=case.name,
        path=path,
        vehicle=inputs.vehicle,
        planet=inputs.planet,
        controller=case.controller,
        speed=_number(case.speed),
        altitude=None if case.altitude is None else _number(case.altitude),
        corridor=_number(case.corridor),
        obstacles=_obstacles(path, [file.fence for file in inputs.files], inputs.scenario),
        max_range=inputs.scenario.max_range if inputs.scenario else None,
        steering_hz=case.steering_hz,
        require=case.require,
        expect=case.expect,
        notes=tuple(notes),
        others=tuple(others),
        departures=case.departures,
        separation=_metres(case.separation, "separation"),
    )
    return seeded(trial, case.conditions, 0)


def _alone(case: Case) -> list[str]:
    """A note where something is asked of a fleet, and there is none."""
    asked = case.separation is not None or case.departures != "together"
    return [f"{case.name}: separation, departures: not taken, it is one vehicle"] if asked else []


def _sources(case: Case, inputs: Inputs, count: int) -> list[str]:
    """What each of `count` paths is called in notes: by its file, or if it is planned, by who is to follow it."""
    if inputs.files:
        return [FilePath(name).name for name in (case.path, *case.others)]
    kind = "aircraft" if inputs.limits.kind == "fixed-wing" else "vehicle"
    return [f"{kind} {number}" for number in range(1, count + 1)] if count > 1 else [case.name]


def _to_fly(path: Path, case: Case, inputs: Inputs, first: Path | None) -> tuple[Path, list[str]]:
    """A path of the settled case as it is to be flown, in the frame of the `first`, and what became of its corners."""
    if inputs.scenario is not None:
        path = in_frame_of(inputs.scenario, path)
    path = on_ellipsoid(path, inputs.planet.a, inputs.planet.b)
    if first is not None:
        path = in_frame_with(first, path)
    if case.altitude is not None and path.z is not None:
        path = replace(path, points=path.xy)
    if case.corners != "fly-by":
        return path, []
    return fly_by_corners(path, inputs.limits, _number(case.speed), case.conditions, _number(case.corridor))


def check_metric_names(requirements: Sequence[str]) -> None:
    """Raises `InputError` for a requirement that is none, or on a metric that no vehicle has."""
    known = (*DEFAULT_LIMITS, *NO_DIRECTION)
    for text in requirements:
        name, _, _ = split_requirement(text)
        if name not in known:
            raise InputError("require", f"there is no metric {name!r}", suggestion(name, known))


def seeded(trial: Trial, conditions: ConditionKeys, seed: int) -> Trial:
    """`trial` in the conditions drawn with `seed`, which also decides all else that is random in it."""
    one = draw(conditions, seed)
    return replace(trial, seed=seed, conditions=one.conditions, offset=one.offset, sensors=one.sensors)


def _settings(inputs: Inputs) -> dict[str, Any]:
    """Those of a planner of ours, every default written out."""
    if inputs.planner is None or isinstance(inputs.planner, OutsidePlanner):
        return {}
    settings = msgspec.to_builtins(inputs.planner)
    return {key: value for key, value in settings.items() if value is not None}


def _number(value: str | float | None) -> float:
    """A quantity of a settled case."""
    return float(value if value is not None else "nan")


def _speed(case: Case, inputs: Inputs) -> tuple[float, Sequence[str]]:
    """The user's speed, else the mission's where the vehicle can keep it, else the vehicle's."""
    limits = inputs.limits
    if case.speed is not None:
        return parse_speed(case.speed), ()
    planned = inputs.files[0].speed if inputs.files else None
    if planned is None:
        return limits.speed, ()
    name = FilePath(case.path).name
    if limits.speed_min <= planned <= limits.speed_max:
        return planned, (f"{name}: flown at the {planned:g} m/s that it sets",)
    note = f"{name}: sets {planned:g} m/s, which is not a speed of this vehicle; taken at {limits.speed:g} m/s"
    return limits.speed, (note,)


def _idle(case: Case, limits: Limits) -> list[str]:
    """A note for each condition that does not act on this kind of vehicle."""
    keys = case.conditions
    if limits.kind != "ground":
        given = {"friction": keys.friction is not None}
        why = f"a {case.vehicle} has no tyres on the road"
    else:
        given = {
            "wind": keys.wind != WindKeys(0.0),
            "turbulence": keys.turbulence != 0.0,
            "gust": keys.gust is not None,
            "dryden": keys.dryden is not None,
            "mass": keys.mass != 1.0,
        }
        why = f"it does not move a {case.vehicle}"
    return [f"{case.name}: {name}: not taken, {why}" for name, there in given.items() if there]


def _metres(text: str | float | None, place: str) -> float | None:
    if text is None:
        return None
    value, unit = split_quantity(str(text), place)
    if unit not in ("", "m", "km"):
        raise InputError(place, f"unknown unit {unit!r} in {text!r}", "give metres, or km")
    if place == "corridor" and value <= 0.0:
        raise InputError(place, f"{text} is not a half-width", "give one above 0")
    if place == "separation" and value < 0.0:
        raise InputError(place, f"{text} is no distance to keep", "give 0 or more")
    return value * (1000.0 if unit == "km" else 1.0)


def _obstacles(path: Path, fences: Sequence[Map | None], scenario: Scenario | None) -> Map | None:
    """The missions' fences and the scenario's map as one, in the path's frame."""
    maps = [scenario.map] if scenario is not None else []
    for fence in fences:
        if fence is not None:
            maps.append(fence if path.frame is None else to_frame(fence, path.frame))
    return reduce(merge, maps) if maps else None
