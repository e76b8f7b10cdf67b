"""One metric of one case against its baseline: how much worse it is, and whether that may be chance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.stats import fisher_exact

from campaigns.baseline import CaseBaseline
from campaigns.difference import above_zero, mean_interval
from campaigns.limits import Limit
from planners.kernel import Floats

MOST_RESAMPLES = 50_000
TAIL = 10  # resamples that lie beyond the interval's edge, so that it is one


@dataclass(frozen=True, slots=True)
class Comparison:
    """Means over the trials, `old` and `new`, in `unit`; `worse`, by how much the new one is in the metric's direction.

    `limit` is what is allowed; `regressed` and `improved` say that it changed by more, and not by chance. `trial` with
    `seed` worsened most.
    """

    case: str
    metric: str
    unit: str
    old: float
    new: float
    worse: float
    limit: float
    regressed: bool
    improved: bool
    trial: int
    seed: int


@dataclass(frozen=True, slots=True)
class _Sample:
    """The measured values (N,), larger being worse, with the seeds and numbers of their trials."""

    values: Floats
    seeds: tuple[int, ...]
    numbers: tuple[int, ...]


def compare(
    case: str, metric: str, unit: str, old: CaseBaseline, new: CaseBaseline, higher_is_better: bool, limit: Limit,
    chance: float,
) -> Comparison | None:  # fmt: skip
    """Hold the new values of a metric against the old ones; None where there are none on one side.

    Paired by seed where at least one is common to both, else as two samples. `chance` is how likely a difference by
    chance alone may be taken for one.
    """
    sign = -1.0 if higher_is_better else 1.0
    before, after = _sample(old, metric, sign), _sample(new, metric, sign)
    if not len(before.values) or not len(after.values):
        return None
    common = [seed for seed in after.seeds if seed in set(before.seeds)]
    if common:
        before, after = _only(before, common), _only(after, common)
        change = after.values - before.values
        worst = int(np.argmax(change))
        samples: tuple[Floats, ...] = (change,)
    else:
        worst, samples = int(np.argmax(after.values)), (after.values, before.values)
    mean_before, mean_after = float(before.values.mean()), float(after.values.mean())
    worse, allowed = mean_after - mean_before, limit.allowed(mean_before)
    return Comparison(
        case=case,
        metric=metric,
        unit=unit,
        old=sign * mean_before,
        new=sign * mean_after,
        worse=worse,
        limit=allowed,
        regressed=worse > allowed and _beyond_chance(samples, chance),
        improved=worse < -allowed and _beyond_chance(tuple(-sample for sample in samples), chance),
        trial=after.numbers[worst],
        seed=after.seeds[worst],
    )


def flipped(old: CaseBaseline, new: CaseBaseline, chance: float) -> bool:
    """Whether a verdict that differs says anything: with the same seeds or one trial it does; otherwise Fisher's exact
    test on the shares of trackworthy trials decides.
    """
    if set(old.seeds) & set(new.seeds) or min(len(old.seeds), len(new.seeds)) < 2:
        return True
    table = [[case.trackworthy, len(case.seeds) - case.trackworthy] for case in (old, new)]
    return bool(fisher_exact(table).pvalue < chance)


def _beyond_chance(samples: tuple[Floats, ...], chance: float) -> bool:
    """Whether the bootstrap interval of the mean difference lies above zero (Efron and Tibshirani 1993, 13.3).

    Of two small samples that interval is too narrow; there Welch's t-test (1947) must agree.
    """
    if min(len(sample) for sample in samples) < 2:
        return True  # a single trial leaves nothing to resample
    if len(samples) == 2 and above_zero(samples) >= chance:
        return False
    resamples = int(min(MOST_RESAMPLES, 2 * TAIL / chance))
    return mean_interval(samples, chance, resamples)[0] > 0.0


def _sample(case: CaseBaseline, metric: str, sign: float) -> _Sample:
    known = [i for i, value in enumerate(case.metrics[metric]) if value is not None]
    values = np.array([case.metrics[metric][i] for i in known], dtype=float)
    return _Sample(sign * values, tuple(case.seeds[i] for i in known), tuple(case.numbers[i] for i in known))


def _only(sample: _Sample, seeds: list[int]) -> _Sample:
    """The sample of these seeds, in their order."""
    at = [sample.seeds.index(seed) for seed in seeds]
    return _Sample(sample.values[at], tuple(seeds), tuple(sample.numbers[i] for i in at))
