"""Every requirement of a campaign with its source, and how many cases have it."""

from __future__ import annotations

from collections import Counter

from campaigns.finished import Finished
from reports.json_result import Json
from reports.names import listed
from reports.quantity import text_with_g
from tracking.metric import Requirement


def requirement_rows(finished: Finished) -> list[Json]:
    """A row for each limit on a metric, as the verdicts of the worst trials hold it."""
    margins = [margin for outcome in finished.outcomes.values() for margin in outcome.verdict.margins]
    count = Counter(
        (one.requirement.metric, _limit(one.requirement, one.metric.unit), one.requirement.source) for one in margins
    )
    return [
        {"words": listed(metric), "limit": limit, "source": source, "cases": cases}
        for (metric, limit, source), cases in count.items()
    ]


def _limit(requirement: Requirement, unit: str) -> str:
    return f"{'≤' if requirement.comparison == '<=' else '≥'} {text_with_g(requirement.limit, unit)}"
