"""The cases of which no trial can be replayed: why, and how to repeat them."""

from __future__ import annotations

from campaigns.campaign import replay_command
from campaigns.finished import SHOWN, Finished, shown
from campaigns.seeds import plan_seed
from campaigns.summary import ERROR, CaseResult
from reports.files.json_result import Json


def absent(finished: Finished) -> dict[str, Json]:
    """By the name of each case without a track: `why`, the `command` that repeats its worst trial or its first, and the
    `seed` that the plan was made with, "" where one was found.
    """
    whole = shown(finished.results)
    return {
        result.case.name: _told(result, finished, result.case.name in whole)
        for result in finished.results
        if result.case.name not in finished.outcomes
    }


def _told(result: CaseResult, finished: Finished, whole: bool) -> Json:
    case, found, worst = result.case, result.statistics, result.worst
    trial = worst.trial if worst else 1
    planned = worst is None and found.no_path > 0 and result.verdict != ERROR
    seed = str(plan_seed(finished.campaign.seed, case, trial if case.replan else None)) if planned else ""
    return {
        "why": _why(result, len(finished.results), whole),
        "seed": seed,
        "command": replay_command(finished.called, case.name, trial),
    }


def _why(result: CaseResult, cases: int, whole: bool) -> str:
    found = result.statistics
    if result.worst is not None and not whole:
        return (
            f"There is no replay: of {cases} cases the report shows {SHOWN} whole, those not as expected first, "
            "and this one is not among them. The command below repeats its worst trial."
        )
    if result.worst is not None:
        return "There is no replay: its track was not kept, and it could not be flown again by the same code."
    if result.verdict == ERROR:
        return f"There is no track to replay, as it failed to run: {found.first_error}"
    every = f" in any of {found.tried} trials" if found.tried > 1 else ""
    return f"There is no track to replay, as the planner found no path{every}: {found.no_path_reason}"
