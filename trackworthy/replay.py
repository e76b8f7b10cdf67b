"""`trackworthy run --case NAME --trial N`: one trial again, shown whole."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from campaigns.campaign import Campaign
    from campaigns.ready import ReadyCase


def replay_trial(campaign: Campaign, cases: Sequence[ReadyCase], trial: int, folder: Path) -> int:
    """Try it in this process, print every metric, save its picture and track, and answer with the exit code."""
    from campaigns.attempt import replay
    from campaigns.execute import planned
    from campaigns.runner import keep_track, tasks_of
    from planners.errors import InputError, TrackworthyError
    from reports.table import print_outcome
    from reports.track_figure import save_track_figure
    from trackworthy.streams import chatter_to_stderr, tell

    if len(cases) != 1:
        raise InputError("--trial", "it is a trial of one case", "name that with --case")
    if not 1 <= trial <= cases[0].case.trials:
        raise InputError("--trial", f"{trial} is no trial of {cases[0].case.name!r}", f"1 to {cases[0].case.trials}")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(str(folder), f"cannot be written to: {error.strerror}", "give another with -o") from error
    (ready,) = planned(cases, folder)
    if ready.error:
        raise TrackworthyError(ready.error)
    task = list(tasks_of(campaign, ready))[trial - 1]
    with chatter_to_stderr():
        outcome = replay(ready.job(), task.seed)
    keep_track(folder, task, outcome)
    picture = folder / f"trial-{trial}.png"
    save_track_figure(outcome, picture)
    print_outcome(outcome)
    tell([f"saved {picture} and its track in {folder / 'tracks'}"])
    return 0 if outcome.verdict.passed else 1
