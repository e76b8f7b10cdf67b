"""What a check against a baseline found, as data for PDF and HTML."""

from __future__ import annotations

from collections.abc import Sequence

from campaigns.comparison import Comparison
from campaigns.gate import Check, Finding
from reports.files.json_result import Json
from reports.terminal.check_text import conclusion, shown_by, with_unit

_MOST = 30


def check_data(check: Check) -> dict[str, Json]:
    """What is worse, what is changed otherwise, and what is better, each the first few and how many there are."""
    worse = [finding for finding in check.findings if finding.comparison is not None]
    changed = [finding for finding in check.findings if finding.comparison is None]
    return {
        "campaign": check.campaign,
        "good": not check.findings,
        "conclusion": conclusion(check),
        "worse": [_worse(finding, finding.comparison) for finding in worse[:_MOST] if finding.comparison],
        "worse_count": len(worse),
        "changed": [_changed(finding) for finding in changed[:_MOST]],
        "changed_count": len(changed),
        "better": _better(check.improved),
        "better_count": len(check.improved),
    }


def _worse(finding: Finding, one: Comparison) -> Json:
    return {**_values(one), "allowed": with_unit(one.limit, one), "trial": f"{one.trial}", "command": finding.command}


def _changed(finding: Finding) -> Json:
    shown = shown_by(finding) if finding.command else ""
    return {"case": finding.case, "what": finding.message, "shown": shown, "command": finding.command}


def _better(improved: Sequence[Comparison]) -> list[Json]:
    return [_values(one) for one in improved[:_MOST]]


def _values(one: Comparison) -> dict[str, Json]:
    return {
        "case": one.case,
        "metric": one.metric,
        "old": with_unit(one.old, one),
        "new": with_unit(one.new, one),
        "by": with_unit(abs(one.worse), one),
    }
