"""The table of a campaign's plans as data: a row a planner, and under it what others claim of it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, cast

import msgspec

from campaigns.claims import Claim
from campaigns.plan_statistics import PlannedBy, PlanStatistics, Spread
from campaigns.summary import CaseResult
from planners.astar.settings import planned_speed
from planners.planner import Planner
from planners.scenario import Scenario
from planners.units import STANDARD_GRAVITY
from reports.figures.needed_panel import beyond
from reports.files.json_result import Json
from reports.pages.plan_driven import driven
from reports.words.quantity import number, text
from reports.words.words import KMH

_DIGITS = 6  # significant digits in map units, as papers print them


def plan_row(one: PlannedBy, label: str, results: Sequence[CaseResult] = ()) -> dict[str, Json]:
    """A planner's row, every number already words; where it has two lines, median and worst, "" for what is missing.

    `results` are those of the campaign's cases, with what became of the plans.
    """
    told, unit = one.statistics, one.scenario.unit
    return {
        "name": label,
        "about": "" if label != called(one) else changed(one.planner),
        "found": f"{told.found} of {told.seeds}",
        "missing": ", ".join(f"{count} {name}" for name, count in told.missing.items()),
        "length": _lines(told.length, 1.0 / unit, _DIGITS),
        "ratio": _lines(told.length_ratio, 1.0, 4),
        "straight": [] if one.straight is None else _lines(told.length, 1.0 / one.straight, 4),
        "turn": [f"{number(angle)}°" for angle in (told.turn_5_deg, told.turn_1_deg) if angle is not None],
        "radius": _radius(one),
        "survivors": "" if told.survivors is None else f"{number(told.survivors)} of {told.population}",
        "converged": "" if told.converged is None else f"{number(told.converged)} of {told.iterations}",
        "longest": _lines(told.longest, 1.0 / unit, _DIGITS),
        "corner": "" if told.turn_max_deg is None else f"{number(told.turn_max_deg)}°",
        "over": _over(one),
        "stages": _stages(told, unit),
        "needs": _needs(one.needed, "" if one.planned_for else _at(one.driven_at)),
        "driven": driven(one, results),
        "claims": [_claim_row(claim, one.driven_at) for claim in one.claims],
    }


def called(one: PlannedBy) -> str:
    """The planner, and the speed that it plans for, which is that of a ground vehicle: "astar-arc, 45 km/h"."""
    speed = "" if one.planned_for is None else f", {text(one.planned_for * KMH, 'km/h')}"
    return f"{one.planner.name}{speed}"


def labels(plans: Sequence[PlannedBy]) -> list[str]:
    """What each of `plans` on one scenario is called: its planner and speed, with the settings where another is too."""
    names = [called(one) for one in plans]
    return [
        name if names.count(name) == 1 else f"{name}, {changed(one.planner) or 'as by default'}"
        for name, one in zip(names, plans, strict=True)
    ]


def changed(planner: Planner) -> str:
    """The settings that are not as by default: "clearance = 20, taut = false"; but for the speed to plan for."""
    own = cast(msgspec.Struct, planner)
    given, default = cast("tuple[dict[str, Any], ...]", (msgspec.to_builtins(own), msgspec.to_builtins(type(own)())))
    if planned_speed(planner) is not None:
        given.pop("speed")
    return ", ".join(f"{key} = {_value(value)}" for key, value in given.items() if value != default[key])


def yardsticks(plans: Sequence[PlannedBy]) -> str:
    """The exact shortest paths that plans of one scenario are held against: "1193 map units with 20 m of clearance"."""
    lengths: Mapping[float, float] = {
        one.planner.clearance: one.statistics.exact_length / one.scenario.unit
        for one in plans
        if one.statistics.exact_length is not None
    }
    return ", ".join(
        f"{number(length, _DIGITS)} map units with {text(clearance, 'm')} of clearance"
        for clearance, length in sorted(lengths.items())
    )


def is_fleet(scenario: Scenario) -> bool:
    """Whether it is for several vehicles, or has several targets."""
    return max(len(scenario.starts), len(scenario.goals)) > 1


def limits(scenario: Scenario) -> str:
    """What its paths are held to: "range limit 424 map units a path, turn limit 45° at a vertex"; "" for no limit."""
    parts = []
    if scenario.max_range is not None:
        parts.append(f"range limit {number(scenario.max_range / scenario.unit, _DIGITS)} map units a path")
    if scenario.max_turn_angle is not None:
        parts.append(f"turn limit {number(math.degrees(scenario.max_turn_angle))}° at a vertex")
    return ", ".join(parts)


def _over(one: PlannedBy) -> list[Json]:
    """Which of the scenario's limits its worst plan exceeds: "range", "turn"."""
    told, scenario, found = one.statistics, one.scenario, []
    if told.longest and scenario.max_range is not None and told.longest.worst > scenario.max_range:
        found.append("range")
    limit = scenario.max_turn_angle
    if told.turn_max_deg is not None and limit is not None and told.turn_max_deg > math.degrees(limit):
        found.append("turn")
    return [*found]


def _stages(told: PlanStatistics, unit: float) -> str:
    """ "Voronoi roadmap 741.2 → line of sight 702.3": the sum after each step, in map units; "" for one step."""
    if len(told.stages) < 2:
        return ""
    steps = " → ".join(f"{name} {number(length / unit, 4)}" for name, length in told.stages)
    return f"{steps} map units{', medians' if told.found > 1 else ''}"


def _claim_row(claim: Claim, speed: float | None) -> dict[str, Json]:
    return {
        "source": claim.source,
        "length": "" if claim.length is None else number(claim.length, _DIGITS),
        "straight": "" if not claim.length or not claim.straight else number(claim.length / claim.straight, 4),
        "longest": "" if claim.longest is None else number(claim.longest, _DIGITS),
        "turn": "" if claim.turn is None else f"{number(claim.turn)}°",
        "needs": _needs(claim.needed(speed), "" if claim.speed else _at(speed)),
        "survivors": "" if claim.survivors is None else "{} of {}".format(*claim.survivors),
        "converged": "" if claim.iterations is None else f"{claim.iterations}",
    }


def _needs(needed: float | None, at: str) -> dict[str, Json]:
    """A lateral acceleration [m/s^2] in g, `at` which speed, and whether it is over the limit; "" for none."""
    if needed is None:
        return {"g": "", "at": "", "over": False}
    share = needed / STANDARD_GRAVITY
    return {"g": number(share), "at": at, "over": beyond(share)}


def _at(speed: float | None) -> str:
    return "" if speed is None else f"at {text(speed * KMH, 'km/h')}"


def _lines(spread: Spread | None, factor: float, digits: int) -> list[Json]:
    """Median and worst, one line where they are the same, none where there is nothing."""
    values = [] if spread is None else [spread.median, spread.worst]
    return [*dict.fromkeys(number(factor * value, digits) for value in values)]


def _radius(one: PlannedBy) -> list[Json]:
    """In metres and in map units, or that there is none."""
    told = one.statistics
    if told.cornered:
        return ["corners", *([f"in {told.cornered}"] if told.cornered < told.found else [])]
    if told.smallest_radius is None:
        return ["straight"] if told.found else []
    return [text(told.smallest_radius, "m"), f"{number(told.smallest_radius / one.scenario.unit)} units"]


def _value(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else number(value) if isinstance(value, float) else str(value)
