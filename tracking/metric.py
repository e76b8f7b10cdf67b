"""A metric is a record: a number with its unit, its direction, its validity, and where it was worst."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypedDict

SCHEMA_VERSION = 1  # of the metric definitions: a changed definition is a new version


@dataclass(frozen=True, slots=True)
class Metric:
    """A measured quantity in SI units: angles in radians, "share" for a part of a whole, "1" for counts and ratios.

    `better` is "lower", "higher" or "neither". `s` [m] and `t` [s] tell where along the path and when it was worst
    (NaN where it has no place), `who` which of several vehicles ("2", "1 and 3"). A metric that could not be measured
    has `valid` False, a NaN value, and its reason in `note`.
    """

    name: str
    value: float
    unit: str
    better: str = "lower"
    s: float = math.nan
    t: float = math.nan
    valid: bool = True
    note: str = ""
    who: str = ""


class Where(TypedDict, total=False):
    """Where along the path [m] and when [s] a metric was worst, as keyword arguments of `Metric`."""

    s: float
    t: float


@dataclass(frozen=True, slots=True)
class Requirement:
    """A limit on a metric, in SI units: `metric` `comparison` `limit`, with comparison "<=" or ">="."""

    metric: str
    comparison: str
    limit: float
    source: str = ""


@dataclass(frozen=True, slots=True)
class Margin:
    """What remains to a requirement's limit: positive when met, negative by how much it is missed, in its unit.

    A metric that is not valid fails its requirement, with a NaN margin.
    """

    requirement: Requirement
    metric: Metric
    value: float

    @property
    def met(self) -> bool:
        """Whether the requirement is met; a metric that could not be measured meets nothing."""
        return self.value >= 0.0

    @property
    def relative(self) -> float:
        """The margin as a share of its limit, by which margins of different units compare; -inf where it is NaN."""
        if math.isnan(self.value):
            return -math.inf
        scale = abs(self.requirement.limit)
        return self.value / scale if scale > 0.0 else self.value
