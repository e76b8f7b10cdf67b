"""Every requirement of a campaign with its source, and how many cases have it."""

from __future__ import annotations

from collections import Counter

from campaigns.finished import Finished
from reports.json_result import Json
from reports.names import listed
from reports.quantity import text_with_g


def requirement_rows(finished: Finished) -> list[Json]:
    """A row for each limit on a metric, as the verdicts of the worst trials hold it."""
    count = Counter(
        (listed(margin.requirement.metric), _limit(margin.requirement.comparison, margin.requirement.limit, margin.metric.unit),
         margin.requirement.source)
        for outcome in finished.outcomes.values()
        for margin in outcome.verdict.margins
    )  # fmt: skip
    return [
        {"words": words, "limit": limit, "source": source, "cases": cases}
        for (words, limit, source), cases in count.items()
    ]


def _limit(comparison: str, limit: float, unit: str) -> str:
    return f"{'≤' if comparison == '<=' else '≥'} {text_with_g(limit, unit)}"
