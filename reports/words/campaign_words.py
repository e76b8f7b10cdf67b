"""A campaign's results as lines of text."""

from __future__ import annotations

import numpy as np

from campaigns.summary import ERROR, CaseResult
from reports.words.quantity import counted, number, text
from reports.words.words import reason, sentence
from tracking.outcome import Outcome
from tracking.verdict import EITHER, NOT_TRACKWORTHY, TRACKWORTHY

HEADLINE = "cross_track_p95"


def case_line(result: CaseResult, outcome: Outcome | None) -> str:
    """What became of a case, in one line; `outcome` is that of its worst trial."""
    return f"{mark(result)} {result.case.name}: {_told(result, outcome)}"


def case_verdict_words(result: CaseResult) -> str:
    """TRACKWORTHY, NOT TRACKWORTHY or FAILED TO RUN, and the expectation where it is not to be taken for granted."""
    if result.verdict == ERROR:
        return "FAILED TO RUN"
    word = "TRACKWORTHY" if result.verdict == TRACKWORTHY else "NOT TRACKWORTHY"
    if result.case.expect == EITHER:
        return f"{word} (to be compared)"
    if result.case.expect != NOT_TRACKWORTHY:
        return word
    return f"{word} (as expected)" if result.passed else f"{word} (expected not to be)"


def mark(result: CaseResult) -> str:
    """ "pass ", "FAIL " or "error"."""
    if result.verdict == ERROR:
        return "error"
    return "pass " if result.passed else "FAIL "


def _told(result: CaseResult, outcome: Outcome | None) -> str:
    found, case = result.statistics, result.case
    if found.errors:
        share = f"{found.errors} of {case.trials} trials: " if case.trials > 1 else ""
        return f"{share}{found.first_error}"
    if case.trials == 1:
        return sentence(outcome) if outcome else "  ".join([case_verdict_words(result), *no_path_words(result)])
    parts = [share_words(result), *no_path_words(result), *spread_words(result)]
    if outcome is not None and result.worst is not None:
        parts.append(f"worst: trial {result.worst.trial}, {reason(outcome)}")
    return "; ".join(parts)


def share_words(result: CaseResult) -> str:
    """ "18 of 20 trials trackworthy (68.3 to 98.8 %)": with the 95 % interval of the share, unless all are the same."""
    found = result.statistics
    low, high = found.interval
    if all_alike(result):
        return f"{found.trackworthy} of {found.tried} trials trackworthy, all alike: nothing in them is random"
    return f"{found.trackworthy} of {found.tried} trials trackworthy ({number(100 * low)} to {number(100 * high)} %)"


def all_alike(result: CaseResult) -> bool:
    """Whether several trials differ in nothing, as without chance in plan and conditions: no interval then."""
    found, values = result.statistics, result.statistics.values
    if len(values) < 2 or found.trackworthy not in (0, found.tried) or found.no_path:
        return False
    return bool(np.array_equal(values, np.broadcast_to(values[0], values.shape), equal_nan=True))


def no_path_words(result: CaseResult) -> list[str]:
    """ "3 of 20 trials found no path: the colony lost its way", or nothing where all did."""
    found = result.statistics
    if not found.no_path:
        return []
    which = f"{found.no_path} of {counted(found.tried, 'trial')} found" if result.case.trials > 1 else "found"
    return [f"{which} no path: {found.no_path_reason}"]


def spread_words(result: CaseResult) -> list[str]:
    """The headline metric over the trials, and the steady bias apart from the spread; nothing where none was flown."""
    found = result.statistics
    if found.tried == found.no_path:
        return []
    parts = []
    if one := found.metrics.get(HEADLINE):
        unit = result.units[HEADLINE][0]
        parts.append(
            f"95 % of the way within {text(one.median, unit)} (median), {text(one.p95, unit)} (p95), "
            f"{text(one.worst, unit)} (worst)"
        )
    parts.append(f"bias {text(found.bias, 'm', 2)}, spread {text(found.spread, 'm', 2)}")
    return parts
