"""The PDF's summary as data for its template: a row a case, and what they count up to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from campaigns.summary import ERROR, CaseResult
from reports.files.json_result import Json
from reports.words.fleet_words import vehicle_words
from reports.words.trials_words import case_conditions, headline_words, planned_setting, verdict_reason, worst_words
from reports.words.words import conditions, reason
from tracking.outcome import Outcome
from tracking.verdict import EITHER, NOT_TRACKWORTHY, TRACKWORTHY


def outcome_row(outcome: Outcome, page: int) -> dict[str, Json]:
    """The row of a case that is one run, told on the case page of that number."""
    verdict = TRACKWORTHY if outcome.verdict.trackworthy else NOT_TRACKWORTHY
    return {
        "name": outcome.name,
        "vehicle": vehicle_words(outcome),
        "controller": outcome.controller,
        "conditions": list(conditions(outcome)),
        "verdict": verdict,
        "passed": outcome.verdict.passed,
        "expected": _expected(outcome.verdict.passed, outcome.verdict.expect),
        "why": reason(outcome),
        "more": [],
        "page": page,
    }


def result_row(result: CaseResult, outcome: Outcome | None, page: int | None) -> dict[str, Json]:
    """The row of a campaign's case; `outcome` is that of its worst trial, if it is shown."""
    if outcome is not None and page is not None and result.case.trials == 1 and result.verdict != ERROR:
        return outcome_row(outcome, page)
    vehicle, controller, speed = planned_setting(result)
    more = [headline_words(result)] if result.case.trials > 1 else []
    return {
        "name": result.case.name,
        "vehicle": vehicle if outcome is None else vehicle_words(outcome),
        "controller": controller,
        "conditions": [speed] if outcome is None else list(case_conditions(result, outcome)),
        "verdict": result.verdict,
        "passed": result.passed,
        "expected": _expected(result.passed, result.case.expect),
        "why": verdict_reason(result),
        "more": [line for line in (*more, worst_words(result, outcome) if outcome else "") if line],
        "page": page,
    }


def _expected(passed: bool, expect: str) -> str:
    if expect == EITHER:
        return "to be compared"
    return "as expected" if passed else f"expected: {expect.replace('-', ' ')}"


def summary_rows(
    outcomes: Sequence[Outcome], results: Sequence[CaseResult], pages: Mapping[str, int]
) -> list[dict[str, Json]]:
    """A row for each of `results`, or without them for each of `outcomes`; `pages` tells by name which has one."""
    if not results:
        return [outcome_row(outcome, number) for number, outcome in enumerate(outcomes)]
    by_name = {outcome.name: outcome for outcome in outcomes}
    return [result_row(result, by_name.get(result.case.name), pages.get(result.case.name)) for result in results]


def counts(rows: Sequence[Mapping[str, Json]]) -> dict[str, Json]:
    """How many cases came out as expected and how many did not, and how many failed to run, by their rows."""
    tried = [row for row in rows if row["verdict"] != ERROR]
    passed = sum(bool(row["passed"]) for row in tried)
    worthy = sum(row["verdict"] == TRACKWORTHY for row in tried)
    return {
        "total": len(rows),
        "passed": passed,
        "failed": len(tried) - passed,
        "worthy": worthy,
        "unworthy": len(tried) - worthy,
        "errors": len(rows) - len(tried),
    }
