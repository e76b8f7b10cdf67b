"""Reports and figures made within the test's own process."""

from campaigns.lanes import Lanes
from reports.figures.drawing import draw_all
from reports.figures.plan_pictures import plan_drawings
from reports.figures.style import save, style
from reports.pages.pdf import write_pdf
from reports.pages.pdf_plans import plan_sections, planned
from reports.pages.report_data import report_of
from small_campaigns import Here

HERE = Lanes(Here(), 1)


def save_figure(figure, *arguments, file):
    """`figure` of these `arguments` in a file."""
    with style():
        save(figure(*arguments), file)


def sections_of(plans, results=(), note=""):
    return plan_sections(plans, results, note, HERE)


def drawn(drawings, figures):
    """The PNG files of these figures, in a folder made for them."""
    figures.mkdir()
    draw_all(drawings, figures, HERE)
    return [figures / f"{one.stem}.png" for one in drawings]


def drawings_of(plans):
    """The pictures of plans by label, made here."""
    return plan_drawings(plans, planned(plans, HERE), "plans")


def pdf_of(outcomes, file, title, paper="a4", **told):
    """The PDF of a report, its figures in a folder beside it."""
    report, figures = report_of(outcomes, title, **told), file.with_name(f"{file.stem}-figures")
    if file.parent.is_dir():
        figures.mkdir(exist_ok=True)
    draw_all(report.drawings, figures, HERE)
    write_pdf(report, figures, file, paper)
