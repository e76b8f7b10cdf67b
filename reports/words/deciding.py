"""The requirement that decides a case, by the worst of its trials: how much of the limit is left."""

from __future__ import annotations

import math
from dataclasses import dataclass

from campaigns.summary import ERROR, CaseResult
from reports.words.names import listed
from reports.words.quantity import number, text
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

_FAR = 10.0  # limits beyond which it does not matter how far


@dataclass(frozen=True, slots=True)
class Deciding:
    """What decides a case: the `metric`, and its margin as a share of the limit, "+46 %", or in the metric's unit where
    the limit is zero.

    `share` is the same as a number by which cases compare; where the limit is zero, the margin over the corridor. It is
    -inf where nothing was measured, and +inf where nothing was required.
    """

    metric: str
    words: str
    share: float


def deciding(result: CaseResult, outcome: Outcome | None) -> Deciding:
    """What decides the case of `result`; `outcome` is that of its worst trial, None where it is not at hand."""
    if result.verdict == ERROR:
        return Deciding("", "failed to run", -math.inf)
    if result.statistics.no_path:
        which = result.statistics.no_path
        some = f"no path in {which} of {result.statistics.tried}" if result.case.trials > 1 else "no path"
        return Deciding("completion", some, -1.0)
    margin = outcome.verdict.decisive if outcome else None
    if outcome is not None and margin is not None:
        at_zero = margin.requirement.limit == 0.0
        return _told(margin.metric.name, margin.relative, at_zero, outcome.corridor, margin.metric.unit)
    worst = result.worst
    if worst is None or not worst.decided_by:
        return Deciding("", "", math.inf)
    measured = worst.metrics.get(worst.decided_by)
    # Of a limit of zero the margin is the value itself.
    at_zero = measured is not None and measured.value is not None and abs(measured.value) == abs(worst.score)
    corridor = result.case.corridor if isinstance(result.case.corridor, float) else math.nan
    return _told(worst.decided_by, worst.score, at_zero, corridor, result.units[worst.decided_by][0])


def severity(result: CaseResult, outcome: Outcome | None) -> tuple[bool, float, int]:
    """By this the worst cases come first: those that failed, then by what is left of their limits."""
    return result.verdict == TRACKWORTHY, deciding(result, outcome).share, result.number


def _told(metric: str, margin: float, at_zero: bool, corridor: float, unit: str) -> Deciding:
    if math.isinf(margin) or math.isnan(margin):
        return Deciding(metric, "not measured", -math.inf)
    if at_zero:
        scale = corridor if unit == "m" and corridor > 0.0 else 1.0
        return Deciding(metric, _signed(margin, text(margin, unit)), margin / scale)
    words = f"{number(100.0 * margin, 2)} %" if margin > -_FAR else f"<{number(-100.0 * _FAR)} %"
    return Deciding(metric, _signed(margin, words), margin)


def _signed(value: float, words: str) -> str:
    return f"+{words}" if value > 0.0 else words


def metric_words(found: Deciding) -> str:
    """The metric in words, "" for none."""
    return listed(found.metric) if found.metric else ""
