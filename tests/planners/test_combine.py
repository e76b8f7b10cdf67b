from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.clearance import clearance
from planners.combine import merge, to_frame
from planners.errors import InputError
from planners.footprint import Disc, Rectangle
from planners.frame import Frame
from planners.map import Circle, Map, Raster

SQUARE = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
RASTER = Raster(np.eye(3, dtype=bool), 1.0)
HERE, THERE = Frame(47.0, 8.0), Frame(47.5, 8.5)

maps = st.sampled_from([
    Map(),
    Map(polygons=(SQUARE,), bounds=(-20.0, -20.0, 20.0, 20.0)),
    Map(circles=(Circle(9.0, 0.0, 2.0),), keep_in=(SQUARE * 5.0 - 10.0,)),
    Map(keep_in_circles=(Circle(0.0, 0.0, 15.0),), bounds=(-18.0, -9.0, 12.0, 9.0), edge="open"),
])  # fmt: skip


@settings(deadline=None)
@given(maps, maps, st.floats(-25.0, 25.0), st.floats(-25.0, 25.0), st.floats(-3.0, 3.0))
def test_what_either_map_forbids_both_forbid(a, b, x, y, heading):
    pose, body = np.array([[x, y, heading]]), Rectangle(4.0, 2.0, 1.0)
    both = clearance(merge(a, b), pose, body)
    assert np.sign(both) == np.sign(min(clearance(a, pose, body), clearance(b, pose, body)))


def test_a_raster_stays():
    assert merge(Map(), Map(raster=RASTER)).raster is RASTER
    assert merge(Map(raster=RASTER), Map()).raster is RASTER


@pytest.mark.parametrize(
    ("a", "b", "message"),
    [
        (Map(frame=HERE), Map(frame=THERE), "different frames"),
        (Map(frame=HERE), Map(), "different frames"),
        (Map(raster=RASTER), Map(raster=RASTER), "two rasters"),
        (Map(bounds=(0.0, 0.0, 1.0, 1.0)), Map(bounds=(2.0, 2.0, 3.0, 3.0)), "enclose no area"),
    ],
)
def test_maps_that_cannot_be_merged(a, b, message):
    with pytest.raises(InputError, match=message):
        merge(a, b)


def test_another_frame_keeps_every_place_on_the_ellipsoid():
    area = Map(polygons=(SQUARE * 1000.0,), keep_in_circles=(Circle(500.0, 0.0, 9e3),), frame=HERE)
    moved = to_frame(area, THERE)
    assert moved.frame == THERE
    assert moved.keep_in_circles[0].radius == 9e3
    geographic = THERE.to_geographic(moved.polygons[0])
    assert geographic == pytest.approx(HERE.to_geographic(area.polygons[0]), abs=1e-9)
    # A degree of latitude is 111.2 km at 47.25 degrees north.
    assert moved.polygons[0][0, 1] == pytest.approx(-0.5 * 111.17e3, rel=3e-3)
    back = to_frame(moved, HERE)
    assert back.polygons[0] == pytest.approx(area.polygons[0], abs=1e-3)
    assert to_frame(area, HERE) is area


@settings(deadline=None)
@given(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.0, 6.3))
def test_sides_stay_all_but_straight(u, v, course):
    start = np.array([u, v]) * 70e3
    end = start + 10e3 * np.array([np.cos(course), np.sin(course)])
    third = start + 10e3 * np.array([np.cos(course + 1.0), np.sin(course + 1.0)])
    with_middle = np.array([start, (start + end) / 2.0, end, third])
    ring = to_frame(Map(polygons=(with_middle,), frame=HERE), THERE).polygons[0]
    assert np.hypot(*(ring[1] - (ring[0] + ring[2]) / 2.0)) < 0.05


@pytest.mark.parametrize(
    ("area", "message"),
    [
        (Map(polygons=(SQUARE,)), "no origin"),
        (Map(raster=RASTER, frame=HERE), "another frame"),
        (Map(bounds=(0.0, 0.0, 1.0, 1.0), frame=HERE), "another frame"),
    ],
)
def test_maps_that_cannot_be_moved(area, message):
    with pytest.raises(InputError, match=message):
        to_frame(area, THERE)


def test_the_merged_map_measures_both():
    merged = merge(
        Map(polygons=(SQUARE,), frame=HERE),
        to_frame(Map(circles=(Circle(0.0, 0.0, 1.0),), frame=THERE), HERE),
    )
    assert merged.frame == HERE
    x, y = merged.circles[0].x, merged.circles[0].y
    assert clearance(merged, np.array([[x, y, 0.0], [-1.0, 2.0, 0.0]]), Disc(0.0)) == pytest.approx([-1.0, 1.0])
