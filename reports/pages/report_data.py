"""All that a report says, in words and tables, and the figures beside it: what the PDF and the HTML both show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from campaigns.gate import Check
from campaigns.limits import Limit
from campaigns.manifest import Manifest
from campaigns.searches import SearchResult
from campaigns.summary import CaseResult
from reports.figures.case_drawings import fleet_drawing, track_drawing, trial_name, trials_drawing
from reports.figures.drawing import Drawing
from reports.figures.scenario_cases import scenario_runs
from reports.figures.scenario_pictures import scenario_figures
from reports.files.json_result import Json
from reports.pages.appendix import appendix_data
from reports.pages.check_data import check_data
from reports.pages.front_page import front_data
from reports.pages.matrix import matrix_data
from reports.pages.pdf_case import case_data
from reports.pages.pdf_plans import Section, section_data
from reports.pages.pdf_rows import counts, summary_rows
from reports.pages.pdf_trials import trials_data
from reports.pages.scenario_data import scenarios_data
from reports.pages.versus_section import versus_section
from reports.words.search_words import search_tables
from reports.words.slug import slug
from tracking.outcome import Outcome


@dataclass(frozen=True, slots=True)
class Report:
    """What is told, as `data` that is all words and numbers, with its `cases`, and `drawings` whose files it names."""

    data: dict[str, Json]
    cases: list[dict[str, Json]]
    drawings: list[Drawing]


def report_of(
    outcomes: Sequence[Outcome],
    title: str,
    *,
    subtitle: str = "",
    commands: Sequence[str] = (),
    results: Sequence[CaseResult] = (),
    searches: Sequence[SearchResult] = (),
    plans: Sequence[Section] = (),
    manifest: Manifest | None = None,
    check: Check | None = None,
    limits: Mapping[str, Limit] | None = None,
) -> Report:
    """The report on `outcomes` under `title`.

    `commands` says how to repeat each of `outcomes`, in their order; it may be shorter. For a campaign, `results` are
    its cases, and an outcome is the worst trial of the case of its name; without them every outcome is a case.
    `searches` are what its searches found, `plans` what is told of its planners' plans, `manifest` what made them,
    `check` what became of a baseline, and `limits` what the campaign's own gate allows.
    """
    by_name = {result.case.name: result for result in results}
    pages = {outcome.name: number for number, outcome in enumerate(outcomes)}
    told = [
        _case(outcome, number, by_name.get(outcome.name), commands[number] if number < len(commands) else "")
        for number, outcome in enumerate(outcomes)
    ]
    rows = summary_rows(outcomes, results, pages)
    cases = [case for case, _ in told]
    by_case = {outcome.name: outcome for outcome in outcomes}
    overview, across = _overview(results, by_case, searches, plans, manifest, limits or {})
    data: dict[str, Json] = {
        "title": title, "subtitle": subtitle, **counts(rows), "rows": [*rows], "cases": [*cases],
        "searches": search_tables(searches), "plans": [section_data(section) for section in plans],
        **overview, **({"check": check_data(check)} if check else {}),
    }  # fmt: skip
    drawings = [drawing for _, own in told for drawing in own]
    pictures = [picture for section in plans for picture in section.pictures]
    return Report(data, cases, [*drawings, *across, *pictures])


def _overview(
    results: Sequence[CaseResult],
    outcomes: Mapping[str, Outcome],
    searches: Sequence[SearchResult],
    plans: Sequence[Section],
    manifest: Manifest | None,
    limits: Mapping[str, Limit],
) -> tuple[dict[str, Json], list[Drawing]]:
    """What stands about a campaign's cases: before them, between those of a scenario, and after them; with figures."""
    if not results and not searches:
        return {}, []
    sections = {case: section_data(section) for section in plans for case in section.cases}
    scenarios = scenario_runs(results, outcomes)
    # Of one case there is nothing to see across cases.
    stems = [f"scenario-{number}-{slug(one.name)}" for number, one in enumerate(scenarios, start=1)]
    pairs = zip(scenarios, stems, strict=True)
    figures = [scenario_figures(one, stem) if len(one.runs) > 1 else [] for one, stem in pairs]
    versus, beside = versus_section(results, limits)
    told: dict[str, Json] = {
        "front": front_data(results, outcomes, searches, *(manifest.called, manifest.command) if manifest else ()),
        "matrix": matrix_data(results, outcomes),
        "scenarios": [*scenarios_data(scenarios, sections, figures, versus)],
        "appendix": appendix_data(results, outcomes, manifest),
    }
    return told, [one for own in figures for one in own] + beside


def _case(
    outcome: Outcome, number: int, result: CaseResult | None, command: str
) -> tuple[dict[str, Json], list[Drawing]]:
    """What is told of a case, with its figures."""
    stem = f"{number + 1 if result is None else result.number}-{slug(outcome.name)}"
    which = trial_name(result)
    track, fleet = track_drawing(stem, outcome, which), fleet_drawing(stem, outcome, which)
    trials = trials_drawing(stem, result, outcome)
    told = case_data(outcome, track.svg, fleet.svg if fleet else "", command)
    several = result is not None and result.case.trials > 1
    over = trials_data(result, outcome, trials.svg if trials else "") if several and result else None
    return {**told, "trials": over}, [one for one in (track, fleet, trials) if one]
