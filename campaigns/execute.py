"""A campaign from its cases to its results: opened folder, plans, trials, statistics, the worst trials once more."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from campaigns.attempt import Attempt
from campaigns.campaign import Campaign
from campaigns.finished import Finished, shown, worst_tasks
from campaigns.folder import opened
from campaigns.lanes import Lanes
from campaigns.manifest import manifest_of, read_manifest
from campaigns.plan_statistics import planned_by
from campaigns.ready import ReadyCase
from campaigns.resolved import write_resolved
from campaigns.runner import Task, keep_track, outstanding, plan_all, replay_each, run_trials, track_file
from campaigns.search_ready import ReadySearch
from campaigns.searches import run_searches
from campaigns.summary import CaseResult, results_of, write_summary
from campaigns.workers import Workers
from planners.outside import OutsidePlanner
from tracking.outcome import Outcome

PLANNING = 60.0  # [s] for a worker beyond its planner's own time-out
TRIED = 12  # about as many as a search tries, each as long as a trial may take

Watch = Callable[[Iterable[tuple[Task, Attempt]], Sequence[Task], int], Iterable[Attempt]]


@dataclass(frozen=True, slots=True)
class Machines:
    """Where to run: `jobs` processes here, or the dask scheduler at `dask`."""

    jobs: int
    dask: str | None = None

    @contextmanager
    def lanes(self, timeout: float) -> Iterator[Lanes]:
        """An executor, let go of at the end; at once where the run is broken off."""
        lanes = self._lanes(timeout)
        try:
            yield lanes
        except BaseException:
            lanes.executor.shutdown(cancel_futures=True)
            raise
        lanes.executor.shutdown()

    def _lanes(self, timeout: float) -> Lanes:
        if self.dask is None:
            return Lanes(Workers(self.jobs, timeout), 2 * self.jobs)
        from campaigns.cluster import Cluster

        cluster = Cluster(self.dask, timeout)
        return Lanes(cluster, cluster.width)


def default_jobs() -> int:
    """As many as there are processors for this process."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def execute(
    campaign: Campaign,
    cases: Sequence[ReadyCase],
    folder: Path,
    machines: Machines,
    watch: Watch,
    fresh: bool = False,
    searches: Sequence[ReadySearch] = (),
) -> Finished:
    """Run what is missing in `folder`, and sum up.

    Raises `InputError` for a folder that cannot be taken, `TrackworthyError` where the disk fails.
    """
    with opened(folder, campaign, cases, fresh, searches) as store:
        write_resolved(campaign, cases, folder, searches)
        cases = planned(campaign, cases, folder)
        with machines.lanes(campaign.timeout) as lanes:
            tasks = outstanding(campaign, cases, store)
            for _ in watch(run_trials(campaign, tasks, store, folder, lanes), tasks, campaign.trials):
                pass
            results = results_of([ready.case for ready in cases], store)
            outcomes = dict(_worst(campaign, cases, results, folder, lanes))
        with machines.lanes(TRIED * campaign.timeout) as lanes:
            found = run_searches(searches, folder, lanes)
        plans = planned_by(cases, campaign.claims, folder)
        write_summary(campaign, results, folder / "summary.json", found, plans)
        manifest = read_manifest(folder / "manifest.json") or manifest_of(campaign, cases, searches)
        return Finished(campaign, folder, manifest, results, outcomes, found, plans)


def planned(campaign: Campaign, cases: Sequence[ReadyCase], folder: Path) -> Sequence[ReadyCase]:
    """Planners run on this machine, where the programs of those of others are; ours take no longer than a trial."""
    planners = [ready.inputs.planner for ready in cases if ready.plans]
    if not planners:
        return cases
    outside = [planner.timeout + PLANNING for planner in planners if isinstance(planner, OutsidePlanner)]
    own = [campaign.timeout] if len(outside) < len(planners) else []
    with Machines(default_jobs()).lanes(max(*outside, *own, 0.0)) as lanes:
        return plan_all(cases, folder, lanes)


def _worst(
    campaign: Campaign, cases: Sequence[ReadyCase], results: Sequence[CaseResult], folder: Path, lanes: Lanes
) -> Iterator[tuple[str, Outcome]]:
    """The worst trial of each case whole and by name, where it is `shown`; and their tracks kept if asked for."""
    keep = campaign.keep_tracks == "worst"
    names = shown(results)
    tasks = [task for task in worst_tasks(cases, results) if keep or task.ready.case.name in names]
    for task, outcome in replay_each(tasks, folder, lanes):
        if outcome is None:
            continue
        if keep and not track_file(folder, task.key).exists():
            keep_track(folder, task, outcome)
        if task.ready.case.name in names:
            yield task.ready.case.name, outcome
    if keep:
        _forget_others(folder, tasks)


def _forget_others(folder: Path, tasks: Sequence[Task]) -> None:
    """Remove tracks that were the worst of a shorter run."""
    kept = {task.key[:16] for task in tasks}
    for file in (folder / "tracks").glob("*.parquet"):
        if file.stem not in kept:
            file.unlink()
