import dataclasses
import math
import pickle
from functools import cache

import numpy as np
import pytest
from overlaps import faults
from shapely import LineString

from campaigns.statistics import Band
from planners.path import Path
from reports.figures.distribution_figure import MOST_ROWS, distribution_figure
from reports.figures.errors_figure import MOST_PANELS, errors_figure
from reports.figures.fitted import shortened
from reports.figures.scenario_cases import ScenarioRuns, named, within_group
from reports.figures.scenario_figure import scenario_figure
from reports.figures.scenario_head import scenario_head_height
from reports.figures.scenario_map import band_lines
from reports.figures.scenario_pictures import errors_caption, map_caption, scenario_figures, trials_caption
from reports.figures.style import save, style

from .conftest import make_fleet, make_route, make_yard
from .many_cases import result_like, runs_of, unflown

FIGURES = (scenario_figure, errors_figure, distribution_figure)
HIGHEST = 10.8  # [in] of a figure as wide as 170 mm of paper and so high as 230 mm
CONTROLLERS = ("lqr", "l1", "stanley")


def long_route():
    """900 km with a corner, as a fixed wing flies it."""
    near = make_route(dt=1.0)
    path = Path(near.path.points * [22.5, 22.5, 1.0], near.path.frame)
    track = dataclasses.replace(near.track, data=near.track.data * 1.0)
    for name in ("x", "y", "s"):
        track.data[:, track.columns.index(name)] *= 22.5
    return dataclasses.replace(near, path=path, track=track, obstacles=None)


@cache
def made(kind):
    yard = make_yard()
    word = "a-name-of-a-hundred-characters-without-a-space-" * 3
    return {
        "one case, one trial": lambda: runs_of(yard, trials=1),
        "all failed": lambda: runs_of(make_yard("sharp", sharp=True), ("a", "b"), CONTROLLERS, trials=3, bad=3),
        "60 cases": lambda: runs_of(yard, [f"planner-{i}" for i in range(10)], CONTROLLERS, (5.0, 8.0), trials=3),
        "12 settings": lambda: runs_of(yard, ("road",), CONTROLLERS, (5.0, 6.0, 7.0, 8.0), trials=4),
        "long names": lambda: runs_of(yard, (word, word + "2"), ("lqr", "l1"), name=word, case=word),
        "900 km": lambda: runs_of(long_route(), ("exact", "other"), ("lqr",), (55.0, 60.0)),
        "a fleet": lambda: runs_of(make_fleet(), ("vd", "vdp"), speeds=(55.0,), trials=2),
        "some without a path": lambda: unflown(runs_of(yard, ("a", "b"), trials=2), 1),
    }[kind]()


KINDS = (
    "one case, one trial", "all failed", "60 cases", "12 settings", "long names", "900 km", "a fleet",
    "some without a path",
)  # fmt: skip


@pytest.fixture(scope="module", params=KINDS)
def runs(request):
    return made(request.param)


@pytest.mark.parametrize("draw", FIGURES)
def test_every_text_can_be_read_and_the_figure_fits_a_page(runs, draw):
    with style():
        figure = draw(runs)
        assert faults(figure) == []
    assert figure.get_size_inches()[1] - scenario_head_height(runs) <= HIGHEST


def test_figures_can_be_drawn_by_another_process_and_are_the_same_bytes(tmp_path):
    sent = pickle.loads(pickle.dumps([one.arguments for one in scenario_figures(made("one case, one trial"), "a")]))
    for drawing, arguments in zip(scenario_figures(made("one case, one trial"), "a"), sent, strict=True):
        for file, own in (("a.svg", drawing.arguments), ("b.svg", arguments)):
            with style():
                save(drawing.draw(*own), tmp_path / file)
        assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()
        assert (tmp_path / "a.svg").stat().st_size < 1_000_000


def test_a_scenario_has_figures_of_its_trials_only_where_there_are_several():
    several, single = (scenario_figures(made(kind), "x") for kind in ("12 settings", "one case, one trial"))
    assert [one.stem for one in several] == ["x-map", "x-errors", "x-trials"]
    assert [one.stem for one in single] == ["x-map", "x-errors"]
    assert scenario_figures(unflown(made("one case, one trial")), "x") == []


def test_captions_tell_what_is_left_out():
    many = made("60 cases")
    assert "5 more, less bad, are grey" in map_caption(many)
    assert f"{10 - MOST_PANELS} more" in errors_caption(many)
    assert f"{60 - MOST_ROWS} more cases" in trials_caption(many)
    assert "1 case without a track is not shown" in map_caption(made("some without a path"))


def band(low, high):
    zero = np.zeros(100)
    return Band(zero, zero, zero, zero, zero, np.full(100, low), np.full(100, high))


def test_the_band_lies_beside_the_path_at_the_percentiles():
    """Offset lines of a straight path are parallel to it, and of a circle are circles."""
    low, high, wide = band_lines(Path(np.array([(0.0, 0.0), (100.0, 0.0)])), band(-2.0, 3.0), 0.1, 10.0)
    assert wide.all()
    assert np.allclose(low[:, 1], -2.0)
    assert np.allclose(high[:, 1], 3.0)
    angles = np.linspace(0.0, 1.5 * math.pi, 4000)
    ring = Path(100.0 * np.column_stack([np.cos(angles), np.sin(angles)]))
    low, high, _ = band_lines(ring, band(-2.0, 3.0), 0.1, 10.0)
    assert np.allclose(np.hypot(*low.T), 102.0, atol=0.01)  # the right of a circle to the left is outside
    assert np.allclose(np.hypot(*high.T), 97.0, atol=0.01)


def test_the_band_is_left_out_where_it_is_thin_and_where_it_is_far():
    path = Path(np.array([(0.0, 0.0), (100.0, 0.0)]))
    assert not band_lines(path, band(-0.01, 0.01), 0.1, 10.0)[2].any()
    assert not band_lines(path, band(0.0, 11.0), 0.1, 10.0)[2].any()


def test_the_area_of_a_band_is_its_width_times_the_length():
    with style():
        figure = scenario_figure(made("12 settings"))
    areas = [patch for axes in figure.axes for patch in axes.patches if patch.get_alpha() == 0.35]
    assert areas
    outcome = make_yard()
    reach = LineString(outcome.path.xy).buffer(outcome.corridor)
    for patch in areas:  # 90 % of errors of 0.1 +- 0.2 corridors lie within it
        xy = patch.get_path().vertices
        assert reach.buffer(1e-6).contains(LineString(xy))


def test_cases_differ_by_what_differs():
    runs = made("12 settings")
    assert {run.setting for run in runs.runs} >= {"lqr · 18 km/h", "stanley · 28.8 km/h"}
    assert set(runs.groups) == set(CONTROLLERS)
    assert {within_group(run, "lqr") for run, _ in runs.groups["lqr"]} == {
        "18 km/h", "21.6 km/h", "25.2 km/h", "28.8 km/h",
    }  # fmt: skip


def test_cases_that_nothing_tells_apart_are_called_by_name():
    yard = make_yard()
    first, second = (run for name in ("a", "b") for run in runs_of(yard, name=name).runs)
    assert [run.setting for run in named([first, second])] == [first.result.case.name, second.result.case.name]


def test_a_case_without_a_track_makes_no_difference():
    runs = runs_of(make_yard(), ("a", "b"), ("lqr", "l1"))
    missing = dataclasses.replace(runs.runs[0], outcome=None)
    assert [run.setting for run in named([missing, *runs.runs[1:]])][1:] == ["l1", "lqr", "l1"]


def test_the_worst_case_comes_first():
    yard = make_yard()
    runs = runs_of(yard, ("a", "b", "c"), bad=2)
    order = [run.result.case.name for run, _ in runs.flown]
    assert order[-1] == "map b lqr 8"  # the only one whose trials are all trackworthy
    assert ScenarioRuns("map", runs.runs).driven == "driven"


@pytest.mark.parametrize(
    ("name", "most", "want"), [("short", 8, "short"), ("abcdefghij", 5, "ab…ij"), ("a  b", 9, "a b")]
)
def test_a_long_name_keeps_both_ends(name, most, want):
    assert shortened(name, most) == want


def test_dots_beyond_the_limit_are_told_apart_by_shape():
    yard = make_yard()
    result = result_like(yard, trials=6, bad=2)
    runs = ScenarioRuns("map", (dataclasses.replace(runs_of(yard).runs[0], result=result),))
    with style():
        figure = distribution_figure(runs)
    counts = {}
    for dots in figure.axes[0].collections:
        counts[len(dots.get_paths()[0].vertices)] = counts.get(len(dots.get_paths()[0].vertices), 0) + len(
            dots.get_offsets()
        )
    triangle, circle = sorted(counts)
    assert (counts[triangle], counts[circle]) == (2, 4)
