"""Runs what is missing: plans, then trials, then the worst trial of each case once more, to be kept and drawn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns import plans
from campaigns.attempt import DIED, MACHINERY, Attempt, Job, attempt, replay
from campaigns.campaign import Campaign
from campaigns.lanes import Lanes
from campaigns.plans import Plan
from campaigns.ready import ReadyCase, seeds_of
from campaigns.store import Store
from campaigns.tracks import ends, to_parquet, whole_track
from campaigns.workers import WorkerDiedError
from planners.atomic_file import atomic
from planners.errors import TrackworthyError
from tracking.outcome import Outcome
from tracking.trial import Trial

TRIES = 2  # of a trial whose process died: it may have been killed for something else


@dataclass(frozen=True, slots=True)
class Task:
    """A trial to be tried: its number, seed and key within a case."""

    ready: ReadyCase
    trial: int
    seed: int
    key: str

    @property
    def labels(self) -> dict[str, str]:
        """What the file of its track says of where it comes from."""
        return {"case": self.ready.case.name, "trial": str(self.trial), "seed": str(self.seed), "key": self.key}


def plan_all(cases: Sequence[ReadyCase], folder: Path, lanes: Lanes) -> tuple[ReadyCase, ...]:
    """The cases with their paths, computed by planners where they are not in `folder` yet."""

    def send(executor: Executor, plan: Plan) -> Future[plans.Computed]:
        return executor.submit(plans.compute, plan)

    missing = plans.outstanding([plan for ready in cases for plan in ready.plans], folder)
    without = {}
    for plan, future in lanes.each(missing, send):
        try:
            computed = future.result()
        except TrackworthyError as error:
            computed = plans.Computed(error=f"the planner could not be run: {error}")
        plans.keep(plan, folder, computed)
        if computed.error:
            without[plan.key] = Attempt(0, error=computed.error, kind=computed.kind)
    return tuple(ready.with_paths_of(folder, without) for ready in cases)


def outstanding(campaign: Campaign, cases: Sequence[ReadyCase], store: Store) -> list[Task]:
    """The trials without a result; those that ended in an error are among them."""
    done = store.finished()
    every = (task for ready in cases for task in tasks_of(campaign, ready))
    return [task for task in every if task.key not in done]


def tasks_of(campaign: Campaign, ready: ReadyCase) -> Iterator[Task]:
    """Every trial of a case."""
    for trial, seed in enumerate(seeds_of(campaign, ready.case), start=1):
        yield Task(ready, trial, seed, ready.key(trial, seed))


def run_trials(
    campaign: Campaign, tasks: Sequence[Task], store: Store, folder: Path, lanes: Lanes
) -> Iterator[tuple[Task, Attempt]]:
    """Try every task, store what becomes of it, and pass it on."""
    send = _Sender(campaign.keep_tracks)
    waiting = list(tasks)
    for tries in range(1, TRIES + 1):
        again = []
        for task, future in lanes.each(waiting, send):
            result = _result(task, future)
            if result.kind == DIED and tries < TRIES:
                again.append(task)
                continue
            if result.track is not None:
                keep_track(folder, task, result.track)
            store.add(task.key, task.ready.case.name, task.trial, result)
            yield task, result
        waiting = again


class _Sender:
    """Sends tasks to workers; a plan is packed once for all trials that follow each other on it."""

    def __init__(self, keep: str) -> None:
        self._keep = keep
        self._packed: tuple[Trial | Attempt, Job | Attempt] | None = None

    def __call__(self, executor: Executor, task: Task) -> Future[Attempt]:
        flight = task.ready.flight(task.trial)
        if self._packed is None or self._packed[0] is not flight:
            self._packed = (flight, task.ready.job(task.trial))
        job = self._packed[1]
        if isinstance(job, Job):
            return executor.submit(attempt, job, task.seed, self._keep, task.labels)
        known: Future[Attempt] = Future()
        known.set_result(msgspec.structs.replace(job, seed=task.seed))
        return known


def _result(task: Task, future: Future[Attempt]) -> Attempt:
    try:
        return future.result()
    except WorkerDiedError as error:
        return Attempt(task.seed, error=str(error), kind=DIED)
    except TrackworthyError as error:
        return Attempt(task.seed, error=str(error), kind=MACHINERY)


def replay_each(
    tasks: Sequence[Task], folder: Path, lanes: Lanes, fly: bool = True
) -> Iterator[tuple[Task, Outcome | None]]:
    """The whole outcome of every task, as they finish, judged by its track in the results `folder`, or if there is none
    flown, unless `fly` says no.

    None for one that fails this time, or has no path.
    """
    jobs = ((task, task.ready.job(task.trial)) for task in tasks)
    flown = ((task, job) for task, job in jobs if isinstance(job, Job))

    def send(executor: Executor, one: tuple[Task, Job]) -> Future[Outcome]:
        task, job = one
        return executor.submit(replay, job, task.seed, track_file(folder, task.key), fly)

    for (task, _), future in lanes.each(flown, send):
        try:
            yield task, future.result()
        except TrackworthyError:
            yield task, None


def keep_track(folder: Path, task: Task, track: bytes | Outcome) -> None:
    """Store a track in the results `folder`, as the Parquet file it is or is made."""
    content = track if isinstance(track, bytes) else to_parquet(whole_track(track), task.labels | ends(track))
    file = track_file(folder, task.key)
    file.parent.mkdir(exist_ok=True)
    with atomic(file) as temporary:
        temporary.write_bytes(content)


def track_file(folder: Path, key: str) -> Path:
    """Where the track of the trial of that key lies in the results `folder`."""
    return folder / "tracks" / f"{key[:16]}.parquet"
