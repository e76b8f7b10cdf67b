"""The one point of a run that a figure marks: where the metric that decides the verdict was worst."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from reports.words.quantity import text
from reports.words.words import closest, missed
from tracking.metric import Metric
from tracking.outcome import Outcome

_LARGEST = "Largest cross-track error"
_AT_THE_TIME = 1.0  # [s] a sample farther from a metric's time is not the one it speaks of


@dataclass(frozen=True, slots=True)
class Focus:
    """At arc length `s` [m], at (`x`, `y`) [m]; `index` is the track's sample there, or None where none was flown.

    `title` says what it is, `label` its value; it is an `alarm` where the run is not trackworthy.
    """

    s: float
    x: float
    y: float
    index: int | None
    label: str
    title: str
    alarm: bool


def focus(outcome: Outcome) -> Focus | None:
    """Where the deciding metric was worst; one without a place gives way to the largest cross-track error."""
    own = outcome.fleet.members[outcome.fleet.member] if outcome.fleet else outcome
    margin, cross_track = outcome.verdict.decisive, own.metrics.get("cross_track_max")
    for metric in (margin.metric if margin else None, cross_track):
        if metric is not None and metric.valid and (found := _locate(outcome, metric)):
            return found
    error = np.abs(outcome.track["cross_track"])
    if not np.isfinite(error).any():
        return None
    index = int(np.nanargmax(error))
    return _at_sample(outcome, index, _LARGEST, text(float(error[index]), "m"))


def _locate(outcome: Outcome, metric: Metric) -> Focus | None:
    title, label = _told(outcome, metric)
    if math.isfinite(metric.t) and len(outcome.track):
        late = np.abs(outcome.track["t"] - metric.t + _departure(outcome, metric))
        if np.isfinite(late).any() and np.nanmin(late) <= _AT_THE_TIME:
            return _at_sample(outcome, int(np.nanargmin(late)), title, label)
    if math.isfinite(metric.s):
        return Focus(metric.s, *outcome.path.point_at(metric.s), None, label, title, not outcome.verdict.trackworthy)
    return None


def _departure(outcome: Outcome, metric: Metric) -> float:
    """When the clock of the vehicle started on that of the metric [s]: what two share is told on the fleet's."""
    return outcome.fleet.departures[outcome.fleet.member] if outcome.fleet and " " in metric.who else 0.0


def _told(outcome: Outcome, metric: Metric) -> tuple[str, str]:
    """Title and label: a metric that decides is told with its limit."""
    value, margin = text(metric.value, metric.unit), outcome.verdict.decisive
    if margin is None or margin.metric is not metric:
        return _LARGEST, value
    return ("Closest to a limit", closest(margin)) if margin.met else ("Worst point", missed(margin))


def _at_sample(outcome: Outcome, index: int, title: str, label: str) -> Focus | None:
    s, x, y = (float(outcome.track[column][index]) for column in ("s", "x", "y"))
    alarm = not outcome.verdict.trackworthy
    return Focus(s, x, y, index, label, title, alarm) if math.isfinite(s + x + y) else None
