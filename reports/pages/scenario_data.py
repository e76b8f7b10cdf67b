"""The scenarios of a campaign as data: what was planned on each, what its cases violate, and where these are told."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from campaigns.summary import CaseResult
from reports.figures.drawing import Drawing
from reports.figures.scenario_cases import ScenarioRuns
from reports.figures.trials_data import kept
from reports.files.json_result import Json
from reports.words.deciding import severity
from reports.words.fleet_words import called
from reports.words.names import listed
from reports.words.quantity import counted, pair, text, text_with_g
from tracking.metric import Margin
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

_MOST_VIOLATIONS = 14


def scenarios_data(
    scenarios: Sequence[ScenarioRuns],
    plans: Mapping[str, dict[str, Json]],
    figures: Sequence[Sequence[Drawing]] = (),
    versus: Sequence[Mapping[str, Json]] = (),
) -> list[dict[str, Json]]:
    """What is told of each of `scenarios`, whose `figures` are in the same order.

    `plans` are the tables of the plans by the name of a case that follows one of them; `versus` are tables of cases
    side by side, told where their cases are.
    """
    return [_scenario(one, plans, figures[i] if figures else (), versus) for i, one in enumerate(scenarios)]


def _scenario(
    runs: ScenarioRuns,
    plans: Mapping[str, dict[str, Json]],
    figures: Sequence[Drawing],
    versus: Sequence[Mapping[str, Json]],
) -> dict[str, Json]:
    group = [run.result for run in runs.runs]
    outcomes = {run.result.case.name: run.outcome for run in runs.runs if run.outcome is not None}
    names = [result.case.name for result in group]
    return {
        "name": runs.name,
        "about": _about(group),
        "cases": [*names],
        "figures": [{"file": one.svg, "caption": one.caption} for one in figures],
        **_violations(group, outcomes),
        "plans": next((plans[name] for name in names if name in plans), None),
        "versus": [{**table} for table in versus if _case_of(table) in names],
    }


def _case_of(table: Mapping[str, Any]) -> str:
    """A case that a table is about."""
    return str(table["blocks"][0]["rows"][0]["case"])


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
