"""The scenarios of a campaign as data: what was planned on each, what its cases violate, and where these are told."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from campaigns.summary import CaseResult
from reports.deciding import severity
from reports.dimensions import scales, scenario_words
from reports.fleet_words import called
from reports.json_result import Json
from reports.names import listed
from reports.quantity import counted, pair, text, text_with_g
from reports.trials_data import kept
from tracking.metric import Margin
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

_MOST_VIOLATIONS = 14


def scenarios_data(
    results: Sequence[CaseResult],
    outcomes: Mapping[str, Outcome],
    plans: Mapping[str, dict[str, Json]],
    figures: Mapping[str, Sequence[Json]] | None = None,
    versus: Mapping[str, Sequence[Json]] | None = None,
) -> list[dict[str, Json]]:
    """A scenario each, in the order of the cases, those without a map by their path's file.

    `plans` are the tables of the plans by the name of a case that flies one of them, `figures` and `versus` those of a
    scenario by its name.
    """
    found = scales([result.case for result in results])
    groups: dict[str, list[CaseResult]] = {}
    for result in results:
        groups.setdefault(scenario_of(result, found), []).append(result)
    return [
        {
            "name": name,
            "about": _about(group),
            "cases": [result.case.name for result in group],
            "figures": [*(figures or {}).get(name, ())],
            **_violations(group, outcomes),
            "plans": next((plans[one.case.name] for one in group if one.case.name in plans), None),
            "versus": [*(versus or {}).get(name, ())],
        }
        for name, group in groups.items()
    ]


def scenario_of(result: CaseResult, scales_of: Mapping[str, int]) -> str:
    """What the scenario of a case is called: its map, with the scale where there are several; else its path's file."""
    return scenario_words(result.case, scales_of) or Path(result.case.path).name


def _about(group: Sequence[CaseResult]) -> str:
    passed = sum(result.passed for result in group)
    worthy = sum(result.verdict == TRACKWORTHY for result in group)
    return f"{counted(len(group), 'case')}: {worthy} trackworthy; {passed} as expected"


def _violations(group: Sequence[CaseResult], outcomes: Mapping[str, Outcome]) -> dict[str, Json]:
    """The requirements that are missed, the worst first: of each case those of its worst trial."""
    rows = []
    for result in sorted(group, key=lambda one: severity(one, outcomes.get(one.case.name))):
        outcome = outcomes.get(result.case.name)
        if result.statistics.errors:
            rows.append(_whole(result, "failed to run", result.statistics.first_error, result.statistics.errors))
        if result.statistics.no_path:
            rows.append(_whole(result, "no path", result.statistics.no_path_reason, result.statistics.no_path))
        missed = [margin for margin in outcome.verdict.margins if not margin.met] if outcome else []
        rows += [_row(result, outcome, margin) for margin in sorted(missed, key=lambda one: one.relative) if outcome]
    return {"violations": [*rows[:_MOST_VIOLATIONS]], "violations_count": len(rows)}


def _whole(result: CaseResult, what: str, why: str, count: int) -> Json:
    """A case that could not be tried, or had nothing to follow."""
    return {
        "case": result.case.name, "words": what, "limit": "", "value": "", "by": "", "at": "", "note": why[:200],
        "trials": f"{count} of {result.case.trials}",
    }  # fmt: skip


def _row(result: CaseResult, outcome: Outcome, margin: Margin) -> Json:
    metric, requirement = margin.metric, margin.requirement
    value, _ = pair(metric.value, requirement.limit, metric.unit)
    found = result.statistics
    flown = found.tried - found.no_path
    return {
        "case": result.case.name,
        "words": listed(metric.name),
        "limit": f"{'≤' if requirement.comparison == '<=' else '≥'} {text_with_g(requirement.limit, metric.unit)}",
        "value": value,
        "by": text(-margin.value, metric.unit),
        "at": _at(outcome, margin),
        "note": metric.note if not metric.valid else "",
        "trials": f"{flown - kept(found, requirement)} of {flown}",
    }


def _at(outcome: Outcome, margin: Margin) -> str:
    metric = margin.metric
    at = text(metric.s, "m") if metric.s == metric.s else text(metric.t, "s") if metric.t == metric.t else ""
    return ", ".join(filter(None, (at, called(metric.who, outcome.limits.kind))))
