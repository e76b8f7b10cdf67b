"""The figures of a case: its run, its fleet, and all its trials."""

from __future__ import annotations

from campaigns.summary import CaseResult
from reports.figures.drawing import Drawing
from reports.figures.fleet_figure import fleet_figure
from reports.figures.header import head_of, header_height
from reports.figures.track_figure import track_figure
from reports.figures.trials_figure import trials_figure, trials_head
from reports.words.fleet_words import member_name
from reports.words.trials_words import worst_name
from tracking.outcome import Outcome


def track_drawing(stem: str, outcome: Outcome, trial: str = "") -> Drawing:
    """The run; `trial` says which of its case it is, where there are several."""
    head = header_height(head_of(outcome, trial, member_name(outcome)))
    return Drawing(stem, track_figure, (outcome, True, trial), head=head)


def fleet_drawing(stem: str, outcome: Outcome, trial: str = "") -> Drawing | None:
    """The fleet under way, None for a vehicle that is alone."""
    if outcome.fleet is None:
        return None
    head = header_height(head_of(outcome, trial))
    return Drawing(f"{stem}-fleet", fleet_figure, (outcome, True, trial), head=head)


def trials_drawing(stem: str, result: CaseResult | None, outcome: Outcome) -> Drawing | None:
    """All trials, None where there are not several that could be tried; `outcome` is the worst one's."""
    if result is None or result.case.trials == 1 or result.statistics.band is None:
        return None
    return Drawing(f"{stem}-trials", trials_figure, (result, outcome), head=header_height(trials_head(result, outcome)))


def trial_name(result: CaseResult | None) -> str:
    """Which trial is shown, "" where there is but one."""
    return worst_name(result) if result is not None and result.case.trials > 1 else ""
