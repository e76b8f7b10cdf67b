"""The PDF's section on plans as data for its template: for each scenario a table and pictures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass

from campaigns.lanes import Lanes
from campaigns.plan_statistics import PlannedBy
from campaigns.summary import CaseResult
from planners.all_planners import plan_with
from planners.astar.heading_limits import LATERAL, STEP_TIME
from planners.planner import Plan
from planners.scenario import Scenario
from reports.figures.drawing import Drawing
from reports.figures.plan_pictures import plan_drawings
from reports.files.json_result import Json
from reports.pages.plan_rows import is_fleet, labels, limits, plan_row, yardsticks
from reports.words.quantity import number, text
from reports.words.slug import slug


@dataclass(frozen=True, slots=True)
class Section:
    """The plans on one scenario: a line `about` it, the rows of its table, a note under them, and pictures.

    `cases` are the names of those that follow its plans.
    """

    scenario: str
    about: str
    rows: list[Json]
    note: str
    pictures: list[Drawing]
    fleet: bool = False
    cases: tuple[str, ...] = ()


def plan_sections(plans: Sequence[PlannedBy], results: Sequence[CaseResult], note: str, lanes: Lanes) -> list[Section]:
    """A section a scenario; of one at several scales, with the pictures of one scale, whose plans are made again in
    `lanes`.

    The `note` stands under the first table with claims, or else under the first.
    """
    scenarios = list(dict.fromkeys(one.scenario for one in plans))
    groups = [[one for one in plans if one.scenario is scenario] for scenario in scenarios]
    noted = next((i for i, group in enumerate(groups) if any(one.claims for one in group)), 0)
    drawn = _drawn(groups)
    sections = []
    for i, (scenario, group) in enumerate(zip(scenarios, groups, strict=True)):
        named = dict(zip(labels(group), group, strict=True))
        rows: list[Json] = [plan_row(one, name, results) for name, one in named.items()]
        stem = f"plans-{i + 1}-{slug(scenario.name)}"
        pictures = plan_drawings(named, planned(named, lanes), stem) if i in drawn else []
        told = " ".join(filter(None, [_explained(group), note if i == noted else ""]))
        several = sum(one.name == scenario.name for one in scenarios) > 1
        name = f"{scenario.name} at {text(scenario.unit, 'm')} a unit" if several else scenario.name
        cases = tuple(case for one in group for case in one.cases)
        sections.append(Section(name, _about(scenario, group), rows, told, pictures, is_fleet(scenario), cases))
    return sections


def planned(plans: Mapping[str, PlannedBy], lanes: Lanes) -> dict[str, Plan]:
    """The first plan of each of `plans` whose planner did not fail, made again in `lanes`."""

    def send(executor: Executor, name: str) -> Future[Plan]:
        return executor.submit(plan_with, plans[name].planner, plans[name].scenario, seeds[name])

    seeds = {name: one.seed for name, one in plans.items() if one.seed is not None}
    found = {name: future.result() for name, future in lanes.each(seeds, send)}
    return {name: found[name] for name in seeds}


def _drawn(groups: Sequence[Sequence[PlannedBy]]) -> set[int]:
    """Which groups are drawn: of each scenario the scale with the most plans, as they look the same at any."""
    count = {i: sum(one.statistics.seeds for one in group) for i, group in enumerate(groups)}
    names = [group[0].scenario.name for group in groups]
    return {max((i for i in count if names[i] == name), key=lambda i: count[i]) for name in names}


def section_data(section: Section) -> dict[str, Json]:
    """The section as `report.typ` reads it."""
    return {
        "scenario": section.scenario,
        "cases": [*section.cases],
        "about": section.about,
        "rows": section.rows,
        "fleet": section.fleet,
        "note": section.note,
        "pictures": [{"file": one.svg, "caption": one.caption} for one in section.pictures],
    }


def _explained(plans: Sequence[PlannedBy]) -> str:
    """What the column of what plans need says, where there is one."""
    if all(one.driven_at is None for one in plans):
        return ""
    return (
        f"Needs: lateral acceleration, red over {number(LATERAL)} g; of what is claimed, that of an arc which turns so "
        f"far in {number(STEP_TIME)} s."
    )


def _about(scenario: Scenario, plans: Sequence[PlannedBy]) -> str:
    """The map's scale, and the yardstick."""
    width, height = (side / scenario.unit for side in scenario.size)
    scale = f"{width:g} × {height:g} map units of {text(scenario.unit, 'm')}"
    exact = yardsticks(plans)
    what = "sum" if is_fleet(scenario) else "path"
    line = plans[0].straight
    straight = "" if line is None else f"straight line {number(line / scenario.unit, 6)} map units"
    parts = [scale, f"exact shortest {what} {exact}" if exact else "", straight, limits(scenario)]
    return "; ".join(filter(None, parts))
