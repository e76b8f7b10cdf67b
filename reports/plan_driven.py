"""What became of a planner's plans when they were flown or driven."""

from __future__ import annotations

from collections.abc import Sequence

from campaigns.plan_statistics import PlannedBy
from campaigns.statistics import CaseStatistics
from campaigns.summary import CaseResult
from reports.json_result import Json
from reports.names import spoken


def driven(one: PlannedBy, results: Sequence[CaseResult]) -> dict[str, Json]:
    """How many trials of all cases with these plans are trackworthy, and what decides the worst of the others.

    `share` is "9 of 18", "" where there was none; `all` says whether none of them failed.
    """
    found = [result.statistics for result in results if result.case.name in one.cases]
    tried, good = sum(case.tried for case in found), sum(case.trackworthy for case in found)
    share = f"{good} of {tried}" if tried else ""
    return {"share": share, "why": _why(found) if good < tried else "", "all": good == tried}


def _why(found: Sequence[CaseStatistics]) -> str:
    """The metric that decides the worst trial, or that there was no path to follow."""
    missed = [case.worst for case in found if case.worst is not None and not case.worst.trackworthy]
    return spoken(min(missed, key=lambda worst: worst.score).decided_by) if missed else "no path"
