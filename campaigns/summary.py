"""`summary.json`: what a campaign found, the same bytes however it was run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.plan_statistics import PlannedBy
from campaigns.search_summary import searches_json
from campaigns.searches import SearchResult
from campaigns.statistics import Band, CaseStatistics, Summary, statistics
from campaigns.store import Row, Store
from planners.files.text import write_text
from planners.kernel import Floats
from planners.units import degrees
from tracking.metric import SCHEMA_VERSION
from tracking.verdict import EITHER, NOT_TRACKWORTHY, TRACKWORTHY

ERROR = "error"
PLACES = 6  # decimals of a band [m]
Json = dict[str, "Json"] | list["Json"] | str | float | int | bool | None


@dataclass(frozen=True, slots=True)
class CaseResult:
    """A case with its statistics; `units` gives unit and direction of each metric."""

    number: int
    case: Case
    statistics: CaseStatistics
    units: dict[str, tuple[str, str]]

    @property
    def worst(self) -> Row | None:
        """The trial that missed by most, or came closest to it; None where none was flown."""
        return self.statistics.worst

    @property
    def verdict(self) -> str:
        """ "trackworthy" if enough of its trials are, "error" if one of them could not be tried."""
        if self.statistics.errors:
            return ERROR
        return TRACKWORTHY if self.statistics.share >= self.case.pass_share else NOT_TRACKWORTHY

    @property
    def passed(self) -> bool:
        """Whether the verdict is the expected one; an error never is."""
        return self.verdict == self.case.expect or (self.case.expect == EITHER and self.verdict != ERROR)


def results_of(cases: Sequence[Case], store: Store) -> list[CaseResult]:
    """Every case with what is stored of it; `number` counts from 1."""
    units = store.units()
    better = {name: direction for name, (_, direction) in units.items()}
    results = []
    for number, case in enumerate(cases, start=1):
        found = statistics(store.rows(case.name, case.trials), better)
        results.append(CaseResult(number, case, found, units))
    return results


def write_summary(
    campaign: Campaign,
    results: Sequence[CaseResult],
    file: Path,
    searches: Sequence[SearchResult] = (),
    plans: Sequence[PlannedBy] = (),
) -> None:
    """Write `summary.json`."""
    about: Json = {
        "name": campaign.name,
        "title": campaign.title,
        "seed": campaign.seed,
        "schema": SCHEMA_VERSION,
        "trials": sum(result.case.trials for result in results),
        "errors": sum(result.statistics.errors for result in results),
        "passed": sum(result.passed for result in results),
        "cases": [_case(result) for result in results],
        **searches_json(searches),
        "plans": [_plans(one) for one in plans],
    }
    text = msgspec.json.format(msgspec.json.encode(about), indent=2).decode()
    write_text(file, f"{text}\n")


def _case(result: CaseResult) -> Json:
    case, found = result.case, result.statistics
    low, high = found.interval
    return {
        "name": case.name,
        "verdict": result.verdict,
        "expected": case.expect,
        "passed": result.passed,
        "vehicle": case.vehicle,
        "controller": case.controller,
        "speed": case.speed,
        "corridor": case.corridor,
        "trials": case.trials,
        "errors": found.errors,
        "first_error": found.first_error,
        "no_path": {"trials": found.no_path, "reason": found.no_path_reason} if found.no_path else None,
        "trackworthy": found.trackworthy,
        "share": found.share,
        "share_interval": [low, high],
        "pass_share": case.pass_share,
        "worst_trial": _worst(result),
        "bias": found.bias,
        "spread": found.spread,
        "metrics": {name: _metric(one, *result.units[name]) for name, one in found.metrics.items()},
        "band": _band(found.band),
    }


def _plans(one: PlannedBy) -> Json:
    return {
        "planner": one.planner.name,
        "settings": msgspec.to_builtins(one.planner),
        "scenario": one.scenario.name,
        "map_unit": one.scenario.unit,
        "clearance": one.planner.clearance,
        "planned_for": one.planned_for,
        "straight_length": one.straight,
        "driven_at": one.driven_at,
        "lateral_acceleration_needed": one.needed,
        **msgspec.to_builtins(one.statistics),
        "claims": [
            {**msgspec.to_builtins(claim), "lateral_acceleration_needed": claim.needed(one.driven_at)}
            for claim in one.claims
        ],
    }


def _worst(result: CaseResult) -> Json:
    worst = result.worst
    if worst is None:
        return None
    return {
        "trial": worst.trial,
        "seed": worst.seed,
        "trackworthy": worst.trackworthy,
        "decided_by": worst.decided_by,
        "ended": worst.ended,
    }


def _metric(one: Summary, si_unit: str, better: str) -> Json:
    factor, unit = degrees(1.0, si_unit)
    return {
        "unit": unit,
        "better": better,
        "median": factor * one.median,
        "p95": factor * one.p95,
        "worst": factor * one.worst,
        "worst_trial": one.worst_trial,
        "trials": one.count,
    }


def _band(band: Band | None) -> Json:
    if band is None:
        return None
    return {
        "bias": _rounded(band.bias),
        "spread": _rounded(band.spread),
        "median": _rounded(band.median),
        "low": _rounded(band.low),
        "high": _rounded(band.high),
        "p5": _rounded(band.p5),
        "p95": _rounded(band.p95),
    }


def _rounded(values: Floats) -> Json:
    return [round(float(value), PLACES) for value in values]
