"""The cases of a campaign that share a scenario: what the figures across cases are drawn from."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from campaigns.case import Case
from campaigns.summary import CaseResult
from planners.outside import OutsidePlanner
from reports.words.dimensions import scales, scenario_words
from reports.words.quantity import text
from reports.words.trials_words import case_conditions, planned_setting
from reports.words.words import KMH
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY


@dataclass(frozen=True, slots=True)
class Run:
    """A case with the `outcome` of its worst trial, None where none was flown.

    Its path is from a `source`, a planner or a file, and its `setting` tells it from others of the same source.
    """

    result: CaseResult
    outcome: Outcome | None
    source: str
    setting: str

    @property
    def badness(self) -> tuple[bool, bool, float, int]:
        """The smaller, the worse: first what is not as expected, then what is not trackworthy, then by its margin."""
        worst = self.result.worst
        score = math.inf if worst is None else worst.score
        return self.result.passed, self.result.verdict == TRACKWORTHY, score, self.result.number


@dataclass(frozen=True, slots=True)
class ScenarioRuns:
    """The `runs` of all cases on the scenario of that `name`, in the campaign's order."""

    name: str
    runs: tuple[Run, ...]

    @property
    def sources(self) -> tuple[str, ...]:
        """The planners and files of those with an outcome, in the order of their first cases."""
        return tuple(dict.fromkeys(run.source for run in self.runs if run.outcome is not None))

    @property
    def flown(self) -> list[tuple[Run, Outcome]]:
        """The cases with an outcome, worst first."""
        runs = sorted(self.runs, key=lambda run: run.badness)
        return [(run, run.outcome) for run in runs if run.outcome is not None]

    @property
    def groups(self) -> dict[str, list[tuple[Run, Outcome]]]:
        """Those with an outcome by what tells them apart best, the worst group and in it the worst case first: by
        source, or of one source by controller, or by all of their settings.
        """
        flown = self.flown
        keys: list[Callable[[Run, Outcome], str]] = [
            lambda run, outcome: run.source,
            lambda run, outcome: outcome.controller,
            lambda run, outcome: run.setting,
        ]
        groups: dict[str, list[tuple[Run, Outcome]]] = {}
        for key in keys:
            groups = {}
            for run, outcome in flown:
                groups.setdefault(key(run, outcome), []).append((run, outcome))
            if len(groups) > 1:
                break
        return groups

    @property
    def banded(self) -> bool:
        """Whether there are bands over trials."""
        return any(run.result.statistics.band is not None for run in self.runs)

    @property
    def driven(self) -> str:
        """ "driven" where all vehicles are on the ground, else "flown"."""
        grounded = [outcome.limits.kind == "ground" for _, outcome in self.flown]
        return "driven" if grounded and all(grounded) else "flown"


def scenario_runs(results: Sequence[CaseResult], outcomes: Mapping[str, Outcome]) -> list[ScenarioRuns]:
    """All cases of a campaign by scenario, each at its scale; cases without one by their path's file.

    `outcomes` are those of their worst trials, by the name of the case.
    """
    found = scales([result.case for result in results])
    groups: dict[tuple[str, str], list[Run]] = {}
    for result in results:
        case = result.case
        name = scenario_words(case, found) or Path(case.path).name
        run = Run(result, outcomes.get(case.name), source_of(case), "")
        groups.setdefault((name, case.planet or ""), []).append(run)
    return [ScenarioRuns(name, named(runs)) for (name, _), runs in groups.items()]


def source_of(case: Case) -> str:
    """The planner, or the file's name without its ending."""
    if isinstance(case.planner, OutsidePlanner):
        return case.planner.label
    return case.planner or Path(case.path).stem


def named(runs: Iterable[Run]) -> tuple[Run, ...]:
    """The runs with what tells each from the others of its source: what differs of vehicle, controller, speed and
    conditions, or the name of the case where that is not enough.
    """
    runs = list(runs)
    parts = [_parts(run) for run in runs]
    # Of what was not flown less is known, and that is no difference
    known = [part for run, part in zip(runs, parts, strict=True) if run.outcome is not None]
    differ = [i for i in range(len(parts[0])) if len({part[i] for part in known}) > 1]
    told = [" · ".join(filter(None, (part[i] for i in differ or (1, 2)))) for part in parts]
    count = Counter((run.source, words) for run, words in zip(runs, told, strict=True))
    return tuple(
        replace(run, setting=words if count[run.source, words] == 1 else run.result.case.name)
        for run, words in zip(runs, told, strict=True)
    )


def _parts(run: Run) -> tuple[str, str, str, str]:
    """Vehicle, controller, speed and the rest of the conditions."""
    outcome = run.outcome
    if outcome is None:
        return (*planned_setting(run.result), "")
    ground = outcome.limits.kind == "ground"
    speed = text(outcome.speed * KMH, "km/h") if ground else text(outcome.speed, "m/s")
    return outcome.vehicle, outcome.controller, speed, ", ".join(case_conditions(run.result, outcome)[1:])


def within_group(run: Run, group: str) -> str:
    """What tells `run` from others of its `group`: its setting without what the group is called."""
    return " · ".join(part for part in run.setting.split(" · ") if part != group) or run.setting
