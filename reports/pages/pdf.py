"""The report as a PDF: one page that answers the question, the matrix of cases, and pages for scenarios and cases."""

from __future__ import annotations

import json
import re
import tempfile
from pathlib import Path

from planners.atomic_file import atomic
from planners.errors import TrackworthyError
from reports.figures.style import WIDTH
from reports.pages.report_data import Report

_TEMPLATES = Path(__file__).parents[1] / "typst"
# Scripts that the fonts bundled with typst write; others need the machine's fonts.
_BUNDLED = ((0x0000, 0x024F), (0x0370, 0x052F), (0x1E00, 0x22FF), (0x25A0, 0x27BF))


def write_pdf(report: Report, figures: Path, file: str | Path, paper: str = "a4") -> None:
    """Write `report`, whose figures lie in the folder `figures`: the same report gives the same bytes.

    `paper` is "a4" or "us-letter". The file appears whole or not at all. Raises `InputError` where its folder does not
    exist, `TrackworthyError` where typst fails.
    """
    with tempfile.TemporaryDirectory(prefix="trackworthy-pdf-") as folder, atomic(file) as temporary:
        temporary.write_bytes(_compiled(report, figures, paper, Path(folder)))


def _compiled(report: Report, figures: Path, paper: str, folder: Path) -> bytes:
    import typst

    source, bundled = prepared(report, figures, paper, folder)
    try:
        pdf = typst.compile(
            str(source),
            root=str(folder),
            format="pdf",
            font_paths=[],
            ignore_system_fonts=bundled,
        )
    except typst.TypstError as error:
        raise TrackworthyError(f"the PDF could not be typeset: {error}") from error
    return bytes(pdf)


def prepared(report: Report, figures: Path, paper: str, folder: Path) -> tuple[Path, bool]:
    """Write all that typst needs into `folder`; returns the file to compile, and whether bundled fonts are enough."""
    data = json.dumps({**report.data, "paper": paper}, ensure_ascii=False)
    # Text reaches typst as data only: nothing a user named can become markup or code.
    (folder / "report.json").write_text(data, encoding="utf-8")
    for template in _TEMPLATES.glob("*.typ"):
        (folder / template.name).write_bytes(template.read_bytes())
    for one in report.drawings:
        svg = (figures / one.svg).read_text(encoding="utf-8")
        (folder / one.svg).write_text(_without_head(svg, one.head) if one.head else svg, encoding="utf-8")
    return folder / "report.typ", _bundled(data)


def _without_head(svg: str, head: float) -> str:
    """The figure without its upper `head` inches; all figures are as wide."""
    found = re.search(r'width="([0-9.]+)pt" height="([0-9.]+)pt" viewBox="[^"]*"', svg)
    if found is None:
        raise TrackworthyError("a figure has no size; this is a fault of trackworthy")
    width, height = float(found[1]), float(found[2])
    cut = head * width / WIDTH
    view = f'width="{width:g}pt" height="{height - cut:.4f}pt" viewBox="0 {cut:.4f} {width:g} {height - cut:.4f}"'
    return svg[: found.start()] + view + svg[found.end() :]


def _bundled(data: str) -> bool:
    """Whether the bundled fonts have every character, so that every machine sets the same page."""
    return all(any(low <= ord(c) <= high for low, high in _BUNDLED) for c in set(data))
