"""What many trials of one case say: shares with their uncertainty, quantiles, and bands along the path."""

from __future__ import annotations

import zlib
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy.stats import binomtest

from campaigns.store import Row
from planners.kernel import Bools, Floats
from tracking.profile import PIECES

CONFIDENCE = 0.95
RESAMPLES = 200


@dataclass(frozen=True, slots=True)
class Summary:
    """A metric over trials: `worst` in its own direction, met first in the trial `worst_trial`; SI units."""

    median: float
    p95: float
    worst: float
    worst_trial: int
    count: int


@dataclass(frozen=True, slots=True)
class Band:
    """Cross-track error along the path (P,) [m]: the steady `bias` is the mean over trials at each place, `spread` the
    standard deviation about it; `median` of abs(e) with the bootstrap interval `low` to `high` of that median. Of the
    signed errors of the trials, 90 % lie between `p5` and `p95`.
    """

    bias: Floats
    spread: Floats
    median: Floats
    low: Floats
    high: Floats
    p5: Floats
    p95: Floats


@dataclass(frozen=True, slots=True)
class CaseStatistics:
    """All of a case: `share` of the trials that are trackworthy with its Clopper-Pearson interval, metrics by name.

    `values` (T, M) holds every metric of every trial without error, NaN where one could not be measured, in the order
    of `names`; `seeds` and `trials` (T,) tell whose they are, `worthy` (T,) which of them are trackworthy, and `flown`
    (T,) which of them had a path: a trial whose planner found none, for a reason as in `no_path_reason`, is tried and
    not trackworthy, and has nothing to measure but its completion. `bias` and `spread` [m] are those of the whole path,
    `kinds` those of the errors. `worst` is the trial that missed by most, or came closest to it, of those that were
    flown.
    """

    tried: int
    errors: int
    trackworthy: int
    passed: int
    interval: tuple[float, float]
    names: tuple[str, ...]
    values: Floats
    seeds: tuple[int, ...]
    trials: tuple[int, ...]
    worthy: Bools
    flown: Bools
    no_path_reason: str
    metrics: dict[str, Summary]
    band: Band | None
    bias: float
    spread: float
    first_error: str
    kinds: frozenset[str]
    worst: Row | None

    @property
    def share(self) -> float:
        """Share of the trials without error that are trackworthy."""
        return self.trackworthy / self.tried if self.tried else 0.0

    @property
    def no_path(self) -> int:
        """How many trials had no path."""
        return self.tried - int(np.count_nonzero(self.flown))


def statistics(rows: Iterable[Row], better: dict[str, str]) -> CaseStatistics:
    """The statistics of a case's rows; `better` tells each metric's direction."""
    names: list[str] = []
    values, profiles = [], []
    seeds, trials, worthy, flown = [], [], [], []
    passed = errors = 0
    first_error = no_path_reason = ""
    kinds = set()
    worst: Row | None = None
    for row in rows:
        if row.error:
            errors += 1
            kinds.add(row.kind)
            first_error = first_error or row.error
            continue
        names += (name for name in row.metrics if name not in names)
        found = (row.metrics.get(name) for name in names)
        values.append(np.array([np.nan if m is None or m.value is None else m.value for m in found]))
        seeds.append(row.seed)
        trials.append(row.trial)
        flown.append(row.flown)
        worthy.append(row.trackworthy)
        passed += row.passed
        if not row.flown:
            no_path_reason = no_path_reason or row.ended
            continue
        profiles.append(np.frombuffer(row.profile, np.float32))
        if worst is None or _badness(row) < _badness(worst):
            worst = row
    tried = len(trials)
    table = np.full((tried, len(names)), np.nan)
    for i, row_values in enumerate(values):
        table[i, : len(row_values)] = row_values
    laid = np.array(profiles, dtype=float).reshape(len(profiles), PIECES)
    metrics = {
        name: _summary(table[:, i], trials, better.get(name, "lower"))
        for i, name in enumerate(names)
        if np.isfinite(table[:, i]).any()
    }
    return CaseStatistics(
        tried=tried,
        errors=errors,
        trackworthy=sum(worthy),
        passed=passed,
        interval=clopper_pearson(sum(worthy), tried),
        names=tuple(names),
        values=table,
        seeds=tuple(seeds),
        trials=tuple(trials),
        worthy=np.array(worthy, dtype=bool),
        flown=np.array(flown, dtype=bool),
        no_path_reason=no_path_reason,
        metrics=metrics,
        band=error_band(laid) if len(laid) > 1 else None,
        bias=float(laid.mean()) if len(laid) else 0.0,
        spread=float(laid.std()) if len(laid) else 0.0,
        first_error=first_error,
        kinds=frozenset(kinds),
        worst=worst,
    )


def _badness(row: Row) -> tuple[bool, float, int]:
    """The smaller, the worse: first what is not trackworthy, then by the margin that decides, then the first."""
    return row.trackworthy, row.score, row.trial


def clopper_pearson(successes: int, tries: int) -> tuple[float, float]:
    """The exact 95 % interval of a share (Clopper and Pearson 1934); from 0 to 1 without tries."""
    if tries == 0:
        return 0.0, 1.0
    interval = binomtest(successes, tries).proportion_ci(CONFIDENCE, method="exact")
    return float(interval.low), float(interval.high)


def error_band(profiles: Floats) -> Band:
    """The band of `profiles` (T, P) [m], signed errors of T trials; its bootstrap resamples trials (Efron 1979)."""
    size = np.abs(profiles)
    rng = np.random.default_rng(zlib.crc32(np.ascontiguousarray(size).tobytes()))
    count = len(size)
    medians = np.array([np.median(size[rng.integers(0, count, count)], axis=0) for _ in range(RESAMPLES)])
    edge = 100 * (1.0 - CONFIDENCE) / 2
    low, high = np.percentile(medians, [edge, 100 - edge], axis=0)
    p5, p95 = np.percentile(profiles, [5, 95], axis=0)
    return Band(profiles.mean(axis=0), profiles.std(axis=0), np.median(size, axis=0), low, high, p5, p95)


def _summary(values: Floats, trials: list[int], better: str) -> Summary:
    """`better` "neither" makes the largest size the worst."""
    known = np.isfinite(values)
    badness = {"lower": values, "higher": -values}.get(better, np.abs(values))
    worst = int(np.argmax(np.where(known, badness, -np.inf)))
    finite = values[known]
    if (better == "neither" and np.median(finite) < 0.0) or better == "higher":
        p95 = float(np.percentile(finite, 5))  # the bad end
    else:
        p95 = float(np.percentile(finite, 95))
    return Summary(float(np.median(finite)), p95, float(values[worst]), trials[worst], int(known.sum()))
