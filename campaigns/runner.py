"""Runs the cases of a campaign one after the other; a case that fails costs itself, not the campaign."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from campaigns.campaign import Campaign
from campaigns.case import Case, prepare
from planners.errors import TrackworthyError
from tracking.outcome import Outcome
from tracking.trial import Trial, run_trial


@dataclass(frozen=True, slots=True)
class Result:
    """What became of a case: its `outcome`, or the `error` in its place."""

    case: Case
    outcome: Outcome | None
    error: str = ""


def prepare_cases(campaign: Campaign) -> tuple[Trial, ...]:
    """Every case made ready; raises `InputError` if one of them cannot be."""
    return tuple(prepare(case, campaign.folder) for case in campaign.cases)


def run_cases(campaign: Campaign, trials: tuple[Trial, ...]) -> Iterator[Result]:
    """Run every case in order."""
    for case, trial in zip(campaign.cases, trials, strict=True):
        try:
            yield Result(case, run_trial(trial))
        except TrackworthyError as error:
            yield Result(case, None, str(error))
