import dataclasses
import math

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

from planners.map import Map, Raster
from planners.path import Path
from reports.figures.focus import focus
from reports.figures.header import head_of, header_height
from reports.figures.needed_line import draw_needed
from reports.figures.style import style
from reports.figures.track_figure import save_track_figure, track_figure
from reports.words.quantity import text as quantity
from tracking.feasibility import Feasibility, Turn
from tracking.verdict import Verdict

G = 9.80665


def with_track(outcome, rows, **columns):
    """`outcome` with some rows of its track, and some of its columns set."""
    data = np.array(outcome.track.data[rows])
    for name, value in columns.items():
        data[:, outcome.track.columns.index(name)] = value
    return dataclasses.replace(outcome, track=dataclasses.replace(outcome.track, data=data))


@pytest.mark.parametrize("name", ["route", "yard", "sharp_yard"])
def test_png_is_1600_wide_and_the_same_bytes(name, request, tmp_path):
    outcome = request.getfixturevalue(name)
    for file in ("a.png", "b.png"):
        save_track_figure(outcome, tmp_path / file)
    with Image.open(tmp_path / "a.png") as image:
        assert image.width == 1600
        assert 1200 < image.height < 2400
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_svg_is_the_same_bytes_and_small(route, tmp_path):
    for file in ("a.svg", "b.svg"):
        save_track_figure(route, tmp_path / file)
    first = (tmp_path / "a.svg").read_bytes()
    assert first == (tmp_path / "b.svg").read_bytes()
    assert len(first) < 1_000_000


def test_a_long_track_stays_small(route, tmp_path):
    rng = np.random.default_rng(1)
    rows = np.linspace(0, len(route.track) - 1, 20_000).astype(int)
    noisy = with_track(route, rows, cross_track=rng.normal(0.0, 20.0, 20_000), curvature=rng.normal(0, 1e-3, 20_000))
    save_track_figure(noisy, tmp_path / "a.svg")
    assert (tmp_path / "a.svg").stat().st_size < 2_000_000


def texts(outcome, page=False):
    with style():
        figure = track_figure(outcome, page)
        found = [text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text"))]
    return "\n".join(found), figure


def test_says_what_it_shows(route, yard):
    text, _ = texts(route)
    parts = ("delivery-route", "NOT TRACKWORTHY", "c172x · lqr · 55 m/s", "wind 10 m/s", "cross-track error")
    for part in (*parts, "Bank", "east [km]", "Height [m]", "Curvature [1/km]"):
        assert part in text
    text, _ = texts(yard)
    for part in ("Steering [°]", "Steering rate [°/s]", "Lateral accel. [g]", "needed", "commanded", "driven"):
        assert part in text
    assert "east [m]" in text
    assert "Curvature" not in text  # lateral acceleration is the same at a speed
    assert "wind" not in text


@pytest.mark.parametrize("name", ["route", "yard"])
def test_maps_are_drawn_to_scale(name, request):
    _, figure = texts(request.getfixturevalue(name))
    for axes in figure.axes[:1] + [axes for axes in figure.axes if axes.get_xlabel().startswith("east of it")]:
        width, height = axes.get_window_extent().size
        across, up = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
        assert width / across == pytest.approx(height / up, rel=1e-6)


@pytest.mark.parametrize("rows", [slice(0, 0), slice(0, 1), slice(0, 2), slice(0, 300)])
@pytest.mark.parametrize("name", ["route", "yard"])
def test_short_tracks(name, rows, request, tmp_path):
    save_track_figure(with_track(request.getfixturevalue(name), rows), tmp_path / "a.png")


@pytest.mark.parametrize("column", ["x", "cross_track", "curvature", "s", "ground_speed", "heading"])
def test_not_a_number_anywhere(yard, column, tmp_path):
    save_track_figure(with_track(yard, slice(None), **{column: math.nan}), tmp_path / "a.png")


def test_everything_not_a_number(yard, tmp_path):
    save_track_figure(with_track(yard, slice(0, 5), **dict.fromkeys(yard.track.columns, math.nan)), tmp_path / "a.png")


def test_a_vehicle_that_flies_away(yard, tmp_path):
    n = len(yard.track)
    save_track_figure(
        with_track(yard, slice(None), x=np.linspace(0, 1e6, n), cross_track=np.linspace(0, 1e6, n)), tmp_path / "a.png"
    )


def test_awkward_paths(yard, tmp_path):
    for points in ([(0, 0), (0, 1e-3)], [(0, 0), (2e5, 0)], [(0, 0), (0, 3e4)], [(0, 0), (5, 0), (0, 0)]):
        save_track_figure(dataclasses.replace(yard, path=Path(np.array(points, float))), tmp_path / "a.png")


def test_a_raster_map(yard, tmp_path):
    blocked = np.zeros((20, 20), bool)
    blocked[5:9, 3:7] = True
    raster = Map(raster=Raster(blocked, 4.0), bounds=(0.0, 0.0, 80.0, 80.0), edge="open")
    save_track_figure(dataclasses.replace(yard, obstacles=raster), tmp_path / "a.png")


def test_names_may_hold_anything(yard, tmp_path):
    for name in ("$\\frac{", "名字 path", "x" * 300, "", "a\nb", "<&>"):
        save_track_figure(dataclasses.replace(yard, name=name), tmp_path / "a.png")
        save_track_figure(dataclasses.replace(yard, name=name), tmp_path / "a.svg")


def test_no_name_runs_into_the_badge(yard):
    with style():
        figure = track_figure(dataclasses.replace(yard, name="a-long-name_" * 30))
        badge, name = figure.texts[:2]
        assert name.get_window_extent().x1 < badge.get_window_extent().x0


def test_without_requirements_and_turns(yard, tmp_path):
    bare = dataclasses.replace(yard, verdict=Verdict(()), metrics={}, feasibility=Feasibility((), ()))
    save_track_figure(bare, tmp_path / "a.png")


def test_the_worst_point_is_the_deciding_metrics(route):
    marked = focus(route)
    worst = int(np.argmax(np.abs(route.track["cross_track"])))
    assert marked.index == worst
    assert marked.title == "Worst point"
    assert marked.alarm
    assert marked.label.startswith("cross-track error")


def test_a_good_run_has_no_worst_point(yard):
    marked = focus(yard)
    assert marked.title == "Closest to a limit"
    assert not marked.alarm
    text, _ = texts(yard)
    assert "closest to a limit" in text
    assert "orst" not in text


def test_without_a_deciding_place_the_largest_error_is_marked(yard):
    marked = focus(dataclasses.replace(yard, verdict=Verdict(())))
    assert marked.title == "Largest cross-track error"
    assert marked.label == quantity(yard.metrics["cross_track_max"].value, "m")


def curve(turns):
    """A feasibility of `turns`, each (s, available) with 10 km required: arcs of a kilometre."""
    return Feasibility(tuple(Turn(s, s, 0.0, 0.1, available, 10_000.0) for s, available in turns), ())


def test_a_stretch_is_one_band_and_one_marker(route):
    turns = [(1000.0 * i, 100.0 + i if 5 <= i <= 25 else 20_000.0) for i in range(1, 40)]
    bare, tight = (
        track_figure(dataclasses.replace(route, feasibility=feasibility))
        for feasibility in (Feasibility((), ()), curve(turns))
    )
    counts = [[len(axes.lines) for axes in figure.axes] for figure in (bare, tight)]
    assert counts[1][0] - counts[0][0] == 2
    band = next(line for line in tight.axes[0].lines if line.get_linewidth() == 7.0)
    assert band.get_xdata()[0] == pytest.approx(route.path.point_at(5000.0)[0])
    assert band.get_xdata()[-1] == pytest.approx(route.path.point_at(25_000.0)[0])


@pytest.mark.parametrize("available", [(100.0,), (100.0, 900.0, 100.0), (100.0, 100.0)])
def test_single_turns_and_the_ends_of_the_path(route, available, tmp_path):
    places = np.linspace(0.0, route.path.length, len(available))
    tight = dataclasses.replace(route, feasibility=curve(zip(places.tolist(), available, strict=True)))
    save_track_figure(tight, tmp_path / "a.png")


@pytest.mark.parametrize("name", ["route", "yard"])
def test_on_a_page_a_figure_is_low(name, request):
    outcome = request.getfixturevalue(name)
    _, figure = texts(outcome, page=True)
    width, height = figure.get_size_inches()
    assert height - header_height(head_of(outcome)) < 0.7 * width


@pytest.mark.parametrize("page", [False, True])
@pytest.mark.parametrize("name", ["route", "yard", "sharp_yard", "road"])
def test_nothing_runs_out_of_the_figure_or_into_its_neighbour(name, page, request):
    with style():
        figure = track_figure(request.getfixturevalue(name), page)
        drawn = figure.get_tightbbox()
        assert drawn.x0 >= 0.0
        assert drawn.y0 >= 0.0
        assert drawn.x1 <= figure.get_size_inches()[0]
        assert drawn.y1 <= figure.get_size_inches()[1]
        for axes in figure.axes:
            if axes.get_legend():
                assert axes.get_legend().get_window_extent().x0 > axes._left_title.get_window_extent().x1


def lateral_panel(outcome):
    with style():
        (found,) = (axes for axes in track_figure(outcome).axes if axes._left_title.get_text().startswith("Lateral"))
    return found, {line.get_label(): line for line in found.lines}


def test_lateral_acceleration_stands_beside_what_the_path_needs_and_both_limits(sharp_yard):
    """A corner of 81 deg at 8 m/s needs v d / 0.5 s = 2.3 g; the axis ends at 1.25 times three limits of 0.6 g."""
    axes, lines = lateral_panel(sharp_yard)
    assert lines["needed"].get_ydata().min() == pytest.approx(8.0 * (math.atan2(5, 30) - math.pi / 2) / 0.5 / G)
    assert lines["driven"].get_ydata().max() == pytest.approx(sharp_yard.track["lateral_acceleration"].max() / G)
    assert lines["limit"].get_ydata()[0] == pytest.approx(0.6)
    assert lines["grip"].get_ydata()[0] == 0.8
    assert axes.get_ylim() == pytest.approx((-1.25 * 1.8, 1.25 * 1.8))
    assert axes.get_position().width == pytest.approx(7.12 / 8.0)


def test_the_friction_of_the_conditions_goes_before_the_tyres_own(yard):
    wet = dataclasses.replace(yard, conditions=dataclasses.replace(yard.conditions, friction=0.5))
    unknown = dataclasses.replace(yard, limits=dataclasses.replace(yard.limits, friction=math.inf))
    assert lateral_panel(wet)[1]["grip"].get_ydata()[0] == 0.5
    assert "grip" not in lateral_panel(unknown)[1]


def test_a_time_that_was_not_flown_is_not_marked_on_the_track(route):
    assert focus(with_track(route, slice(0, 10))).index is None


def test_an_unreached_point_is_marked_on_the_path(route):
    late = dataclasses.replace(route.metrics["cross_track_max"], s=39e3, t=math.nan)
    margin = dataclasses.replace(route.verdict.margins[0], metric=late)
    marked = focus(dataclasses.replace(route, verdict=Verdict((margin,))))
    assert marked.index is None
    assert (marked.x, marked.y) == pytest.approx(route.path.point_at(39e3))


def test_what_a_staircase_needs_is_an_area_and_what_a_curve_needs_is_a_line():
    """Steps of +-2 on the left half of a path, a slope on its right one."""
    s = np.linspace(0.0, 200.0, 2001)
    needed = np.where(s < 100.0, 2.0 * (-1.0) ** np.arange(len(s)), s / 100.0)
    axes = Figure().add_subplot()
    draw_needed(axes, s, needed)
    (line,) = axes.lines
    assert np.isnan(line.get_ydata()[s < 99.0]).all()
    assert line.get_ydata()[s > 101.0] == pytest.approx(needed[s > 101.0])
    areas = [area.get_paths()[0].vertices for area in axes.collections]
    assert {(area[:, 1].min(), area[:, 1].max()) for area in areas[:-1]} == {(-2.0, 2.0)}
    assert max(area[:, 0].max() for area in areas) <= 102.0
