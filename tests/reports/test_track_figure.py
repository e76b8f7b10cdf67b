import dataclasses
import math

import numpy as np
import pytest
from PIL import Image

from planners.map import Map, Raster
from planners.path import Path
from reports.focus import focus
from reports.style import style
from reports.track_figure import save_track_figure, track_figure
from tracking.feasibility import Feasibility
from tracking.verdict import Verdict


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
        save_track_figure(route, tmp_path / file, title=False)
    first = (tmp_path / "a.svg").read_bytes()
    assert first == (tmp_path / "b.svg").read_bytes()
    assert len(first) < 1_000_000


def test_a_long_track_stays_small(route, tmp_path):
    rng = np.random.default_rng(1)
    rows = np.linspace(0, len(route.track) - 1, 20_000).astype(int)
    noisy = with_track(route, rows, cross_track=rng.normal(0.0, 20.0, 20_000), curvature=rng.normal(0, 1e-3, 20_000))
    save_track_figure(noisy, tmp_path / "a.svg")
    assert (tmp_path / "a.svg").stat().st_size < 2_000_000


def texts(outcome, title=True):
    with style():
        figure = track_figure(outcome, title)
        found = [text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text"))]
    return "\n".join(found), figure


def test_says_what_it_shows(route, yard):
    text, _ = texts(route)
    parts = ("delivery-route", "NOT TRACKWORTHY", "c172x · lqr · 55 m/s", "wind 10 m/s", "cross_track_max")
    for part in (*parts, "Bank", "east [km]", "height [m]", "curvature [1/km]"):
        assert part in text
    text, _ = texts(yard)
    for part in ("Steering", "Lateral acceleration", "east [m]", "curvature [1/m]", "driven"):
        assert part in text
    assert "wind" not in text


def test_without_a_title(route):
    assert "delivery-route" not in texts(route, title=False)[0]


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
    bare = dataclasses.replace(yard, verdict=Verdict(()), metrics={}, feasibility=Feasibility((), (), ()))
    save_track_figure(bare, tmp_path / "a.png")


def test_the_worst_point_is_the_deciding_metrics(route):
    marked = focus(route)
    worst = int(np.argmax(np.abs(route.track["cross_track"])))
    assert marked.index == worst
    assert marked.label.startswith("cross_track_max")


def test_a_time_that_was_not_flown_is_not_marked_on_the_track(route):
    assert focus(with_track(route, slice(0, 10))).index is None


def test_an_unreached_point_is_marked_on_the_path(route):
    late = dataclasses.replace(route.metrics["cross_track_max"], s=39e3, t=math.nan)
    margin = dataclasses.replace(route.verdict.margins[0], metric=late)
    marked = focus(dataclasses.replace(route, verdict=Verdict((margin,))))
    assert marked.index is None
    assert (marked.x, marked.y) == pytest.approx(route.path.point_at(39e3))
