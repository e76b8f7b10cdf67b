import dataclasses
import re
import shutil

import numpy as np
import pytest

from planners.errors import InputError
from reports.figures.case_drawings import track_drawing
from reports.figures.track_figure import save_track_figure
from reports.pages.pdf import _without_head
from reports.pages.pdf_case import case_data
from small_reports import drawn, pdf_of
from tracking.feasibility import Feasibility
from tracking.verdict import Verdict

LONG = "a-very-long-case-name_with_underscores/and.dots-" * 4 + "x" * 120


def pages(file):
    return len(re.findall(rb"/Type\s*/Page\b", file.read_bytes()))


def test_same_outcomes_same_bytes(route, yard, tmp_path):
    for name in ("a.pdf", "b.pdf"):
        pdf_of([route, yard], tmp_path / name, "Two cases", commands=["trackworthy track a.plan"])
    first = (tmp_path / "a.pdf").read_bytes()
    assert first.startswith(b"%PDF-")
    assert first == (tmp_path / "b.pdf").read_bytes()
    assert b"CreationDate" not in first
    assert len(list(tmp_path.glob("*.*"))) == 2  # nothing is left over
    assert pages(tmp_path / "a.pdf") >= 3


def test_text_is_never_markup(yard, tmp_path):
    evil = '#panic("x") $math$ *bold* [a] @ref <label> \\ `raw` // /* " \u0000 \u2028 {'
    named = dataclasses.replace(yard, name=evil, vehicle=evil, controller=evil, notes=(evil,))
    pdf_of([named], tmp_path / "a.pdf", evil, subtitle=evil, commands=[evil])


def test_long_names(route, tmp_path):
    named = dataclasses.replace(route, name=LONG, vehicle=LONG, controller=LONG, notes=(LONG,))
    pdf_of([named] * 2, tmp_path / "a.pdf", LONG, subtitle=LONG, commands=[LONG])


def test_no_case(tmp_path):
    pdf_of([], tmp_path / "a.pdf", "Nothing")
    assert pages(tmp_path / "a.pdf") == 1


def test_bare_outcome(yard, tmp_path):
    bare = dataclasses.replace(yard, verdict=Verdict(()), metrics={}, feasibility=Feasibility((), ()))
    pdf_of([bare], tmp_path / "a.pdf", "Bare")


def test_a_long_track_stays_small(route, tmp_path):
    rows = np.linspace(0, len(route.track) - 1, 20_000).astype(int)
    data = np.array(route.track.data[rows])
    noise = np.random.default_rng(1).normal(0.0, 20.0, 20_000)
    data[:, route.track.columns.index("cross_track")] = noise
    long = dataclasses.replace(route, track=dataclasses.replace(route.track, data=data))
    pdf_of([long], tmp_path / "a.pdf", "Long")
    assert (tmp_path / "a.pdf").stat().st_size < 1_000_000


def test_a_missing_folder(yard, tmp_path):
    with pytest.raises(InputError, match="does not exist"):
        pdf_of([yard], tmp_path / "no" / "a.pdf", "x")


def spaced(turn, count):
    """`count` turns too tight, the later the worse, each followed by one that is not."""
    bad = [dataclasses.replace(turn, s=10_000.0 * i, available=50.0 - i, required=530.0) for i in range(count)]
    return Feasibility(tuple(found for turn in bad for found in (turn, dataclasses.replace(turn, available=900.0))), ())


def test_the_worst_turns_are_listed_along_the_path(route):
    tight = dataclasses.replace(route, feasibility=spaced(route.feasibility.tight[0], 50))
    told = case_data(tight, "f.svg", "", "")
    assert told["tight_count"] == 50
    assert [row["available"] for row in told["tight"]] == ["6 m", "5 m", "4 m", "3 m", "2 m", "1 m"]


def test_notes_say_their_file_once_and_are_no_more_than_a_few(route):
    told = case_data(dataclasses.replace(route, notes=tuple(f"a.plan: note {i}" for i in range(9))), "f.svg", "", "")
    assert told["notes_about"] == "a.plan"
    assert told["notes_count"] == 9
    assert told["notes"] == [f"note {i}" for i in range(6)]
    told = case_data(dataclasses.replace(route, notes=("a.plan: x", "b.plan: y")), "f.svg", "", "")
    assert (told["notes_about"], told["notes"]) == ("", ["a.plan: x", "b.plan: y"])


def test_a_page_a_case(route, yard, sharp_yard, tmp_path):
    notes = tuple(f"route.plan: item {i}: DO_SET_CAM_TRIGG_DIST (206): it is no waypoint" for i in range(20))
    full = dataclasses.replace(route, feasibility=spaced(route.feasibility.tight[0], 20), notes=notes)
    command = "trackworthy track route.plan --vehicle c172x --wind 10@270 --corners fly-by --corridor 20"
    pdf_of([full, yard, sharp_yard, route], tmp_path / "a.pdf", "Four cases", commands=[command] * 4)
    assert pages(tmp_path / "a.pdf") == 5


def test_many_cases(yard, tmp_path, monkeypatch):
    """All are drawn the same, so one drawing serves them all."""
    save_track_figure(yard, tmp_path / "drawn.svg")

    def copied(drawings, folder, _lanes):
        for one in drawings:
            shutil.copyfile(tmp_path / "drawn.svg", folder / one.svg)

    monkeypatch.setattr("small_reports.draw_all", copied)
    pdf_of([yard] * 40, tmp_path / "a.pdf", "Forty cases")
    assert pages(tmp_path / "a.pdf") in (42, 43)


def test_a_page_leaves_out_the_head_of_its_figure(yard, tmp_path):
    one = track_drawing("yard", yard)
    (png,) = drawn([one], tmp_path / "figures")
    svg = png.with_suffix(".svg").read_text()
    height = float(re.search(r'height="([0-9.]+)pt"', svg)[1])
    told = re.search(
        r'<svg [^>]*height="([0-9.]+)pt" viewBox="0 ([0-9.]+) 576 ([0-9.]+)"', _without_head(svg, one.head)
    )
    assert [float(value) for value in told.groups()] == pytest.approx(
        [height - 72 * one.head, 72 * one.head, height - 72 * one.head], abs=1e-3
    )
