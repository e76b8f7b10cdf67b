"""The report as a PDF: one page that answers the question, then a page for every case, two for one of many trials."""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path

from campaigns.searches import SearchResult
from campaigns.summary import CaseResult
from planners.atomic_file import atomic
from reports.json_result import Json
from reports.pdf_case import case_data
from reports.pdf_plans import Section, section_data
from reports.pdf_rows import counts, summary_rows
from reports.pdf_trials import trials_data
from reports.search_words import search_tables
from tracking.outcome import Outcome

_TEMPLATE = Path(__file__).with_name("report.typ")
# Scripts that the fonts bundled with typst write; others need the machine's fonts.
_BUNDLED = ((0x0000, 0x024F), (0x0370, 0x052F), (0x1E00, 0x22FF), (0x25A0, 0x27BF))


def write_pdf(
    outcomes: Sequence[Outcome],
    file: str | Path,
    title: str,
    *,
    subtitle: str = "",
    commands: Sequence[str] = (),
    results: Sequence[CaseResult] = (),
    searches: Sequence[SearchResult] = (),
    plans: Sequence[Section] = (),
) -> None:
    """Write the report on `outcomes` under `title`: the same outcomes give the same bytes.

    `commands` says how to repeat each of `outcomes`, in their order; it may be shorter. For a campaign, `results` are
    its cases, and an outcome is the worst trial of the case of its name; without them every outcome is a case.
    `searches` are what its searches found, `plans` what is told of its planners' plans. The file appears whole or not
    at all. Raises `InputError` where its folder does not exist, `TrackworthyError` where typst fails.
    """
    with tempfile.TemporaryDirectory(prefix="trackworthy-pdf-") as folder, atomic(file) as temporary:
        temporary.write_bytes(_compiled(outcomes, Path(folder), title, subtitle, commands, results, searches, plans))


def _compiled(
    outcomes: Sequence[Outcome],
    folder: Path,
    title: str,
    subtitle: str,
    commands: Sequence[str],
    results: Sequence[CaseResult],
    searches: Sequence[SearchResult],
    plans: Sequence[Section],
) -> bytes:
    import typst

    from planners.errors import TrackworthyError
    from reports.fleet_figure import save_fleet_figure
    from reports.track_figure import save_track_figure

    several = {result.case.name: result for result in results if result.case.trials > 1}
    pages = {outcome.name: number for number, outcome in enumerate(outcomes)}
    cases: list[Json] = []
    for number, outcome in enumerate(outcomes):
        figure, result = f"case-{number}.svg", several.get(outcome.name)
        save_track_figure(outcome, folder / figure, page=True)
        fleet_figure = f"fleet-{number}.svg" if outcome.fleet else ""
        if fleet_figure:
            save_fleet_figure(outcome, folder / fleet_figure, page=True)
        case = case_data(outcome, figure, fleet_figure, commands[number] if number < len(commands) else "")
        cases.append({**case, "trials": None if result is None else _trials(result, outcome, folder, number)})
    rows = summary_rows(outcomes, results, pages)
    told = {
        "title": title, "subtitle": subtitle, **counts(rows), "rows": [*rows], "cases": cases,
        "searches": search_tables(searches),
        "plans": [_plans(section, folder, number) for number, section in enumerate(plans)],
    }  # fmt: skip
    data = json.dumps(told, ensure_ascii=False)
    # Text reaches typst as data only: nothing a user named can become markup or code.
    (folder / "report.json").write_text(data, encoding="utf-8")
    (folder / "report.typ").write_bytes(_TEMPLATE.read_bytes())
    try:
        pdf = typst.compile(
            str(folder / "report.typ"),
            root=str(folder),
            format="pdf",
            font_paths=[],
            ignore_system_fonts=_bundled(data),
        )
    except typst.TypstError as error:
        raise TrackworthyError(f"the PDF could not be typeset: {error}") from error
    return bytes(pdf)


def _plans(section: Section, folder: Path, number: int) -> Json:
    """The section on the plans of one scenario, its pictures copied to `folder`: typst sees no other."""
    files = [f"plans-{number}-{i}.png" for i in range(len(section.pictures))]
    for file, picture in zip(files, section.pictures, strict=True):
        shutil.copyfile(picture.file, folder / file)
    return section_data(section, files)


def _trials(result: CaseResult, outcome: Outcome, folder: Path, number: int) -> Json:
    """The trials of a case, with their picture in `folder` where two or more could be tried."""
    from reports.trials_figure import save_trials_figure

    figure = f"trials-{number}.svg" if result.statistics.band is not None else ""
    if figure:
        save_trials_figure(result, outcome, folder / figure, page=True)
    return trials_data(result, outcome, figure)


def _bundled(data: str) -> bool:
    """Whether the bundled fonts have every character, so that every machine sets the same page."""
    return all(any(low <= ord(c) <= high for low, high in _BUNDLED) for c in set(data))
