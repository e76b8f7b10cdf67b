"""Which figures a report has of each scenario, for whoever draws them: here, or in worker processes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from campaigns.finished import Finished
from reports.distribution_figure import MOST_ROWS, save_distribution_figure
from reports.errors_figure import save_errors_figure, unshown_groups
from reports.fitted import shortened
from reports.quantity import counted
from reports.scenario_cases import ScenarioRuns, scenario_runs
from reports.scenario_figure import save_scenario_figure
from reports.scenario_map import LOOKS
from reports.slug import slug

_NAMED = 60  # characters of a case's name


@dataclass(frozen=True, slots=True)
class Drawing:
    """A figure that is not drawn yet: `draw(runs, file, page)`, all of which can be sent to another process.

    `stem` is the name of its file without the ending, `caption` what stands under it.
    """

    stem: str
    caption: str
    draw: Callable[[ScenarioRuns, str | Path, bool], None]
    runs: ScenarioRuns


def scenario_figures(finished: Finished) -> list[tuple[ScenarioRuns, list[Drawing]]]:
    """Each scenario of a campaign with its figures: the map, the errors, and the trials where a case has several.

    A scenario on which nothing was flown has none.
    """
    return [
        (runs, _figures(runs, f"scenario-{i}-{slug(runs.name)}")) for i, runs in enumerate(scenario_runs(finished), 1)
    ]


def _figures(runs: ScenarioRuns, stem: str) -> list[Drawing]:
    if not runs.flown:
        return []
    figures = [
        Drawing(f"{stem}-map", map_caption(runs), save_scenario_figure, runs),
        Drawing(f"{stem}-errors", errors_caption(runs), save_errors_figure, runs),
    ]
    if any(run.result.case.trials > 1 for run in runs.runs):
        figures.append(Drawing(f"{stem}-trials", trials_caption(runs), save_distribution_figure, runs))
    return figures


def map_caption(runs: ScenarioRuns) -> str:
    """What the map shows, and what it leaves out."""
    worst = shortened(runs.flown[0][0].result.case.name, _NAMED)
    missing = len(runs.runs) - len(runs.flown)
    parts = [
        f"{runs.name}: the planned paths, the worst trial of every case as {runs.driven}, and from near the worst "
        f"place, of {worst}."
    ]
    if any(run.result.statistics.band is not None for run in runs.runs):
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
