import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.map import Circle, Map
from planners.pio.course import Course, Joint, Limits, is_even
from planners.pio.course_kernels import depth_along, room_at, shape_of
from planners.pio.field import field_of

CIRCLE = Map(circles=(Circle(50.0, 50.0, 10.0),))
FIELD = field_of(CIRCLE, (0.0, 0.0, 100.0, 100.0))
FREE = Limits(1.0, math.inf, math.pi)
COURSE = Course(np.array([10.0, 50.0]), np.array([90.0, 50.0]), 20, FREE, FIELD)

offsets = st.lists(st.floats(-10.0, 10.0), min_size=19, max_size=19).map(np.array)


@given(st.floats(0.0, 100.0), st.floats(0.0, 100.0))
def test_the_field_is_the_distance_to_a_circle(x, y):
    exact = math.hypot(x - 50.0, y - 50.0) - 10.0
    error = room_at(FIELD.room, FIELD.cell, FIELD.x, FIELD.y, x, y) - exact
    assert abs(error) <= FIELD.cell**2 / (4.0 * max(exact + 10.0, FIELD.cell)) + 1e-9


def test_outside_of_the_field_room_falls_with_distance():
    edge, beyond = (room_at(FIELD.room, FIELD.cell, 0.0, 0.0, x, 50.0) for x in (0.0, -7.0))
    assert edge - beyond == pytest.approx(7.0)


@pytest.mark.parametrize("y", [50.0, 55.0, 60.5, 62.0])
def test_the_depth_of_a_line_is_how_near_it_passes(y):
    depth = depth_along(FIELD.room, FIELD.cell, 0.0, 0.0, 20.0, y, 80.0, y, 1.0)
    assert depth == pytest.approx(max(0.0, 11.0 - (y - 50.0)), abs=0.3)


@given(offsets)
def test_legs_are_equal_along_what_the_offsets_draw(position):
    legs = COURSE.legs(position)
    assert (legs[0] == COURSE.start).all()
    assert (legs[-1] == COURSE.goal).all()
    raw = np.column_stack([np.linspace(10.0, 90.0, 21), 50.0 + np.concatenate([[0.0], position, [0.0]])])
    drawn = np.hypot(*np.diff(raw, axis=0).T)
    each = np.hypot(*np.diff(legs, axis=0).T)
    assert each.max() <= drawn.sum() / 20.0 + 1e-9  # a chord is no longer than its arc
    assert shape_of(legs)[0] == pytest.approx(each.sum())


def test_a_straight_path_costs_its_length_and_is_kept():
    line = Course(np.array([10.0, 20.0]), np.array([90.0, 20.0]), 20, FREE, FIELD)
    told = line.judge(np.zeros((1, 19)))
    assert (told.cost[0], told.length[0]) == (pytest.approx(80.0), pytest.approx(80.0))
    assert told.kept[0]


def test_what_breaks_a_limit_costs_and_is_not_kept():
    """Through the circle; the same beyond the range; a bend sharper than the limit."""
    through = COURSE.judge(np.zeros((1, 19)))
    assert not through.kept[0]
    assert through.cost[0] > through.length[0]
    field = field_of(Map(bounds=(0.0, 0.0, 100.0, 100.0)), (0.0, 0.0, 100.0, 100.0))
    for limits, position in ((Limits(0.0, 79.0, math.pi), 0.0), (Limits(0.0, 99.0, 0.1, 0.1), 8.0)):
        bent = np.zeros((1, 19))
        bent[0, 9] = position
        told = Course(COURSE.start, COURSE.goal, 20, limits, field).judge(bent)
        assert not told.kept[0]
        assert told.cost[0] > told.length[0]


def test_uneven_legs_are_told():
    assert is_even(np.array([[0.0, 0.0], [1.0, 0.0], [2.09, 0.0]]))
    assert not is_even(np.array([[0.0, 0.0], [1.0, 0.0], [2.3, 0.0]]))


@given(offsets)
def test_the_offsets_of_a_path_are_found_again(position):
    """To what the densely sampled path allows: 20 points a leg."""
    drawn = np.column_stack([np.linspace(10.0, 90.0, 21), 50.0 + np.concatenate([[0.0], position, [0.0]])])
    assert COURSE.offsets(drawn) == pytest.approx(position, abs=0.5)


def test_positions_stay_within_the_width_of_the_map():
    """However fast pigeons get, as with an inertia above 1: what a path costs to look at grows with its length."""
    far = np.array([[-1e9, *np.zeros(17), 1e9]])
    reach = math.hypot(FIELD.cell * FIELD.room.shape[0], FIELD.cell * FIELD.room.shape[1])
    assert COURSE.clipped(far)[0, [0, 1, 18]].tolist() == [-reach, 0.0, reach]
    both = Joint((COURSE, COURSE)).clipped(np.hstack([far, far]))
    assert both.tolist() == np.hstack([COURSE.clipped(far)] * 2).tolist()


def test_joint_courses_cost_their_sum():
    rng = np.random.default_rng(1)
    other = Course(np.array([10.0, 80.0]), np.array([90.0, 70.0]), 20, FREE, FIELD)
    joint, positions = Joint((COURSE, other)), rng.normal(0.0, 3.0, (5, 38))
    one, two = COURSE.judge(positions[:, :19].copy()), other.judge(positions[:, 19:].copy())
    told = joint.judge(positions)
    assert told.cost == pytest.approx(one.cost + two.cost)
    assert (told.kept == (one.kept & two.kept)).all()
    slopes = joint.gradients(positions, 0.01)
    moved = positions.copy()
    moved[:, 25] += 0.01
    assert slopes[:, 25] == pytest.approx((joint.judge(moved).cost - told.cost) / 0.01, abs=1e-6)
