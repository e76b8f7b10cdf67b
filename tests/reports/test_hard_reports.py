"""Whole reports that are hard to set, as pictures of their pages and as one HTML file."""

import dataclasses
import io
from types import SimpleNamespace

import numpy as np
import pytest
import typst
from PIL import Image

from campaigns.finished import Finished
from campaigns.manifest import Manifest
from planners.path import Path
from reports.figures.drawing import draw_all
from reports.html.page import write_html
from reports.pages.pdf import prepared
from reports.pages.report_data import report_of
from sample_results import result_of, unplanned
from small_reports import HERE
from tracking.verdict import NOT_TRACKWORTHY

PPI = 40.0
SIDE, END = 16.0, 5.0  # [mm] at the sides of a page and at its ends, where nothing stands: text has 18, the foot 6
LEAST = 0.005  # of a page is ink even where a table ends on it; a head and a number alone are 0.001
LARGEST = 8_000_000  # bytes of report.html
PAPERS = {"a4": (210.0, 297.0), "us-letter": (215.9, 279.4)}  # [mm]
LONG = "AVeryLongNameThatAMachineMadeOfAHash" + "0123456789abcdef" * 7
MADE = Manifest("made up", 1, 1, "0" * 64, "0" * 64, {"trackworthy": "0.1.0", "python": "3.11"}, "", "Linux", 1, {})


def report(results, outcomes=(), title="Made up", **told):
    return report_of(outcomes, title, results=results, manifest=MADE, **told)


def pages_of(report, folder, paper="a4"):
    """Every page of the PDF as where there is ink on it, (rows, columns) of bool."""
    for name in ("figures", "typst"):
        (folder / name).mkdir()
    draw_all(report.drawings, folder / "figures", HERE)
    source, bundled = prepared(report, folder / "figures", paper, folder / "typst")
    pictures = typst.compile(str(source), root=str(source.parent), format="png", ppi=PPI, ignore_system_fonts=bundled)
    pictures = pictures if isinstance(pictures, list) else [pictures]
    return [np.asarray(Image.open(io.BytesIO(picture)).convert("L")) < 200 for picture in pictures]


def check(report, folder, pages, paper="a4"):
    """The PDF has about as many `pages`, none is nearly empty, and none has ink near its edge."""
    seen = pages_of(report, folder, paper)
    least, most = pages
    assert least <= len(seen) <= most
    for page in seen:
        width, height = PAPERS[paper]
        assert page.shape == pytest.approx((height / 25.4 * PPI, width / 25.4 * PPI), abs=1.0)
        side, end = (round(margin / 25.4 * PPI) for margin in (SIDE, END))
        inner = page[end:-end, side:-side]
        assert page.sum() == inner.sum()
        assert inner.mean() > LEAST
    return seen


def check_html(report, results, outcomes, folder):
    """The page says all names, and is not too large; its scripts are tested elsewhere."""
    campaign = SimpleNamespace(note="", seed=1)
    finished = Finished(campaign, folder, MADE, results, {one.name: one for one in outcomes}, [], [])
    write_html(finished, report.data, folder / "report.html")
    page = (folder / "report.html").read_bytes()
    assert len(page) < LARGEST
    return page.decode()


def test_the_checks_find_what_is_wrong(yard, tmp_path):
    page = pages_of(report([result_of(yard)], [yard]), tmp_path)[0]
    beside = np.zeros_like(page)
    assert not beside.mean() > LEAST
    assert 0.01 < page.mean() < 0.5


def test_long_names(yard, tmp_path):
    outcomes = [dataclasses.replace(yard, name=f"{LONG} {end}") for end in ("30km/h", "45km/h")]
    hostile = '#panic("x") $y$ *b* _i_ [a](b) @r <l> `raw` // /* <script>window.hacked=1</script> &amp; |'
    outcomes.append(dataclasses.replace(yard, name=hostile, notes=(LONG * 3, hostile)))
    results = [
        result_of(one, number=i, path=f"{LONG}.csv", trials=3, bad=i - 1) for i, one in enumerate(outcomes, start=1)
    ]
    made = report(results, outcomes, "A title that goes on and on, " * 12, subtitle=LONG, commands=[LONG * 2] * 3)
    check(made, tmp_path, (9, 14))
    page = check_html(made, results, outcomes, tmp_path)
    assert "<script>window" not in page
    assert all(name in page for name in (f"{LONG} 30km/h", f"{LONG} 45km/h"))


def test_one_trial(yard, tmp_path):
    results = [result_of(yard, trials=1, bad=0)]
    made = report(results, [yard], commands=["trackworthy run a.toml"])
    check(made, tmp_path, (3, 4))
    check_html(made, results, [yard], tmp_path)


def test_nothing_came_out(yard, tmp_path):
    failing = dataclasses.replace(yard, name="fails")
    results = [
        result_of(failing, trials=4, bad=4, path="a.csv"),
        unplanned("no way", planner="exact"),
        unplanned("no way either", planner="astar-eight"),
        result_of(dataclasses.replace(yard, name="breaks"), trials=2, bad=0, errors=2, path="b.csv"),
    ]
    made = report(results, [failing])
    assert made.data["front"]["headline"] == {"number": "4 of 4", "words": "cases did not come out as expected"}
    assert not any("versus" in one.stem for one in made.drawings)
    check(made, tmp_path, (5, 9))
    check_html(made, results, [failing], tmp_path)


def test_no_path_at_all(tmp_path):
    results = [unplanned(f"no way {i}", planner=name) for i, name in enumerate(("exact", "astar-eight"))]
    made = report(results)
    check(made, tmp_path, (3, 4))
    check_html(made, results, [], tmp_path)


@pytest.mark.parametrize("paper", PAPERS)
def test_sixty_cases(yard, tmp_path, paper):
    """Of some of them the worst trial is shown whole; the matrix has the controllers across and the speeds down."""
    names = ("lqr", "stanley", "pure-pursuit", "l1", "vector-field")
    outcomes, results = [], []
    for i, (speed, controller) in enumerate(((s, c) for s in range(10, 70, 5) for c in names), start=1):
        named = f"yard {speed}km/h {controller}"
        one = dataclasses.replace(yard, name=named, controller=controller, speed=f"{speed}km/h")
        results.append(result_of(one, number=i, trials=1, bad=int(i > 30), path="yard.csv", controller=controller))
        outcomes += [dataclasses.replace(one, speed=speed / 3.6)] if i == 60 else []
    made = report(results, outcomes)
    assert (made.data["matrix"]["down"], made.data["matrix"]["across"]) == (["speed"], ["controller"])
    check(made, tmp_path, (10, 18), paper)
    page = check_html(made, results, outcomes, tmp_path)
    assert all(result.case.name in page for result in results)


@pytest.mark.parametrize("long", [True, False])
def test_a_long_route_and_a_small_map(route, sharp_yard, tmp_path, long):
    """Of 900 km, flown to its end; and of 70 m."""
    if long:
        factor, columns = 900e3 / route.path.length, route.track.columns
        data = route.track.data.copy()
        for name in ("t", "x", "y", "s"):
            data[:, columns.index(name)] *= factor
        track = dataclasses.replace(route.track, data=data)
        points = np.column_stack([factor * route.path.points[:, :2], route.path.z])
        path = Path(points, route.path.frame, "far")
        outcome = dataclasses.replace(route, name="far", path=path, track=track, obstacles=None)
    else:
        outcome = sharp_yard
    results = [result_of(outcome, trials=1, bad=1, path="a.csv", expect=NOT_TRACKWORTHY)]
    made = report(results, [outcome])
    check(made, tmp_path, (3, 3))
    check_html(made, results, [outcome], tmp_path)
