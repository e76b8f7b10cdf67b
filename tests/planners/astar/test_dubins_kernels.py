import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.astar.dubins_kernels import LRL, LSL, LSR, way_to_pose, word
from planners.astar.home_kernels import way_to_point
from planners.astar.room_kernels import along_arc

SIDES = {LSL: (1.0, 0.0, 1.0), LSR: (1.0, 0.0, -1.0), LRL: (1.0, -1.0, 1.0)}
angles = st.floats(-7.0, 7.0)


@given(kind=st.sampled_from([LSL, LSR, LRL]), alpha=angles, beta=angles, d=st.floats(0.0, 10.0))
def test_a_word_that_leads_ends_at_its_goal(kind, alpha, beta, d):
    pieces = word(kind, alpha, beta, d)
    assert min(pieces) >= 0.0
    if math.isinf(pieces[1]):
        assert kind != LSL
        return
    pose = 0.0, 0.0, alpha
    for curvature, length in zip(SIDES[kind], pieces, strict=True):
        pose = along_arc(*pose, curvature, length)
    assert pose[:2] == pytest.approx((d, 0.0), abs=1e-6)
    assert math.cos(pose[2] - beta) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize(
    ("ahead", "left", "turn", "length"),
    [
        (7.0, 0.0, 0.0, 7.0),
        (0.0, 4.0, math.pi, 2.0 * math.pi),  # half a circle to the left
        (0.0, -4.0, math.pi, 2.0 * math.pi),
        (2.0, 2.0, 0.5 * math.pi, math.pi),  # a quarter
        (0.0, 0.0, math.pi, 14.0 / 3.0 * math.pi),  # turning on the spot: 60, 300 and 60 deg
        (10.0, 4.0, math.pi, 10.0 + 2.0 * math.pi),
        (-6.0, 0.0, 0.0, 6.0 + 4.0 * math.pi),  # back, and a whole circle
    ],
)
def test_the_shortest_of_known_ones(ahead, left, turn, length):
    assert way_to_pose(ahead, left, turn, 2.0) == pytest.approx(length, abs=1e-6)


@given(ahead=st.floats(-9.0, 9.0), left=st.floats(-9.0, 9.0), turn=angles)
def test_a_heading_at_the_end_takes_no_less_than_none(ahead, left, turn):
    assert way_to_pose(ahead, left, turn, 1.0) >= way_to_point(ahead, left, 1.0) - 1e-6


@given(
    turns=st.lists(st.tuples(st.floats(-1.0, 1.0), st.floats(0.0, 3.0)), min_size=1, max_size=5),
    radius=st.floats(0.1, 100.0),
)
def test_nothing_driven_is_shorter(turns, radius):
    pose, length = (0.0, 0.0, 0.0), 0.0
    for curvature, s in turns:
        pose, length = along_arc(*pose, curvature / radius, s * radius), length + s * radius
    assert way_to_pose(*pose, radius) <= length + 1e-3 * radius
