from __future__ import annotations

import time

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.inflate import inflated
from planners.map import Circle, Map, Raster
from planners.offset import grown, overlay, shrunk

SQUARE = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])
# Two rooms of 8 x 10, joined by a corridor 2 wide
ROOMS = np.array(
    [[0, 0], [8, 0], [8, 4], [12, 4], [12, 0], [20, 0], [20, 10], [12, 10], [12, 6], [8, 6], [8, 10], [0, 10]]
)
# A pen with walls 1 thick, and a gate 2 wide
PEN = np.array([[0, 0], [10, 0], [10, 4], [9, 4], [9, 1], [1, 1], [1, 9], [9, 9], [9, 6], [10, 6], [10, 10], [0, 10]])

seeds = st.integers(0, 2**32 - 1)
clearances = st.floats(0.01, 4.0)


def star(rng, at, largest):
    """A polygon about `at`, concave as often as not."""
    radii = rng.uniform(0.1, 1.0, rng.integers(3, 10)) * largest
    angles = np.linspace(0.0, 2.0 * np.pi, len(radii), endpoint=False)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]) + at


def room(area, points):
    return clearance(area, np.column_stack([points, np.zeros(len(points))]), Disc(0.0))


def assert_nearer_is_forbidden(area, keep, points, slack):
    before, after = room(area, points), room(inflated(area, keep), points)
    assert (after[before < keep - 1e-9] < 1e-9).all()
    assert (after[before > keep + slack] > -1e-9).all()


def test_no_clearance_changes_nothing():
    area = Map(polygons=(SQUARE,), bounds=(-5.0, -5.0, 20.0, 20.0))
    assert inflated(area, 0.0) is area


@settings(max_examples=60)
@given(seeds, clearances)
def test_what_is_nearer_than_the_clearance_to_an_obstacle_is_forbidden_and_nothing_else(seed, keep):
    rng = np.random.default_rng(seed)
    polygons = tuple(star(rng, rng.uniform(0.0, 30.0, 2), 9.0) for _ in range(3))
    circle = Circle(*rng.uniform(0.0, 30.0, 2), rng.uniform(0.5, 5.0))
    area = Map(polygons=polygons, circles=(circle,), bounds=(-5.0, -5.0, 35.0, 35.0))
    assert_nearer_is_forbidden(area, keep, rng.uniform(-6.0, 36.0, (500, 2)), 1e-3 * keep)


@settings(max_examples=60)
@given(seeds, clearances)
def test_what_is_nearer_than_the_clearance_to_a_keep_in_border_is_forbidden_and_nothing_else(seed, keep):
    rng = np.random.default_rng(seed)
    round_area = Circle(1.0, 2.0, 9.0)
    area = Map(keep_in=(star(rng, np.zeros(2), 12.0), star(rng, np.ones(2), 12.0)), keep_in_circles=(round_area,))
    try:
        assert_nearer_is_forbidden(area, keep, rng.uniform(-13.0, 14.0, (500, 2)), 1e-3 * keep)
    except InputError:
        points = rng.uniform(-13.0, 14.0, (2000, 2))
        assert any((room(Map(keep_in=(ring,)), points) <= keep).all() for ring in area.keep_in)


@settings(max_examples=60)
@given(seeds, clearances)
def test_polygons_grow_by_the_clearance_and_less_than_a_thousandth_more(seed, keep):
    polygon = shapely.Polygon(star(np.random.default_rng(seed), np.zeros(2), 10.0))
    wide, narrow = grown(polygon, keep), shrunk(polygon, keep)
    corners = shapely.points(shapely.get_coordinates(wide))
    assert shapely.distance(corners, polygon).max() < 1.001 * keep
    assert wide.boundary.distance(polygon) > (1.0 - 1e-9) * keep
    assert narrow.is_empty or narrow.distance(polygon.exterior) > (1.0 - 1e-9) * keep
    assert narrow.is_empty or narrow.within(polygon)


def test_the_straight_sides_of_a_square_move_by_the_clearance():
    ring = inflated(Map(polygons=(SQUARE,)), 2.0).polygons[0]
    assert [*ring.min(axis=0), *ring.max(axis=0)] == pytest.approx([-2.0, -2.0, 12.0, 12.0], abs=1e-12)
    exact = 10.0**2 + 4 * 10.0 * 2.0 + np.pi * 2.0**2
    assert exact < shapely.Polygon(ring).area < exact + 1e-3 * np.pi * 2.0**2


def test_circles_and_bounds_stay_what_they_are():
    area = Map(
        circles=(Circle(1.0, 2.0, 3.0),), keep_in_circles=(Circle(0.0, 0.0, 9.0),), bounds=(-9.0, -8.0, 7.0, 6.0)
    )
    narrower = inflated(area, 0.5)
    assert narrower.circles == (Circle(1.0, 2.0, 3.5),)
    assert narrower.keep_in_circles == (Circle(0.0, 0.0, 8.5),)
    assert narrower.bounds == (-8.5, -7.5, 6.5, 5.5)


def test_an_open_edge_bounds_the_reference_point_alone():
    assert inflated(Map(bounds=(0.0, 0.0, 5.0, 5.0), edge="open"), 3.0).bounds == (0.0, 0.0, 5.0, 5.0)


@settings(max_examples=20)
@given(seeds, st.floats(1.01, 3.5))
def test_a_keep_in_area_that_falls_apart_leaves_all_its_pieces(seed, keep):
    area = Map(keep_in=(ROOMS,))
    points = np.random.default_rng(seed).uniform(-1.0, 21.0, (300, 2)) * (1.0, 0.5)
    assert_nearer_is_forbidden(area, keep, points, 1e-3 * keep)
    middles = np.array([[4.0, 5.0], [16.0, 5.0]])
    assert (room(inflated(area, keep), middles) > 0.0).all()
    # In both of two areas, not in any
    both = inflated(Map(keep_in=(ROOMS, SQUARE)), keep)
    assert (room(both, middles) > 0.0).tolist() == [True, False]


def test_no_point_of_the_old_border_is_left_when_a_keep_in_area_falls_apart():
    border = shapely.get_coordinates(shapely.segmentize(shapely.Polygon(ROOMS).exterior, 0.1))
    assert (room(inflated(Map(keep_in=(ROOMS,)), 1.5), border) < -0.1).all()


@settings(max_examples=20)
@given(seeds, st.floats(1.01, 3.5))
def test_a_pocket_that_closes_stays_free(seed, keep):
    area = Map(polygons=(PEN,))
    points = np.random.default_rng(seed).uniform(-5.0, 15.0, (300, 2))
    assert_nearer_is_forbidden(area, keep, points, 1e-3 * keep)
    assert room(inflated(area, keep), np.array([[5.0, 5.0]]))[0] > 0.0


@pytest.mark.parametrize(
    ("area", "place"),
    [
        (Map(keep_in=(ROOMS, SQUARE)), "keep-in polygon 1"),
        (Map(keep_in_circles=(Circle(0.0, 0.0, 5.0),)), "keep-in circle 1"),
        (Map(bounds=(0.0, 0.0, 10.0, 50.0)), "bounds"),
    ],
)
def test_an_area_of_which_nothing_is_left_is_named(area, place):
    with pytest.raises(InputError, match=f"{place}: a clearance of 5 m leaves nothing of it; give less"):
        inflated(area, 5.0)


@pytest.mark.parametrize("keep", [-1.0, np.nan, np.inf])
def test_a_clearance_that_is_none_is_refused(keep):
    with pytest.raises(InputError, match=r"clearance: .* is not possible; give 0 or more"):
        inflated(Map(), keep)


@settings(max_examples=60)
@given(seeds, st.floats(0.01, 0.6), st.one_of(st.floats(0.01, 20.0), st.integers(1, 8).map(lambda n: 2.5 * n)))
def test_cells_are_blocked_whose_square_is_nearer_than_the_clearance_to_a_blocked_square(seed, share, keep):
    blocked = np.random.default_rng(seed).random((7, 9)) < share
    raster = inflated(Map(raster=Raster(blocked, 2.5, x=-10.0, y=30.0)), keep).raster
    added = round((-10.0 - raster.x) / 2.5)
    assert (raster.cell, raster.y) == (2.5, 30.0 - 2.5 * added)
    assert 2.5 * added >= keep
    rows, columns = np.indices(raster.blocked.shape)
    expected = np.zeros(raster.blocked.shape, dtype=bool)
    for row, column in np.argwhere(blocked) + added:
        apart = np.hypot(np.maximum(np.abs(rows - row) - 1, 0), np.maximum(np.abs(columns - column) - 1, 0))
        expected |= apart * 2.5 < keep
    assert (raster.blocked == expected).all()


def test_a_raster_grows_within_the_bounds_and_no_farther():
    blocked = np.zeros((4, 4), dtype=bool)
    blocked[2, 3] = True
    area = Map(raster=Raster(blocked, 1.0), bounds=(-1.0, 0.0, 40.0, 5.5), edge="open")
    raster = inflated(area, 3.0).raster
    assert (raster.x, raster.y, raster.blocked.shape) == (-1.0, 0.0, (6, 8))
    points = np.random.default_rng(0).uniform([-1.0, 0.0], [8.0, 5.5], (500, 2))
    raster_only = Map(raster=area.raster)
    near = room(raster_only, points) < 3.0
    assert (room(Map(raster=raster), points)[near] <= 0.0).all()


def test_a_raster_of_512_by_512_is_grown_by_100_cells_in_a_moment():
    blocked = np.random.default_rng(0).random((512, 512)) < 0.001
    area = Map(raster=Raster(blocked, 1.0), bounds=(0.0, 0.0, 512.0, 512.0))
    start = time.perf_counter()
    inflated(area, 100.0)
    assert time.perf_counter() - start < 2.0  # twenty times what it takes, for slow machines


def test_an_overlay_that_geos_fails_at_is_tried_on_a_grid():
    one, other = shapely.box(0.0, 0.0, 100.0, 1.0), shapely.box(0.0, 1e-11, 1.0, 2.0)

    def fails(*shapes, grid_size=None):
        if grid_size is None:
            raise shapely.GEOSException("TopologyException")
        return shapely.union(*shapes, grid_size=grid_size)

    assert overlay(fails, one, other).area == pytest.approx(101.0, rel=1e-9)
    bow = shapely.Polygon([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]])
    assert overlay(lambda *shapes, grid_size=None: bow if grid_size is None else one, one, other) is one


def test_a_vertex_given_twice_changes_nothing():
    once = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 8.0]])
    twice = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 0.0], [10.0, 8.0]])
    one, two = (inflated(Map(polygons=(ring,)), 2.0).polygons for ring in (once, twice))
    assert [ring.tolist() for ring in one] == [ring.tolist() for ring in two]
