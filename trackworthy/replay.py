"""`trackworthy run --case NAME --trial N`: one trial again, shown whole."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from campaigns.attempt import Attempt
    from campaigns.campaign import Campaign
    from campaigns.case import Case
    from campaigns.ready import ReadyCase


def replay_trial(campaign: Campaign, cases: Sequence[ReadyCase], trial: int, folder: Path) -> int:
    """Try it in this process, print every metric, save its picture and track, and answer with the exit code."""
    from campaigns.attempt import Attempt, replay
    from campaigns.execute import planned
    from campaigns.runner import keep_track, tasks_of
    from planners.errors import InputError
    from reports.figures.fleet_figure import save_fleet_figure
    from reports.figures.track_figure import save_track_figure
    from reports.terminal.table import print_outcome
    from trackworthy.streams import chatter_to_stderr, tell

    if len(cases) != 1:
        raise InputError("--trial", "it is a trial of one case", "name that with --case")
    if not 1 <= trial <= cases[0].case.trials:
        raise InputError("--trial", f"{trial} is no trial of {cases[0].case.name!r}", f"1 to {cases[0].case.trials}")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(str(folder), f"cannot be written to: {error.strerror}", "give another with -o") from error
    (ready,) = planned(campaign, [cases[0].only(trial)], folder)
    job = ready.job(trial)
    if isinstance(job, Attempt):
        return _without_flight(ready.case, job)
    task = list(tasks_of(campaign, ready))[trial - 1]
    with chatter_to_stderr():
        outcome = replay(job, task.seed)
    keep_track(folder, task, outcome)
    picture = folder / f"trial-{trial}.png"
    save_track_figure(outcome, picture)
    pictures = [picture]
    if outcome.fleet is not None:
        pictures.append(folder / f"trial-{trial}-fleet.png")
        save_fleet_figure(outcome, pictures[1])
    print_outcome(outcome)
    tell([f"saved {' and '.join(map(str, pictures))}, and its track in {folder / 'tracks'}"])
    return 0 if outcome.verdict.passed else 1


def _without_flight(case: Case, attempt: Attempt) -> int:
    """Tell that the planner found no path; raises `TrackworthyError` where it failed."""
    from campaigns.attempt import INPUT
    from planners.errors import InputError, TrackworthyError

    if attempt.error:
        raise InputError(case.name, attempt.error) if attempt.kind == INPUT else TrackworthyError(attempt.error)
    print(f"NOT TRACKWORTHY  {case.name}: no path to fly: {attempt.ended}")
    return 0 if attempt.passed else 1
