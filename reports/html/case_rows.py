"""The table of all cases as the page sorts and filters it: numbers beside their words."""

from __future__ import annotations

import math
from collections.abc import Mapping

from campaigns.finished import Finished
from campaigns.summary import ERROR, CaseResult
from reports.files.json_result import Json
from reports.words.campaign_words import HEADLINE
from reports.words.deciding import deciding
from reports.words.dimensions import CONTROLLER, PATH, SCENARIO, SPEED, VEHICLE, dimensions
from reports.words.fleet_words import vehicle_words
from reports.words.names import spoken
from reports.words.quantity import number, text
from tracking.outcome import Outcome


def case_rows(finished: Finished) -> list[Json]:
    """A row a case, in their order; each number with the words that are shown for it, null where there is none."""
    told = dimensions(finished.results, finished.outcomes)
    pairs = zip(finished.results, told, strict=True)
    ranks = _ranks(finished)
    return [
        {**_row(result, finished.outcomes.get(result.case.name), what), "rank": ranks.get(result.number)}
        for result, what in pairs
    ]


def _row(result: CaseResult, outcome: Outcome | None, what: Mapping[str, str]) -> dict[str, Json]:
    case, found, worst = result.case, result.statistics, result.worst
    p95 = found.metrics.get(HEADLINE)
    score = worst.score if worst is not None and math.isfinite(worst.score) else None
    return {
        "number": result.number,
        "name": case.name,
        "path": what[PATH],
        "scenario": what[SCENARIO],
        "vehicle": vehicle_words(outcome) if outcome else what[VEHICLE],
        "controller": what[CONTROLLER],
        "speed": outcome.speed if outcome else case.speed if isinstance(case.speed, float) else None,
        "speed_words": what[SPEED],
        "verdict": result.verdict,
        "passed": result.passed,
        "expect": case.expect,
        "trials": case.trials,
        "share": found.share if found.tried else None,
        "share_words": f"{found.trackworthy} of {found.tried}" if result.verdict != ERROR else "",
        "decided": spoken(worst.decided_by) if worst is not None and worst.decided_by else "",
        "missed": (score is not None and score < 0.0) or bool(found.no_path or found.errors),
        **_margin(result, outcome, score),
        "p95": p95.p95 if p95 else None,
        "p95_words": text(p95.p95, "m") if p95 else "",
    }


def _ranks(finished: Finished) -> dict[int, int]:
    """The places of cases by what is left of the limit that decides, by their numbers. First come those that failed to
    run, then those without a path; cases of which nothing is required have none.
    """
    told = {result.number: deciding(result, finished.outcomes.get(result.case.name)) for result in finished.results}
    kinds = {
        result.number: 0 if result.verdict == ERROR else 1 if result.statistics.no_path else 2
        for result in finished.results
    }
    keys = {number: (kinds[number], one.share) for number, one in told.items() if one.share < math.inf}
    order = {key: place for place, key in enumerate(sorted(set(keys.values())))}
    return {number: order[key] for number, key in keys.items()}


def _margin(result: CaseResult, outcome: Outcome | None, score: float | None) -> dict[str, Json]:
    """In its unit and as a share of its limit; the share alone where the trial is not shown, words for no path."""
    if result.verdict == ERROR or result.statistics.no_path:
        return {"margin_words": deciding(result, outcome).words, "margin_share": ""}
    decisive = outcome.verdict.decisive if outcome else None
    share = "" if score is None else f"{_signed(score)}{number(100 * score)} %"
    if decisive is None or not math.isfinite(decisive.value):
        return {"margin_words": share, "margin_share": ""}
    value = f"{_signed(decisive.value)}{text(decisive.value, decisive.metric.unit)}"
    alike = decisive.metric.unit == "share" or decisive.requirement.limit == 0.0
    if decisive.requirement.limit == 0.0 and decisive.metric.unit == "m" and outcome and outcome.corridor > 0.0:
        over = decisive.value / outcome.corridor
        return {"margin_words": value, "margin_share": f"{_signed(over)}{number(100 * over)} % of corridor"}
    return {"margin_words": value, "margin_share": "" if alike else share}


def _signed(value: float) -> str:
    return "+" if value > 0.0 else ""
