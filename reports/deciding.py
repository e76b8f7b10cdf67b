"""Which requirement a verdict is told by."""

from __future__ import annotations

import math

from reports.quantity import reading_unit
from tracking.metric import Margin
from tracking.verdict import Verdict


def deciding(verdict: Verdict) -> Margin | None:
    """The margin that decides, None without requirements.

    Where all are met, one that cannot be met any better (all of the path, no incursion) is not the closest,
    however small its margin: it gives way to the smallest of the others.
    """
    if not verdict.margins:
        return None
    decisive = verdict.decisive
    if not decisive.met:
        return decisive
    open_ended = tuple(margin for margin in verdict.margins if not _perfect(margin))
    return Verdict(open_ended, verdict.expect).decisive if open_ended else decisive


def _perfect(margin: Margin) -> bool:
    metric = margin.metric
    if margin.requirement.comparison == ">=":
        return reading_unit(metric) == "share" and metric.value >= 1.0
    return metric.better == "lower" and math.isclose(metric.value, 0.0, abs_tol=1e-12)
