"""The report as a PDF: one page that answers the question, then a page for every case."""

from __future__ import annotations

import json
import tempfile
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

from planners.atomic_file import atomic
from reports.json_result import Json
from reports.pdf_case import case_data
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
    errors: Mapping[str, str] | None = None,
) -> None:
    """Write the report on `outcomes` under `title`: the same outcomes give the same bytes.

    `commands` says how to repeat each case, in the order of `outcomes`; it may be shorter. `errors` tells by name of
    the cases that failed to run, and why. The file appears
    whole or not at all. Raises `InputError` where its folder does not exist, `TrackworthyError` where typst
    fails.
    """
    with tempfile.TemporaryDirectory(prefix="trackworthy-pdf-") as folder, atomic(file) as temporary:
        temporary.write_bytes(_compiled(outcomes, Path(folder), title, subtitle, commands, errors or {}))


def _compiled(
    outcomes: Sequence[Outcome],
    folder: Path,
    title: str,
    subtitle: str,
    commands: Sequence[str],
    errors: Mapping[str, str],
) -> bytes:
    import typst

    from planners.errors import TrackworthyError
    from reports.track_figure import save_track_figure

    cases: list[Json] = []
    for number, outcome in enumerate(outcomes):
        figure = f"case-{number}.svg"
        save_track_figure(outcome, folder / figure, page=True)
        cases.append(case_data(outcome, figure, commands[number] if number < len(commands) else ""))
    failed: list[Json] = [{"name": name, "error": error} for name, error in errors.items()]
    told = {"title": title, "subtitle": subtitle, **_counts(outcomes), "cases": cases, "errors": failed}
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


def _counts(outcomes: Sequence[Outcome]) -> dict[str, Json]:
    passed = Counter(outcome.verdict.passed for outcome in outcomes)
    worthy = Counter(outcome.verdict.trackworthy for outcome in outcomes)
    return {
        "passed": passed[True],
        "failed": passed[False],
        "worthy": worthy[True],
        "unworthy": worthy[False],
    }


def _bundled(data: str) -> bool:
    """Whether the bundled fonts have every character, so that every machine sets the same page."""
    return all(any(low <= ord(c) <= high for low, high in _BUNDLED) for c in set(data))
