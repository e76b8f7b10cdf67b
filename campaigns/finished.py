"""A campaign that has been run: all there is to show of it, at once or again from its folder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from campaigns.campaign import Campaign, load_campaign
from campaigns.lanes import Lanes
from campaigns.manifest import Manifest, fingerprint, read_manifest
from campaigns.plan_statistics import PlannedBy, planned_by
from campaigns.ready import ReadyCase, make_ready
from campaigns.resolved import RESOLVED
from campaigns.runner import Task, replay_each, track_file
from campaigns.search_ready import make_searches_ready
from campaigns.searches import SearchResult, stored_searches
from campaigns.store import Store
from campaigns.summary import CaseResult, results_of
from planners.errors import InputError
from tracking.outcome import Outcome

SHOWN = 100  # cases whose worst trial is given whole, those not as expected first


@dataclass(frozen=True, slots=True)
class Finished:
    """A campaign, what made its results in `folder`, and the results in the order of its cases.

    `outcomes` holds the whole outcome of the worst trial of the first `SHOWN` cases by name, `searches` what the
    searches found, `plans` what the planners of ours did.
    """

    campaign: Campaign
    folder: Path
    manifest: Manifest
    results: list[CaseResult]
    outcomes: dict[str, Outcome]
    searches: list[SearchResult]
    plans: list[PlannedBy]

    @property
    def called(self) -> str:
        """The campaign as a command names it, to run it again."""
        return self.manifest.called or str(self.folder / RESOLVED)


def read_finished(folder: Path, lanes: Lanes) -> Finished:
    """What lies in a results `folder`. Raises `InputError` where there are no results, or not all.

    Outcomes are judged by their tracks. One whose track was not kept is flown again, by the same code only.
    """
    manifest, campaign = read_campaign(folder)
    cases = [ready.with_paths_of(folder, {}) for ready in make_ready(campaign)]
    results = read_results(campaign, folder)
    names, same = shown(results), manifest.code == fingerprint()
    tasks = [
        task for task in worst_tasks(cases, results)
        if task.ready.case.name in names and (same or track_file(folder, task.key).exists())
    ]  # fmt: skip
    replayed = replay_each(tasks, folder, lanes)
    outcomes = {task.ready.case.name: outcome for task, outcome in replayed if outcome is not None}
    searches = stored_searches(make_searches_ready(campaign), folder)
    plans = planned_by(cases, campaign.claims, folder)
    return Finished(campaign, folder, manifest, results, outcomes, searches, plans)


def read_campaign(folder: Path) -> tuple[Manifest, Campaign]:
    """What made the results in `folder`, and the campaign that they are of; raises `InputError` for no results."""
    manifest = read_manifest(folder / "manifest.json")
    if manifest is None or not (folder / RESOLVED).exists():
        raise InputError(str(folder), "holds no results", "run a campaign first: trackworthy run ... -o DIR")
    return manifest, load_campaign(str(folder / RESOLVED))


def read_results(campaign: Campaign, folder: Path) -> list[CaseResult]:
    """The results of `campaign` in `folder`; raises `InputError` where some are missing."""
    store = Store(folder / "results.sqlite", read_only=True)
    try:
        results = results_of(campaign.cases, store)
    finally:
        store.close()
    for result in results:
        done = result.statistics.tried + result.statistics.errors
        if done < result.case.trials:
            what = f"{done} of {result.case.trials} trials of {result.case.name!r} are done"
            raise InputError(str(folder), what, "run the campaign to its end first")
    return results


def shown(results: Sequence[CaseResult]) -> set[str]:
    """The names of the cases whose worst trial is given whole."""
    return {result.case.name for result in sorted(results, key=lambda one: (one.passed, one.number))[:SHOWN]}


def worst_tasks(cases: Sequence[ReadyCase], results: Sequence[CaseResult]) -> list[Task]:
    """The worst trial of each case that has one."""
    return [
        Task(ready, worst.trial, worst.seed, ready.key(worst.trial, worst.seed))
        for ready, result in zip(cases, results, strict=True)
        if (worst := result.worst)
    ]
