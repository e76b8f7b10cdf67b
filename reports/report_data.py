"""All that a report says, in words and tables, and the figures beside it: what the PDF and the HTML both show."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from campaigns.searches import SearchResult
from campaigns.summary import CaseResult
from reports.case_drawings import fleet_drawing, track_drawing, trial_name, trials_drawing
from reports.drawing import Drawing
from reports.json_result import Json
from reports.pdf_case import case_data
from reports.pdf_plans import Section, section_data
from reports.pdf_rows import counts, summary_rows
from reports.pdf_trials import trials_data
from reports.search_words import search_tables
from reports.slug import slug
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
) -> Report:
    """The report on `outcomes` under `title`.

    `commands` says how to repeat each of `outcomes`, in their order; it may be shorter. For a campaign, `results` are
    its cases, and an outcome is the worst trial of the case of its name; without them every outcome is a case.
    `searches` are what its searches found, `plans` what is told of its planners' plans.
    """
    by_name = {result.case.name: result for result in results}
    pages = {outcome.name: number for number, outcome in enumerate(outcomes)}
    told = [
        _case(outcome, number, by_name.get(outcome.name), commands[number] if number < len(commands) else "")
        for number, outcome in enumerate(outcomes)
    ]
    rows = summary_rows(outcomes, results, pages)
    cases = [case for case, _ in told]
    data: dict[str, Json] = {
        "title": title, "subtitle": subtitle, **counts(rows), "rows": [*rows], "cases": [*cases],
        "searches": search_tables(searches), "plans": [section_data(section) for section in plans],
    }  # fmt: skip
    drawings = [drawing for _, own in told for drawing in own]
    return Report(data, cases, drawings + [picture for section in plans for picture in section.pictures])


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
