"""The trials of a case as data for the PDF's template: every number already words."""

from __future__ import annotations

from campaigns.summary import ERROR, CaseResult
from reports.figures.trials_data import kept
from reports.files.json_result import Json
from reports.words.campaign_words import HEADLINE, all_alike
from reports.words.condition_words import condition_words
from reports.words.names import listed
from reports.words.quantity import text
from reports.words.trials_words import case_setting, headline_words, verdict_reason, worst_name
from reports.words.words import planet_words
from tracking.metric import Requirement
from tracking.outcome import Outcome


def trials_data(result: CaseResult, outcome: Outcome, figure: str) -> dict[str, Json]:
    """All trials of a case as `report.typ` reads them; `outcome` is the worst one's, `figure` may be "" for none."""
    found = result.statistics
    required = [margin.requirement for margin in outcome.verdict.margins if margin.requirement.metric in found.metrics]
    others = [name for name in (HEADLINE, "cross_track_max") if name in found.metrics]
    return {
        "verdict": result.verdict,
        "passed": result.passed,
        "setting": " · ".join([case_setting(result, outcome), *planet_words(outcome)]),
        "reason": verdict_reason(result),
        "interval": result.verdict != ERROR and not all_alike(result),
        "headline": headline_words(result),
        "spread": f"bias {text(found.bias, 'm', 2)}, spread {text(found.spread, 'm', 2)} over the whole path",
        "worst": worst_name(result),
        "conditions": list(condition_words(result.case.conditions)),
        "figure": figure,
        "metrics": [
            *(_required(result, requirement) for requirement in required),
            *(_row(result, name) for name in others if name not in {one.metric for one in required}),
        ],
    }


def _required(result: CaseResult, requirement: Requirement) -> dict[str, Json]:
    found, name = result.statistics, requirement.metric
    unit, count = result.units[name][0], kept(result.statistics, requirement)
    limit = f"{'≤' if requirement.comparison == '<=' else '≥'} {text(requirement.limit, unit)}"
    flown = found.tried - found.no_path
    return {**_row(result, name), "limit": limit, "kept": f"{count} of {flown}", "met": count == flown}


def _row(result: CaseResult, name: str) -> dict[str, Json]:
    one, unit = result.statistics.metrics[name], result.units[name][0]
    return {
        "words": listed(name),
        "median": text(one.median, unit),
        "p95": text(one.p95, unit),
        "worst": text(one.worst, unit),
        "trial": str(one.worst_trial),
        "limit": "",
        "kept": "",
        "met": None,
    }
