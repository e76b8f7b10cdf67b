"""A case of several trials in words: its own verdict, and its worst trial called by that name."""

from __future__ import annotations

from pathlib import Path

from campaigns.conditions import known_wind
from campaigns.summary import CaseResult
from reports.words.campaign_words import HEADLINE, no_path_words, share_words
from reports.words.fleet_words import GROUND, vehicle_words
from reports.words.names import spoken
from reports.words.quantity import number, text
from reports.words.words import closest, missed, place, speed_text, speed_words, wind_words
from sim.vehicles import ALL_TRUCKS
from tracking.outcome import Outcome


def case_conditions(result: CaseResult, outcome: Outcome) -> tuple[str, ...]:
    """Speed, and wind where it matters; `outcome` is that of any trial."""
    wind = known_wind(result.case.conditions)
    if wind is not None and wind.speed == 0.0 and outcome.limits.kind == GROUND:
        return (speed_words(outcome),)
    return speed_words(outcome), "wind varies" if wind is None else wind_words(wind)


def case_setting(result: CaseResult, outcome: Outcome) -> str:
    """Vehicle, controller, speed, wind and number of trials."""
    trials = f"{result.case.trials} trials{', each on a plan of its own' if result.case.replan else ''}"
    return " · ".join([vehicle_words(outcome), outcome.controller, *case_conditions(result, outcome), trials])


def planned_setting(result: CaseResult) -> tuple[str, str, str]:
    """Vehicle, controller and speed as the case states them, for one without an outcome."""
    case = result.case
    kind = GROUND if Path(case.vehicle).stem in ALL_TRUCKS else ""
    speed = case.speed if isinstance(case.speed, str) else "" if case.speed is None else speed_text(case.speed, kind)
    return Path(case.vehicle).stem, case.controller, speed


def verdict_reason(result: CaseResult) -> str:
    """Why the verdict of the case is what it is: errors, or the share of its trials and what was asked of them."""
    found, case = result.statistics, result.case
    if found.errors:
        count = f"{found.errors} of {case.trials} trials failed to run: " if case.trials > 1 else ""
        return f"{count}{found.first_error}"
    if case.trials == 1 and result.worst is not None:
        return f"decided by {spoken(result.worst.decided_by)}" if result.worst.decided_by else ""
    if case.trials == 1:
        return "".join(no_path_words(result))
    asked = f", at least {number(100 * case.pass_share)} % must be" if case.pass_share < 1.0 else ""
    return "; ".join([share_words(result) + asked, *no_path_words(result)])


def headline_words(result: CaseResult) -> str:
    """The error that 95 % of the way keep within, over trials: p95 and worst."""
    one = result.statistics.metrics.get(HEADLINE)
    if one is None:
        return ""
    unit = result.units[HEADLINE][0]
    return f"95 % of the way within {text(one.p95, unit)} in 95 % of trials, {text(one.worst, unit)} in the worst"


def worst_name(result: CaseResult) -> str:
    """ "worst of 20: trial 7", or of those that were flown."""
    if result.worst is None:
        return ""
    found = result.statistics
    of = f"{found.tried - found.no_path} flown" if found.no_path else f"{result.case.trials}"
    return f"worst of {of}: trial {result.worst.trial}"


def worst_words(result: CaseResult, outcome: Outcome) -> str:
    """ "worst of 20: trial 7, not trackworthy: bank 31° > 30° at 3.41 km"."""
    margin = outcome.verdict.decisive
    if margin is None:
        return worst_name(result)
    if margin.met:
        return f"{worst_name(result)}, trackworthy; closest: {closest(margin)}"
    return f"{worst_name(result)}, not trackworthy: {missed(margin)}{place(margin, outcome.limits.kind)}"
