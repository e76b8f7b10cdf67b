import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.all_planners import make_planner, plan_with
from planners.errors import InputError
from planners.ground import ground_of
from planners.path import Path
from planners.rounding import rounded, taut
from planners.rounding.corner_kernels import least_radius, piece
from planners.segments import is_free, polyline_length
from sample_maps import GATE, UNIT, box, room, scenario, scenarios


def corner(turn):
    return np.array([[-100.0, 0.0], [0.0, 0.0], [100.0 * math.cos(turn), 100.0 * math.sin(turn)]])


@pytest.mark.parametrize("degrees", [1.0, 20.0, 45.0, 90.0, 120.0])
def test_a_piece_bends_no_tighter_than_its_least_radius(degrees):
    """By circles through three neighbouring points."""
    turn = math.radians(degrees)
    points = piece(corner(turn), 400.0 / (1.0 + 10.0 * math.tan(turn / 2.0)), 1)
    a, b, c = points[:-2], points[1:-1], points[2:]
    area = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    radii = np.prod([np.hypot(*(p - q).T) for p, q in ((a, b), (b, c), (c, a))], axis=0) / np.maximum(2.0 * area, 1e-12)
    wide = 400.0 / (1.0 + 10.0 * math.tan(turn / 2.0))
    assert radii.min() == pytest.approx(wide * least_radius(turn), rel=5e-3)


@given(st.floats(0.01, math.pi / 3.0), st.floats(5.0, 60.0))
def test_up_to_60_degrees_a_piece_is_an_arc(turn, radius):
    points = piece(corner(turn), radius, 1)
    tangent = radius * math.tan(turn / 2.0)
    centre = np.array([-tangent, radius])
    assert np.abs(np.hypot(*(points - centre).T) - radius).max() <= 1e-3 * radius
    assert least_radius(turn) == pytest.approx(1.0, abs=6e-3)


def test_a_detour_in_the_open_becomes_the_straight_line():
    ground = ground_of(scenario(), "test", UNIT, 0.0)
    found = rounded(ground, np.array([[5.0, 40.0], [60.0, 60.0], [115.0, 40.0]]), 10.0 * UNIT)
    assert found.smallest_radius >= 10.0 * UNIT
    assert Path(found.points).length == pytest.approx(110.0 * UNIT, rel=1e-3)
    assert found.tight == ()


def test_a_taut_line_about_a_square_touches_its_corners():
    """From (5, 40) over the corners of the square to (115, 40)."""
    ground = ground_of(scenario(polygons=[box(50.0, 20.0, 20.0, 45.0)]), "test", UNIT, 0.0)
    line = taut(ground, np.array([[5.0, 40.0], [40.5, 75.5], [80.5, 75.5], [115.0, 40.0]]))
    assert polyline_length(line) == pytest.approx(2.0 * math.hypot(45.0, 25.0) + 20.0, rel=2e-3)


def test_where_there_is_no_room_the_corner_keeps_what_there_is_and_says_so():
    found = scenario(polygons=[box(0.0, 8.0, 100.0, 72.0)], start=(5.0, 4.0), goal=(110.0, 75.0))
    ground = ground_of(found, "test", UNIT, 0.0)
    line = rounded(ground, np.array([[5.0, 4.0], [110.0, 4.0], [110.0, 75.0]]), 90.0 * UNIT)
    assert 10.0 * UNIT < line.smallest_radius < 90.0 * UNIT
    assert min(tight.radius for tight in line.tight) == line.smallest_radius
    assert room(found, Path(line.points)) >= 0.0


@settings(max_examples=100)
@given(found=scenarios, seed=st.integers(0, 1000), radius=st.floats(1.0, 60.0))
def test_rounding_never_leaves_what_is_free(found, seed, radius):
    planner = make_planner("aco-improved", {"ants": 5, "iterations": 1, "max_range": 600.0, "clearance": 0.0})
    try:
        ground = planner.ground(found)
    except InputError:
        return
    way = planner.search(ground, found, np.random.default_rng(seed)).way
    if way is None:
        return
    line = rounded(ground, way, radius * UNIT)
    cells = (line.points - ground.origin) / ground.cell
    assert all(is_free(ground.blocked, *a, *b) for a, b in itertools.pairwise(cells))
    pulled = taut(ground, way)
    assert polyline_length(pulled) <= polyline_length(way) + 1e-9
    assert all(is_free(ground.blocked, *a, *b) for a, b in itertools.pairwise(pulled))


def test_the_rounded_path_keeps_the_vehicles_clearance():
    plan = plan_with(make_planner("aco-improved", {"turn_radius": 200.0, "ants": 20, "max_range": 600.0}), GATE, 2)
    assert room(GATE, plan.paths[0]) >= 20.0
