"""What is shown across the cases of a campaign: figures of each scenario, and cases that differ in one thing only."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from campaigns.finished import Finished
from reports.drawing import Drawing
from reports.scenario_cases import scenario_runs
from reports.scenario_pictures import scenario_figures
from reports.slug import slug
from reports.versus_section import versus_section
from reports.versus_words import Table


@dataclass(frozen=True, slots=True)
class Across:
    """`figures` of a scenario by the name of each of its cases, and the tables of `versus` with their `drawings`."""

    figures: dict[str, list[Drawing]] = field(default_factory=dict)
    versus: list[Table] = field(default_factory=list)
    drawings: list[Drawing] = field(default_factory=list)

    def versus_of(self, cases: Sequence[str]) -> list[Table]:
        """The tables about `cases`."""
        return [table for table in self.versus if table["blocks"][0]["rows"][0]["case"] in cases]


def across_cases(finished: Finished) -> Across:
    """Of scenarios with several cases; what there is to say of one alone is on its own page."""
    figures: dict[str, list[Drawing]] = {}
    for number, runs in enumerate(scenario_runs(finished), start=1):
        if len(runs.flown) > 1:
            drawn = scenario_figures(runs, f"scenario-{number}-{slug(runs.name)}")
            figures |= {run.result.case.name: drawn for run in runs.runs}
    versus, drawings = versus_section(finished.results, finished.campaign.check)
    each = {id(one): one for drawn in figures.values() for one in drawn}
    return Across(figures, versus, [*each.values(), *drawings])
