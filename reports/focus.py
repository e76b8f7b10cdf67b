"""The one point of a run that a figure marks: where the metric that decides the verdict was worst."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from reports.deciding import deciding
from reports.quantity import reading_unit, text
from tracking.metric import Metric
from tracking.outcome import Outcome

_AT_THE_TIME = 1.0  # [s] a sample farther from a metric's time is not the one it speaks of


@dataclass(frozen=True, slots=True)
class Focus:
    """At arc length `s` [m], at (`x`, `y`) [m]; `index` is the track's sample there, or None where none was flown."""

    s: float
    x: float
    y: float
    index: int | None
    label: str


def focus(outcome: Outcome) -> Focus | None:
    """Where the deciding metric was worst; one without a place gives way to the largest cross-track error."""
    for metric in _candidates(outcome):
        if metric.valid and (found := _locate(outcome, metric)):
            return found
    error = np.abs(outcome.track["cross_track"])
    if not np.isfinite(error).any():
        return None
    index = int(np.nanargmax(error))
    return _at_sample(outcome, index, f"cross-track {text(float(error[index]), 'm')}")


def _candidates(outcome: Outcome) -> list[Metric]:
    margin, cross_track = deciding(outcome.verdict), outcome.metrics.get("cross_track_max")
    return [metric for metric in (margin.metric if margin else None, cross_track) if metric is not None]


def _locate(outcome: Outcome, metric: Metric) -> Focus | None:
    label = f"{metric.name} {text(metric.value, reading_unit(metric))}"
    if math.isfinite(metric.t) and len(outcome.track):
        late = np.abs(outcome.track["t"] - metric.t)
        if np.isfinite(late).any() and np.nanmin(late) <= _AT_THE_TIME:
            return _at_sample(outcome, int(np.nanargmin(late)), label)
    if math.isfinite(metric.s):
        return Focus(metric.s, *outcome.path.point_at(metric.s), None, label)
    return None


def _at_sample(outcome: Outcome, index: int, label: str) -> Focus | None:
    s, x, y = (float(outcome.track[column][index]) for column in ("s", "x", "y"))
    return Focus(s, x, y, index, label) if math.isfinite(s + x + y) else None
