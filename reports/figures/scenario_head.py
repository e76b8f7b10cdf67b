"""The head of a figure of all cases on a scenario."""

from __future__ import annotations

from matplotlib.figure import Figure

from reports.figures.fitted import shortened
from reports.figures.header import Head, draw_header, header_height
from reports.figures.scenario_cases import ScenarioRuns
from reports.words.quantity import counted
from reports.words.words import reason
from tracking.verdict import TRACKWORTHY

_NAMED = 60  # characters of a case's name
_VEHICLES = 3


def scenario_head_height(runs: ScenarioRuns) -> float:
    """The height of the head [in]."""
    return header_height(_head(runs))


def draw_scenario_head(figure: Figure, runs: ScenarioRuns) -> None:
    """Draw the head at the top of `figure`."""
    draw_header(figure, _head(runs))


def _head(runs: ScenarioRuns) -> Head:
    """How many of the cases are as expected, and why the worst of them is not trackworthy."""
    passed = sum(run.result.passed for run in runs.runs)
    good = sum(run.result.verdict == TRACKWORTHY for run in runs.runs)
    trials = sum(run.result.case.trials for run in runs.runs)
    vehicles = [shortened(name, 20) for name in dict.fromkeys(outcome.vehicle for _, outcome in runs.flown)]
    told = ", ".join(vehicles[:_VEHICLES])
    counts = [counted(len(runs.runs), "case"), counted(trials, "trial"), f"{good} trackworthy"]
    worst, outcome = runs.flown[0]
    return Head(
        runs.name,
        passed == len(runs.runs),
        f"{passed} of {len(runs.runs)} as expected",
        " · ".join([told, *counts]),
        f"worst: {shortened(worst.result.case.name, _NAMED)}: {reason(outcome)}",
    )
