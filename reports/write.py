"""The report of a campaign, in every form that is asked for."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path

from campaigns.baseline import Baseline, record_of
from campaigns.campaign import replay_command
from campaigns.finished import Finished
from campaigns.gate import Check, check
from campaigns.lanes import Lanes
from planners.errors import InputError
from planners.files.text import write_text
from reports.figures.drawing import Drawing, draw_all
from reports.files.junit import campaign_junit
from reports.files.summary_markdown import markdown, plots
from reports.html.page import write_html
from reports.html.pictures import pictured
from reports.pages.pdf import write_pdf
from reports.pages.pdf_plans import plan_sections
from reports.pages.report_data import Report, report_of

DRAWING = 300.0  # [s] that a figure, or a trial to be flown again, may take

# What each form is written to, within the results folder
FILES = {
    "pdf": "report.pdf", "html": "report.html", "png": "figures", "junit": "junit.xml", "md": "summary.md",
}  # fmt: skip
_WITH_PLANS = {"pdf", "html", "png"}  # forms that show plans, which are made again to be drawn


def write_report(
    finished: Finished,
    lanes: Lanes,
    forms: Collection[str] = tuple(FILES),
    paper: str = "a4",
    baseline: Baseline | None = None,
) -> list[Path]:
    """Write the `forms`, keys of `FILES`, into the campaign's folder; returns what was written.

    Figures are drawn in `lanes`. The results are held against a `baseline`, where there is one. The same results give
    the same bytes. Raises `InputError` or `TrackworthyError` for a file that cannot be written.
    """
    folder, figures = finished.folder, finished.folder / "figures"
    held = check(record_of(finished.campaign, finished.results, folder), baseline) if baseline else None
    report = campaign_report(finished, lanes, held, with_plans=bool(_WITH_PLANS & set(forms)))
    drawings = _needed(report, finished, forms)
    if drawings:
        if figures.is_file():
            raise InputError(str(figures), "is a file where the figures' folder belongs", "move it away")
        figures.mkdir(exist_ok=True)
        draw_all(drawings, figures, lanes)
    write: dict[str, Callable[[Path], None]] = {
        "pdf": lambda file: write_pdf(report, figures, file, paper),
        "html": lambda file: write_html(finished, report.data, file),
        "png": lambda file: None,
        "junit": lambda file: write_text(file, campaign_junit(finished, held)),
        "md": lambda file: write_text(file, markdown(finished, report, held)),
    }
    files = {form: folder / FILES[form] for form in forms}
    for form, file in files.items():
        write[form](file)
    return [*files.values()]


def campaign_report(finished: Finished, lanes: Lanes, held: Check | None = None, with_plans: bool = True) -> Report:
    """What there is to tell of a campaign, `held` against a baseline; plans to be drawn are made again in `lanes`."""
    campaign, results = finished.campaign, finished.results
    outcomes = [finished.outcomes[result.case.name] for result in results if result.case.name in finished.outcomes]
    worst = {result.case.name: result.worst.trial for result in results if result.worst}
    commands = [replay_command(finished.called, outcome.name, worst[outcome.name]) for outcome in outcomes]
    plans = plan_sections(finished.plans, results, campaign.note, lanes) if with_plans else []
    return report_of(
        outcomes, campaign.title, commands=commands, results=results, searches=finished.searches, plans=plans,
        manifest=finished.manifest, check=held, limits=campaign.check,
    )  # fmt: skip


def _needed(report: Report, finished: Finished, forms: Collection[str]) -> list[Drawing]:
    """The figures that the `forms` show."""
    if {"pdf", "png"} & set(forms):
        return report.drawings
    shown = set(plots(finished, report)) if "md" in forms else set()
    pages = set(pictured(report.data)) if "html" in forms else set()
    return [one for one in report.drawings if one.stem in shown or one.svg in pages]
