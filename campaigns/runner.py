"""Runs the cases of a campaign one after the other; a case that fails costs itself, not the campaign."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from dataclasses import dataclass

from campaigns.campaign import Campaign
from campaigns.case import Case, prepare
from planners.errors import TrackworthyError
from tracking.outcome import Outcome
from tracking.trial import run_trial


@dataclass(frozen=True, slots=True)
class Result:
    """What became of a case: its `outcome`, or the `error` in its place; `command` repeats it alone."""

    case: Case
    outcome: Outcome | None
    error: str
    command: str


def run_cases(campaign: Campaign) -> Iterator[Result]:
    """Run every case in order. Raises `InputError` before the first if one of them cannot be prepared."""
    prepared = [prepare(case, campaign.folder) for case in campaign.cases]
    for case, ready in zip(campaign.cases, prepared, strict=True):
        command = command_line(case)
        try:
            yield Result(case, run_trial(ready.trial), "", command)
        except TrackworthyError as error:
            yield Result(case, None, str(error), command)


def command_line(case: Case) -> str:
    """The command that repeats `case` alone, run in the folder of its campaign file."""
    default = Case(case.path, case.vehicle)
    options = ["controller", "speed", "altitude", "corridor", "wind", "scenario", "corners", "steering_hz", "expect"]
    words = ["trackworthy", "track", case.path, "--vehicle", case.vehicle]
    for option in options:
        value = getattr(case, option)
        if value != getattr(default, option):
            words += [f"--{option.replace('_', '-')}", str(value)]
    for limit in case.require:
        words += ["--require", limit]
    return shlex.join(words)
