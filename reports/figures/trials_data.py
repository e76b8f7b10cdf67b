"""What a figure shows of a metric over trials: how much of its limit each of them used."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from campaigns.statistics import CaseStatistics
from planners.kernel import Floats
from reports.words.campaign_words import HEADLINE
from tracking.metric import Requirement
from tracking.outcome import Outcome

_MOST = 6  # metrics


@dataclass(frozen=True, slots=True)
class Strip:
    """A metric held against a limit from above: `used` (F,) is each flown trial's share of it, NaN where it has none.

    The limit is `stated` by a requirement, or else the corridor.
    """

    metric: str
    unit: str
    limit: float
    used: Floats
    stated: bool

    @property
    def missed(self) -> int:
        """How many of the flown trials do not keep the limit."""
        return int(np.count_nonzero(~(self.used <= 1.0)))


def strips(found: CaseStatistics, outcome: Outcome) -> list[Strip]:
    """The cross-track errors first, held against the corridor where nothing else is stated, then what else has an
    upper limit.
    """
    required = [margin.requirement for margin in outcome.verdict.margins]
    stated = {one.metric: one.limit for one in required if one.comparison == "<=" and one.limit > 0.0}
    upper = dict.fromkeys((HEADLINE, "cross_track_max"), outcome.corridor) | stated
    return [
        Strip(name, outcome.metrics[name].unit, limit, column(found, name) / limit, name in stated)
        for name, limit in upper.items()
        if name in found.names and name in outcome.metrics
    ][:_MOST]


def column(found: CaseStatistics, metric: str) -> Floats:
    """The metric's value in every trial that was flown (F,)."""
    values: Floats = found.values[found.flown, found.names.index(metric)]
    return values


def kept(found: CaseStatistics, requirement: Requirement) -> int:
    """How many of the flown trials meet `requirement`."""
    values = column(found, requirement.metric)
    met = values <= requirement.limit if requirement.comparison == "<=" else values >= requirement.limit
    return int(np.count_nonzero(met))
