"""The verdict on one run: which requirements it meets, by how much, and what that makes of it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import Literal

from tracking.metric import Margin, Metric, Requirement

Expectation = Literal["trackworthy", "not-trackworthy", "either"]
TRACKWORTHY: Expectation = "trackworthy"
NOT_TRACKWORTHY: Expectation = "not-trackworthy"
EITHER: Expectation = "either"  # what is measured to be compared
RELATIVE = attrgetter("relative")


@dataclass(frozen=True, slots=True)
class Verdict:
    """Trackworthy if every margin is met; `margins` in the order of the requirements; `expect` is what was expected."""

    margins: tuple[Margin, ...]
    expect: str = TRACKWORTHY

    @property
    def trackworthy(self) -> bool:
        """Whether every requirement is met."""
        return all(margin.met for margin in self.margins)

    @property
    def passed(self) -> bool:
        """Whether the outcome is the expected one."""
        return self.expect == EITHER or self.trackworthy == (self.expect == TRACKWORTHY)

    @property
    def decisive(self) -> Margin | None:
        """The margin that decides, the worst relative to its limit; None without requirements.

        Where all are met, what cannot be better (the whole path, no incursion) is not close to anything, however small
        its margin.
        """
        worst = min(self.margins, key=RELATIVE, default=None)
        if worst is None or not worst.met:
            return worst
        return min(
            (margin for margin in self.margins if not _perfect(margin)),
            key=lambda margin: margin.relative,
            default=worst,
        )


def _perfect(margin: Margin) -> bool:
    metric = margin.metric
    if metric.better == "higher":
        return metric.unit == "share" and metric.value >= 1.0
    return metric.better == "lower" and metric.value == 0.0


def judge(metrics: Mapping[str, Metric], requirements: Sequence[Requirement], expect: str) -> Verdict:
    """Hold `metrics` against `requirements`."""
    return Verdict(tuple(_margin(metrics, requirement) for requirement in requirements), expect)


def _margin(metrics: Mapping[str, Metric], requirement: Requirement) -> Margin:
    metric = metrics[requirement.metric]
    sign = 1.0 if requirement.comparison == "<=" else -1.0
    value = sign * (requirement.limit - metric.value) + 0.0 if metric.valid else math.nan
    return Margin(requirement, metric, value)
