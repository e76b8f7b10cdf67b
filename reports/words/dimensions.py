"""What tells the cases of a campaign apart, in words: planner or path, scenario, conditions, vehicle, controller."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from campaigns.case import Case
from campaigns.conditions import CALM
from campaigns.summary import CaseResult
from planners.outside import OutsidePlanner
from planners.scenario import BUILT_IN_SCENARIOS, load_scenario, stem_of
from planners.units import parse_speed
from reports.words.condition_words import condition_words
from reports.words.fleet_words import GROUND
from reports.words.quantity import number, text
from reports.words.words import speed_text
from sim.vehicles import ALL_TRUCKS
from tracking.outcome import Outcome

PATH, SCENARIO, CONDITIONS, VEHICLE, SPEED, CONTROLLER = (
    "path", "scenario", "conditions", "vehicle", "speed", "controller",
)  # fmt: skip
DIMENSIONS = (PATH, SCENARIO, CONDITIONS, VEHICLE, SPEED, CONTROLLER)
ROWS, COLUMNS = DIMENSIONS[:3], DIMENSIONS[3:]


def dimensions(results: Sequence[CaseResult], outcomes: Mapping[str, Outcome]) -> list[dict[str, str]]:
    """For each case what it is in every one of `DIMENSIONS`; "" where it has none, as a path file without a map."""
    cases = [result.case for result in results]
    paths, found, kinds = _paths(cases), scales(cases), _kinds(cases, outcomes)
    return [
        {
            PATH: path,
            SCENARIO: scenario_words(case, found),
            CONDITIONS: conditions_met(case, kinds.get(case.vehicle, "")),
            VEHICLE: Path(case.vehicle).stem,
            SPEED: _speed(case, kinds.get(case.vehicle, "")),
            CONTROLLER: case.controller,
        }
        for case, path in zip(cases, paths, strict=True)
    ]


def conditions_met(case: Case, kind: str) -> str:
    """The conditions of a case with a vehicle of that `kind`; no air moves one on the ground."""
    keys, air = case.conditions, "no wind"
    if kind == GROUND:
        keys = msgspec.structs.replace(keys, wind=CALM.wind, gust=None, dryden=None, turbulence=CALM.turbulence)
        air = ""
    return ", ".join(condition_words(keys)) or air


def scenario_words(case: Case, scales_of: Mapping[str, int]) -> str:
    """The scenario of a case, with the scale where `scales_of` has several of it; "" for none."""
    if not case.scenario:
        return ""
    name = stem_of(case.scenario)
    if scales_of.get(name, 1) == 1:
        return name
    own = load_scenario(case.scenario).unit if case.scenario in BUILT_IN_SCENARIOS else None
    unit = case.unit or own
    return f"{name} at {text(unit, 'm')} a unit" if unit else f"{name} at its own scale"


def scales(cases: Sequence[Case]) -> dict[str, int]:
    """At how many scales each scenario is run."""
    found: dict[str, set[float | None]] = {}
    for case in cases:
        if case.scenario:
            found.setdefault(stem_of(case.scenario), set()).add(case.unit)
    return {name: len(units) for name, units in found.items()}


def _paths(cases: Sequence[Case]) -> list[str]:
    """The planner of each case, with those of its settings that differ between cases, or the file of its path."""
    files = {case.path for case in cases if case.path}
    stems = [Path(file).name for file in files]
    settings = {name: _differing([case for case in cases if case.planner == name]) for name in _planners(cases)}
    told = []
    for case in cases:
        if isinstance(case.planner, OutsidePlanner):
            told.append(case.planner.label)
        elif case.planner:
            own = [f"{key} = {_value(case.set.get(key))}" for key in settings[case.planner]]
            told.append(", ".join([case.planner, *own]))
        else:
            name = Path(case.path).name
            others = f" and {len(case.others)} more" if case.others else ""
            told.append((name if stems.count(name) == 1 else case.path) + others)
    return told


def _planners(cases: Sequence[Case]) -> set[str]:
    return {case.planner for case in cases if isinstance(case.planner, str)}


def _differing(cases: Sequence[Case]) -> list[str]:
    """The settings that are not the same in all of `cases` on one scenario; but for a speed, which stands by itself."""
    keys = dict.fromkeys(key for case in cases for key in case.set if key != SPEED)
    groups: dict[object, list[Case]] = {}
    for case in cases:
        groups.setdefault((case.scenario, case.unit), []).append(case)
    return [
        key for key in keys
        if any(len({repr(case.set.get(key)) for case in group}) > 1 for group in groups.values())
    ]  # fmt: skip


def _speed(case: Case, kind: str) -> str:
    speed = parse_speed(case.speed) if isinstance(case.speed, str) else case.speed
    return "the vehicle's own" if speed is None else speed_text(speed, kind)


def _kinds(cases: Sequence[Case], outcomes: Mapping[str, Outcome]) -> dict[str, str]:
    """Which kind each vehicle is, by its outcomes; the truck needs none."""
    return dict.fromkeys(ALL_TRUCKS, GROUND) | {
        case.vehicle: outcomes[case.name].limits.kind for case in cases if case.name in outcomes
    }


def _value(value: Any) -> str:
    return "by default" if value is None else number(value) if isinstance(value, float) else str(value)
