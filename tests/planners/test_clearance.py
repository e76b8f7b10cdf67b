from __future__ import annotations

import math
import time

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc, Rectangle
from planners.map import Circle, Map, Raster

SQUARE = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])
TRUCK = Rectangle(length=4.0, width=2.0, ahead=1.0)

coordinates = st.floats(-15.0, 15.0)
poses = st.tuples(coordinates, coordinates, st.floats(-math.pi, math.pi))
rectangles = st.builds(Rectangle, st.floats(1.0, 6.0), st.floats(1.0, 6.0), st.floats(-2.0, 2.0))


@st.composite
def stars(draw):
    """Polygons about the origin, concave ones too."""
    radii = np.array(draw(st.lists(st.floats(1.0, 10.0), min_size=3, max_size=9)))
    angles = np.linspace(0.0, 2.0 * math.pi, len(radii), endpoint=False)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])


def at(area, x, y, heading, footprint):
    return float(clearance(area, np.array([[x, y, heading]]), footprint)[0])


def centre_of(pose, body):
    return pose[0] + body.ahead * math.cos(pose[2]), pose[1] + body.ahead * math.sin(pose[2])


def inset(pose, body, by):
    """The rectangle as a polygon, each side moved inwards by `by`."""
    half = np.array([body.length / 2.0 - by, body.width / 2.0 - by])
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * half
    turn = np.array([[math.cos(pose[2]), math.sin(pose[2])], [-math.sin(pose[2]), math.cos(pose[2])]])
    return shapely.Polygon(corners @ turn + centre_of(pose, body))


def assert_defined(value, pose, body, distance, centre_depth):
    """The definition, with the `distance` of a shape to what is forbidden and the depth of the centre."""
    inradius = min(body.length, body.width) / 2.0
    tiny = 1e-6
    if centre_depth > 0.0:
        assert value == pytest.approx(-inradius - centre_depth, abs=1e-9)
    elif value > 0.0:
        assert value == pytest.approx(distance(inset(pose, body, 0.0)), abs=1e-9)
    else:
        assert -value <= inradius + 1e-9
        if -value > tiny:
            assert distance(inset(pose, body, -value - tiny)) <= 1e-9
        if -value < inradius - 2 * tiny:
            assert distance(inset(pose, body, -value + tiny)) > 0.0


@settings(deadline=None)
@given(stars(), poses, st.floats(0.0, 5.0))
def test_a_disc_has_the_signed_distance_of_its_centre_less_its_radius(star, pose, radius):
    polygon, point = shapely.Polygon(star), shapely.Point(pose[:2])
    signed = polygon.exterior.distance(point) * (-1.0 if polygon.contains(point) else 1.0)
    assert at(Map(polygons=(star,)), *pose, Disc(radius)) == pytest.approx(signed - radius, abs=1e-9)
    assert at(Map(keep_in=(star,)), *pose, Disc(radius)) == pytest.approx(-signed - radius, abs=1e-9)


@settings(deadline=None)
@given(st.floats(0.5, 9.0), poses, st.floats(0.0, 5.0))
def test_a_disc_and_a_circle(radius, pose, own):
    signed = math.hypot(pose[0], pose[1]) - radius
    circle = Circle(0.0, 0.0, radius)
    assert at(Map(circles=(circle,)), *pose, Disc(own)) == pytest.approx(signed - own)
    assert at(Map(keep_in_circles=(circle,)), *pose, Disc(own)) == pytest.approx(-signed - own)


@settings(max_examples=300, deadline=None)
@given(stars(), poses, rectangles)
def test_a_rectangle_and_a_polygon(star, pose, body):
    polygon, centre = shapely.Polygon(star), shapely.Point(centre_of(pose, body))
    depth = polygon.exterior.distance(centre) if polygon.contains(centre) else 0.0
    assert_defined(at(Map(polygons=(star,)), *pose, body), pose, body, polygon.distance, depth)


@settings(max_examples=300, deadline=None)
@given(stars(), poses, rectangles)
def test_a_rectangle_and_a_polygon_to_stay_in(star, pose, body):
    polygon, centre = shapely.Polygon(star), shapely.Point(centre_of(pose, body))
    outside = shapely.box(-1e3, -1e3, 1e3, 1e3).difference(polygon)
    value = at(Map(keep_in=(star,)), *pose, body)
    assert_defined(value, pose, body, outside.distance, polygon.distance(centre))


@settings(max_examples=300, deadline=None)
@given(st.floats(0.3, 9.0), poses, rectangles)
def test_a_rectangle_and_a_circle(radius, pose, body):
    away = math.hypot(*centre_of(pose, body))
    value = at(Map(circles=(Circle(0.0, 0.0, radius),)), *pose, body)
    origin = shapely.Point(0.0, 0.0)
    assert_defined(value, pose, body, lambda shape: max(0.0, shape.distance(origin) - radius), radius - away)


@settings(max_examples=300, deadline=None)
@given(st.floats(0.3, 9.0), poses, rectangles)
def test_a_rectangle_and_a_circle_to_stay_in(radius, pose, body):
    away = math.hypot(*centre_of(pose, body))
    value = at(Map(keep_in_circles=(Circle(0.0, 0.0, radius),)), *pose, body)

    def distance(shape):
        return max(0.0, radius - max(math.hypot(x, y) for x, y in shape.exterior.coords))

    assert_defined(value, pose, body, distance, away - radius)


@settings(max_examples=200, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.02, 0.98), poses, rectangles)
def test_a_rectangle_and_cells_that_are_squares(seed, share, pose, body):
    blocked = np.random.default_rng(seed).random((6, 8)) < share
    area = Map(raster=Raster(blocked, cell=2.5, x=-10.0, y=-7.5))
    value = at(area, *pose, body)
    if not blocked.any():
        assert value == math.inf
        return
    cells = [shapely.box(2.5 * c - 10.0, 2.5 * r - 7.5, 2.5 * c - 7.5, 2.5 * r - 5.0) for r, c in np.argwhere(blocked)]
    union, centre = shapely.union_all(cells), shapely.Point(centre_of(pose, body))
    depth = union.boundary.distance(centre) if union.contains(centre) else 0.0
    assert_defined(value, pose, body, union.distance, depth)


def test_the_sign_is_that_of_overlap_and_touching_is_0():
    area = Map(polygons=(SQUARE,))
    # The truck's nose is 3 m ahead of its axle.
    assert at(area, -3.0, 5.0, 0.0, TRUCK) == 0.0
    assert at(area, -3.25, 5.0, 0.0, TRUCK) == 0.25
    assert at(area, -2.75, 5.0, 0.0, TRUCK) == -0.25
    assert at(area, -4.0, 5.0, math.pi, TRUCK) == pytest.approx(3.0)


def test_depth_goes_on_growing_beyond_the_inradius():
    area = Map(polygons=(SQUARE,))
    assert at(area, -1.5, 5.0, 0.0, TRUCK) == pytest.approx(-1.0)
    assert at(area, -0.5, 5.0, 0.0, TRUCK) == pytest.approx(-1.5)
    assert at(area, 4.0, 5.0, 0.0, TRUCK) == pytest.approx(-6.0)


@settings(deadline=None)
@given(stars(), poses, rectangles, st.floats(-math.pi, math.pi), st.floats(0.01, 3.0))
def test_clearance_changes_no_faster_than_the_body_moves(star, pose, body, course, step):
    area = Map(polygons=(star,), keep_in_circles=(Circle(1.0, 2.0, 9.0),), bounds=(-12.0, -12.0, 12.0, 12.0))
    moved = (pose[0] + step * math.cos(course), pose[1] + step * math.sin(course), pose[2])
    assert abs(at(area, *pose, body) - at(area, *moved, body)) <= step + 1e-9


def test_a_closed_edge_bounds_the_body_and_an_open_one_its_reference_point():
    poses = np.array([[7.5, 5.0, 0.0], [9.0, 5.0, 0.0], [10.5, 5.0, 0.0], [13.0, 14.0, 0.0]])
    bounds = (0.0, 0.0, 10.0, 10.0)
    closed = clearance(Map(bounds=bounds), poses, TRUCK)
    assert closed == pytest.approx([-0.5, -1.0, -2.5, -1.0 - math.hypot(4.0, 4.0)])
    free = clearance(Map(bounds=bounds, edge="open"), poses, TRUCK)
    assert free == pytest.approx([2.5, 1.0, -0.5, -5.0])


def test_the_vehicle_must_stay_in_every_keep_in_area():
    area = Map(keep_in=(SQUARE, np.add(SQUARE, (6.0, 0.0))))
    assert clearance(area, np.array([[8.0, 5.0, 0.0], [3.0, 5.0, 0.0]]), Disc(1.0)) == pytest.approx([1.0, -4.0])


def test_the_obstacle_a_pose_is_deepest_in_decides():
    area = Map(polygons=(SQUARE, np.add(SQUARE, (4.0, 0.0))), circles=(Circle(5.0, 5.0, 2.0),))
    assert at(area, 5.0, 5.0, 0.0, Disc(0.0)) == pytest.approx(-5.0)


def test_nothing_forbidden_is_infinitely_far_and_a_lost_pose_is_nan():
    assert at(Map(), 0.0, 0.0, 0.0, TRUCK) == math.inf
    assert at(Map(raster=Raster(np.zeros((3, 3), dtype=bool), 1.0)), 0.0, 0.0, 0.0, TRUCK) == math.inf
    values = clearance(Map(polygons=(SQUARE,)), np.array([[np.nan, 0.0, 0.0], [-1.0, 5.0, 0.0]]), Disc(0.0))
    assert np.isnan(values[0])
    assert values[1] == 1.0
    assert clearance(Map(polygons=(SQUARE,)), np.empty((0, 3)), TRUCK).shape == (0,)


def test_poses_need_a_heading():
    with pytest.raises(InputError, match="x, y, heading"):
        clearance(Map(), np.zeros((4, 2)), TRUCK)


def test_many_poses_are_the_same_as_one_by_one():
    rng = np.random.default_rng(1)
    area = Map(polygons=(SQUARE,), raster=Raster(rng.random((20, 20)) < 0.3, 0.5, x=12.0))
    many = np.column_stack([rng.uniform(-5.0, 25.0, (2500, 2)), rng.uniform(-3.0, 3.0, 2500)])
    together = clearance(area, many, TRUCK)
    picked = rng.integers(0, 2500, 40)
    assert [at(area, *many[i], TRUCK) for i in picked] == together[picked].tolist()


def test_5000_poses_on_a_raster_of_512_by_512_take_about_a_second():
    rng = np.random.default_rng(2)
    area = Map(raster=Raster(rng.random((512, 512)) < 0.05, 0.14))
    many = np.column_stack([rng.uniform(0.0, 71.0, (5000, 2)), rng.uniform(-3.0, 3.0, 5000)])
    start = time.perf_counter()
    clearance(area, many, TRUCK)
    assert time.perf_counter() - start < 10.0  # ten times what it takes, for slow machines
