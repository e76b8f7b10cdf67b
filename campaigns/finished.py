"""A campaign that has been run: all there is to show of it, at once or again from its folder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from campaigns.campaign import Campaign, load_campaign
from campaigns.lanes import Lanes
from campaigns.manifest import Manifest, fingerprint, read_manifest
from campaigns.plan_statistics import PlannedBy, planned_by
from campaigns.ready import ReadyCase, make_ready
from campaigns.resolved import RESOLVED
from campaigns.runner import Task, replay_each
from campaigns.search_ready import make_searches_ready
from campaigns.searches import SearchResult, stored_searches
from campaigns.store import Store
from campaigns.summary import CaseResult, results_of
from planners.errors import InputError
from tracking.metric import SCHEMA_VERSION
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
        """The campaign as a command names it."""
        return self.manifest.called or str(self.folder / RESOLVED)

    @property
    def other_code(self) -> bool:
        """Whether another version of trackworthy or its libraries made the results."""
        return self.manifest.code != fingerprint()


def read_finished(folder: Path, lanes: Lanes) -> Finished:
    """What lies in a results `folder`. Raises `InputError` where there are no results, or not all.

    Outcomes are judged by their tracks. One whose track was not kept is flown again, by the same code only.
    """
    manifest, campaign = read_campaign(folder)
    cases = [ready.with_paths_of(folder, {}) for ready in make_ready(campaign)]
    results = read_results(campaign, folder)
    names = shown(results)
    tasks = [task for task in worst_tasks(cases, results) if task.ready.case.name in names]
    replayed = replay_each(tasks, folder, lanes, fly=manifest.code == fingerprint())
    outcomes = {
        task.ready.case.name: _with_notes(outcome, manifest) for task, outcome in replayed if outcome is not None
    }
    searches = stored_searches(make_searches_ready(campaign), folder)
    plans = planned_by(cases, campaign.claims, folder)
    return Finished(campaign, folder, manifest, results, outcomes, searches, plans)


def read_campaign(folder: Path) -> tuple[Manifest, Campaign]:
    """What made the results in `folder`, and the campaign that they are of; raises `InputError` for no results."""
    if folder.is_file():
        raise InputError(str(folder), "is a file", "give the folder of a campaign's results")
    manifest = read_manifest(folder / "manifest.json")
    if manifest is None or not (folder / RESOLVED).exists():
        raise InputError(str(folder), "holds no results", "run a campaign first: trackworthy run ... -o DIR")
    if manifest.schema_version != SCHEMA_VERSION:
        what = f"its metrics have schema {manifest.schema_version}, those of this version {SCHEMA_VERSION}"
        raise InputError(str(folder), what, "run the campaign again")
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


def _with_notes(outcome: Outcome, manifest: Manifest) -> Outcome:
    """With the notes of the run: a campaign that is written out states what its files had said."""
    return replace(outcome, notes=tuple(manifest.notes.get(outcome.name, outcome.notes)))


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
