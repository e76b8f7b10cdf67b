"""Which figures a report has of a scenario."""

from __future__ import annotations

from reports.figures.distribution_figure import MOST_ROWS, distribution_figure
from reports.figures.drawing import Drawing
from reports.figures.errors_figure import errors_figure, unshown_groups
from reports.figures.fitted import shortened
from reports.figures.scenario_cases import ScenarioRuns
from reports.figures.scenario_figure import scenario_figure
from reports.figures.scenario_head import scenario_head_height
from reports.figures.scenario_map import LOOKS
from reports.words.quantity import counted

_NAMED = 60  # characters of a case's name


def scenario_figures(runs: ScenarioRuns, stem: str) -> list[Drawing]:
    """The figures of a scenario: the map, the errors, and the trials where a case has several; none where nothing was
    flown. Their names begin with `stem`.
    """
    if not runs.flown:
        return []
    head = scenario_head_height(runs)
    figures = [
        Drawing(f"{stem}-map", scenario_figure, (runs,), map_caption(runs), head),
        Drawing(f"{stem}-errors", errors_figure, (runs,), errors_caption(runs), head),
    ]
    if any(run.result.case.trials > 1 for run in runs.runs):
        figures.append(Drawing(f"{stem}-trials", distribution_figure, (runs,), trials_caption(runs), head))
    return figures


def map_caption(runs: ScenarioRuns) -> str:
    """What the map shows, and what it leaves out."""
    worst = shortened(runs.flown[0][0].result.case.name, _NAMED)
    missing = len(runs.runs) - len(runs.flown)
    parts = [
        f"{runs.name}: the planned paths, the worst trial of every case as {runs.driven}, and from near the worst "
        f"place, of {worst}."
    ]
    if runs.banded:
        parts.append(
            "Shaded: where 90 % of the trials are, to scale, where it is wider than a pixel and near the path."
        )
    if (others := len(runs.groups) - len(LOOKS)) > 0:
        parts.append(f"{others} more, less bad, are grey.")
    if missing:
        parts.append(f"{counted(missing, 'case')} without a track {'is' if missing == 1 else 'are'} not shown.")
    return " ".join(parts)


def errors_caption(runs: ScenarioRuns) -> str:
    """What the errors show, and what they leave out."""
    hidden = unshown_groups(runs)
    more = f" {hidden} more, less bad, are not shown." if hidden else ""
    return (
        f"{runs.name}: cross-track error along the path of the worst trial of each case, left positive, all on one "
        f"scale; below, what the worst of them asked of the vehicle.{more}"
    )


def trials_caption(runs: ScenarioRuns) -> str:
    """What the distributions show, and what they leave out."""
    hidden = len(runs.flown) - MOST_ROWS
    more = (
        f" {counted(hidden, 'more case')}, less bad, {'is' if hidden == 1 else 'are'} not shown." if hidden > 0 else ""
    )
    what = "every trial of each case, the worst case first, and how many of its trials are trackworthy."
    return f"{runs.name}: {what}{more}"
