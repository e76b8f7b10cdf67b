"""What a worker does: one trial, tried and boiled down to what is stored."""

from __future__ import annotations

import hashlib
import math
import pickle
from pathlib import Path

import msgspec
import numpy as np

from campaigns.conditions import ConditionKeys
from campaigns.prepare import seeded
from campaigns.tracks import ends, read_tracks, to_parquet, whole_track
from planners.errors import InputError, TrackworthyError
from tracking.metric import Margin, Metric
from tracking.outcome import Outcome
from tracking.profile import error_profile
from tracking.track import Track
from tracking.trial import Trial, run_trial
from tracking.verdict import TRACKWORTHY

INPUT, MACHINERY, DIED = "input", "machinery", "died"  # kinds of error; what died may live the next time


class Measured(msgspec.Struct, frozen=True):
    """A metric of one trial in SI units; None for a value that could not be measured, and for a place it has not."""

    value: float | None
    s: float | None
    t: float | None


class Attempt(msgspec.Struct, frozen=True):
    """What became of a trial: either an `error` of that `kind`, or all the rest.

    `score` is the margin of the requirement `decided_by`, relative to its limit: the smaller, the worse. `profile` is
    the cross-track error along the path (32-bit floats), empty where there was no path to fly, for the reason in
    `ended`; `track` a Parquet file if it is to be kept.
    """

    seed: int
    error: str = ""
    kind: str = ""
    trackworthy: bool = False
    passed: bool = False
    score: float = -math.inf
    decided_by: str = ""
    ended: str = ""
    metrics: dict[str, Measured] = {}
    units: dict[str, tuple[str, str]] = {}
    profile: bytes = b""
    track: bytes | None = None


class Job(msgspec.Struct, frozen=True):
    """A case as it is sent to workers: `digest` names the pickled trial and conditions, which are unpacked once."""

    digest: str
    pickled: bytes


def job_of(trial: Trial, conditions: ConditionKeys) -> Job:
    """`trial`, whose seeds are yet to come, ready to be sent."""
    pickled = pickle.dumps((trial, conditions), protocol=pickle.HIGHEST_PROTOCOL)
    return Job(hashlib.sha256(pickled).hexdigest(), pickled)


def attempt(job: Job, seed: int, keep: str, labels: dict[str, str]) -> Attempt:
    """Try the job's trial in the conditions of `seed`; what goes wrong is its result.

    `keep` says whether the track is wanted: "all", "failures", or not; `labels` go into its metadata.
    """
    try:
        outcome = replay(job, seed)
    except Exception as error:  # also a fault of ours, or of a library: it costs this trial
        return failed(error, seed)
    decisive = outcome.verdict.decisive
    wanted = keep == "all" or (keep == "failures" and not outcome.verdict.passed)
    return Attempt(
        seed,
        trackworthy=outcome.verdict.trackworthy,
        passed=outcome.verdict.passed,
        score=_score(decisive),
        decided_by=decisive.metric.name if decisive else "",
        ended=outcome.track.ended,
        metrics={name: _measured(metric) for name, metric in outcome.metrics.items()},
        units={name: (metric.unit, metric.better) for name, metric in outcome.metrics.items()},
        profile=error_profile(outcome).astype(np.float32).tobytes(),
        track=to_parquet(whole_track(outcome), labels | ends(outcome)) if wanted else None,
    )


def failed(error: Exception, seed: int = 0) -> Attempt:
    """What becomes of a trial that cannot be tried because of `error`."""
    if isinstance(error, TrackworthyError):
        return Attempt(seed, error=str(error), kind=INPUT if isinstance(error, InputError) else MACHINERY)
    return Attempt(seed, error=f"{type(error).__name__}: {error}", kind=MACHINERY)


def without_path(reason: str, expect: str) -> Attempt:
    """What becomes of a trial whose planner found no path: nothing is flown, and none of the way completed."""
    return Attempt(
        0,
        passed=expect != TRACKWORTHY,
        score=-1.0,
        decided_by="completion",
        ended=reason,
        metrics={"completion": Measured(0.0, None, None)},
        units={"completion": ("share", "higher")},
    )


def replay(job: Job, seed: int, track: Path | None = None, fly: bool = True) -> Outcome:
    """The whole outcome of the trial of that seed, judged by the file of its `track`, or if there is none flown.

    Raises what `run_trial` raises, and `InputError` where it may not `fly` and there is no such track.
    """
    trial, conditions = _unpacked(job)
    known: tuple[Track, ...] = ()
    if track is not None and (track.exists() or not fly):
        try:
            known = read_tracks(track)
        except InputError:  # it was damaged, and can be had again
            if not fly:
                raise
    return run_trial(seeded(trial, conditions, seed), known)


_JOBS: dict[str, tuple[Trial, ConditionKeys]] = {}
MOST_JOBS = 8


def _unpacked(job: Job) -> tuple[Trial, ConditionKeys]:
    if job.digest not in _JOBS:
        if len(_JOBS) >= MOST_JOBS:
            del _JOBS[next(iter(_JOBS))]
        _JOBS[job.digest] = pickle.loads(job.pickled)
    return _JOBS[job.digest]


def _score(decisive: Margin | None) -> float:
    return decisive.relative if decisive else math.inf


def _measured(metric: Metric) -> Measured:
    return Measured(_finite(metric.value) if metric.valid else None, _finite(metric.s), _finite(metric.t))


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
