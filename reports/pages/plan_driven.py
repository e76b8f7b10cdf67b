"""What became of a planner's plans when they were flown or driven."""

from __future__ import annotations

from collections.abc import Sequence

from campaigns.plan_statistics import PlannedBy
from campaigns.statistics import CaseStatistics
from campaigns.summary import CaseResult
from reports.files.json_result import Json
from reports.words.names import spoken


def driven(one: PlannedBy, results: Sequence[CaseResult]) -> list[Json]:
    """How many trials of all cases with these plans are trackworthy, and what decides the worst of the others.

    One for each vehicle: its name, "" where there is but one; `share`, "9 of 18"; and `all`, whether none failed.
    """
    tried = [result for result in results if result.case.name in one.cases and result.statistics.tried]
    vehicles = list(dict.fromkeys(result.case.vehicle for result in tried))
    return [
        _by(vehicle if len(vehicles) > 1 else "", [own.statistics for own in tried if own.case.vehicle == vehicle])
        for vehicle in vehicles
    ]


def _by(vehicle: str, found: Sequence[CaseStatistics]) -> Json:
    tried, good = sum(case.tried for case in found), sum(case.trackworthy for case in found)
    why = _why(found) if good < tried else ""
    return {"vehicle": vehicle, "share": f"{good} of {tried}", "why": why, "all": good == tried}


def _why(found: Sequence[CaseStatistics]) -> str:
    """The metric that decides the worst trial, or that there was no path to follow."""
    missed = [case.worst for case in found if case.worst is not None and not case.worst.trackworthy]
    return spoken(min(missed, key=lambda worst: worst.score).decided_by) if missed else "no path"
