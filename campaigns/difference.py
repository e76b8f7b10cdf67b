"""The difference between two samples of a metric: how large, how sure, and whether it may be chance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import binomtest, bootstrap, fisher_exact
from scipy.stats import t as student

from campaigns.limits import Limit
from planners.kernel import Floats

CONFIDENCE = 0.95  # of the intervals
RESAMPLES = 2000
BATCH = 1000  # resamples held in memory at once

# What a difference comes to; where a metric has no direction, more and less
BETTER, WORSE, MORE, LESS = "better", "worse", "more", "less"
CHANCE, SMALL, SAME = "may be chance", "too small to matter", "the same"
MIXED = "mixed"  # some metrics of a case better, some worse
UNLIKE = (BETTER, WORSE, MORE, LESS)


@dataclass(frozen=True, slots=True)
class Sample:
    """Values (N,) of a metric, and the seeds of their trials."""

    values: Floats
    seeds: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Difference:
    """From a metric's mean `before` to that `after`, in its SI unit: `change` is after - before.

    Taken over as many `pairs` of trials of the same seed, or, where that is 0, between two samples. `interval` is the
    95 % bootstrap interval of the change, None where one trial leaves nothing to resample. `outcome` is how the second
    does against the first: a change counts if it is larger than `limit`, that of the larger mean, and, with several
    trials, not chance.
    """

    metric: str
    unit: str
    direction: str
    before: float
    after: float
    change: float
    interval: tuple[float, float] | None
    pairs: int
    limit: float
    outcome: str

    @property
    def size(self) -> float:
        """The change in multiples of its limit, by which changes of different metrics are ranked."""
        return abs(self.change) / self.limit if self.limit > 0.0 else float("inf") if self.change else 0.0


def difference(
    metric: str, unit: str, direction: str, before: Sample, after: Sample, limit: Limit, chance: float
) -> Difference:
    """What lies between two samples of at least one value each.

    `chance` is how likely a difference by chance alone may be taken for one: Student's t-test, paired or Welch's, and
    for shares of ones and zeros McNemar's or Fisher's exact test, must say less, and the interval must exclude zero.
    """
    pair = paired(before, after)
    old, new = pair or (before.values, after.values)
    samples: tuple[Floats, ...] = (new - old,) if pair else (new, old)
    change = float(samples[0].mean() - (samples[1].mean() if len(samples) > 1 else 0.0))
    allowed = limit.allowed(max(abs(float(old.mean())), abs(float(new.mean()))))
    interval = change_interval(samples) if min(map(len, samples)) > 1 else None
    test = shares_differ if np.isin(np.concatenate((old, new)), (0.0, 1.0)).all() else _either_way
    sure = interval is None or (not interval[0] <= 0.0 <= interval[1] and test(samples) < chance)
    return Difference(
        metric=metric,
        unit=unit,
        direction=direction,
        before=float(old.mean()),
        after=float(new.mean()),
        change=change,
        interval=interval,
        pairs=len(old) if pair else 0,
        limit=allowed,
        outcome=_outcome(change, allowed, direction, sure),
    )


def paired(before: Sample, after: Sample) -> tuple[Floats, Floats] | None:
    """The values (P,) of the seeds that are in both; None where these are less than half of either."""
    old, new = ({seed: i for i, seed in enumerate(one.seeds)} for one in (before, after))
    common = sorted(old.keys() & new.keys())  # in one order, whichever comes first
    if 2 * len(common) < max(len(old), len(new)) or not common:
        return None
    return before.values[[old[seed] for seed in common]], after.values[[new[seed] for seed in common]]


def change_interval(samples: tuple[Floats, ...]) -> tuple[float, float]:
    """The 95 % interval of `mean_interval`, the negative of itself when what is compared changes places."""
    if len(samples) == 2 and samples[0].tobytes() > samples[1].tobytes():
        low, high = mean_interval((samples[1], samples[0]), 1.0 - CONFIDENCE, RESAMPLES)
        return -high, -low
    return mean_interval(samples, 1.0 - CONFIDENCE, RESAMPLES)


def mean_interval(samples: tuple[Floats, ...], chance: float, resamples: int) -> tuple[float, float]:
    """The percentile bootstrap interval of the mean of one sample, or of the first's mean minus the second's (Efron and
    Tibshirani 1993, 13.3), outside of which lies a share of `chance`. Samples have two values or more.
    """
    statistic = _mean if len(samples) == 1 else _difference
    interval = bootstrap(
        samples, statistic, n_resamples=resamples, batch=BATCH, confidence_level=1.0 - chance, method="percentile",
        rng=np.random.default_rng(0),
    ).confidence_interval  # fmt: skip
    return float(interval.low), float(interval.high)


def above_zero(samples: tuple[Floats, ...]) -> float:
    """How likely a mean, or a difference of means, at least this far above zero is by chance: Student's t-test of one
    sample, or Welch's (1947) of two.
    """
    squares = [sample.var(ddof=1) / len(sample) for sample in samples]
    total = sum(squares)
    mean = float(samples[0].mean() - (samples[1].mean() if len(samples) > 1 else 0.0))
    if total == 0.0:
        return 0.0 if mean > 0.0 else 1.0  # nothing random in them
    freedom = total**2 / sum(square**2 / (len(one) - 1) for square, one in zip(squares, samples, strict=True))
    return float(student.sf(mean / np.sqrt(total), freedom))


def shares_differ(samples: tuple[Floats, ...]) -> float:
    """How likely shares of ones differ at least as much by chance: McNemar's exact test of paired differences of ones
    and zeros, Fisher's of two samples of these.
    """
    if len(samples) == 1:
        up, down = (int(np.count_nonzero(samples[0] == sign)) for sign in (1.0, -1.0))
        return float(binomtest(up, up + down).pvalue) if up + down else 1.0
    table = [[int(one.sum()), len(one) - int(one.sum())] for one in samples]
    return float(fisher_exact(table).pvalue)


def _either_way(samples: tuple[Floats, ...]) -> float:
    """How likely a mean, or a difference, at least as far from zero is by chance."""
    return 2.0 * min(above_zero(samples), above_zero(tuple(-sample for sample in samples)))


def _outcome(change: float, limit: float, direction: str, sure: bool) -> str:
    if change == 0.0:
        return SAME
    if not sure:
        return CHANCE
    if abs(change) <= limit:
        return SMALL
    if direction == "neither":
        return MORE if change > 0.0 else LESS
    return BETTER if (change > 0.0) == (direction == "higher") else WORSE


def overall(differences: Sequence[Difference]) -> str:
    """What several differences of one case come to: better, worse, "mixed" or the same."""
    found = {one.outcome for one in differences}
    if {BETTER, WORSE} <= found:
        return MIXED
    return next((outcome for outcome in (BETTER, WORSE) if outcome in found), SAME)


def _mean(values: Floats, axis: int) -> Floats:
    return np.asarray(values.mean(axis=axis))


def _difference(after: Floats, before: Floats, axis: int) -> Floats:
    return np.asarray(after.mean(axis=axis) - before.mean(axis=axis))
