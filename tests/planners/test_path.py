import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from planners.errors import InputError
from planners.path import Path
from planners.polyline import resampled
from sample_paths import circle, right_angle

COORDINATE = st.floats(-1000.0, 1000.0).map(lambda value: round(value, 2))
POINTS = arrays(float, st.tuples(st.integers(2, 12), st.just(2)), elements=COORDINATE).filter(
    lambda points: bool((np.hypot(*np.diff(points, axis=0).T) > 0.1).all())
)


def brute_force_distance(points, x, y):
    """Distance to the polyline; where an end of it is nearest, to its outer segment gone on."""
    best, end = math.inf, None
    for i in range(len(points) - 1):
        a, b = points[i], points[i + 1]
        t = np.dot([x - a[0], y - a[1]], b - a) / np.dot(b - a, b - a)
        foot = a + min(max(t, 0.0), 1.0) * (b - a)
        distance = math.hypot(x - foot[0], y - foot[1])
        if distance < best - 1e-12:
            beyond = (i == 0 and t < 0.0) or (i == len(points) - 2 and t > 1.0)
            best, end = distance, a + t * (b - a) if beyond else None
    return best if end is None else math.hypot(x - end[0], y - end[1])


@given(POINTS, COORDINATE, COORDINATE)
def test_cross_track_is_the_distance_to_the_nearest_segment(points, x, y):
    at = Path(points).project(x, y)
    assert abs(at.cross_track) == pytest.approx(brute_force_distance(points, x, y), abs=1e-6)
    assert math.hypot(x - at.x, y - at.y) == pytest.approx(abs(at.cross_track), abs=1e-9)


@given(POINTS, COORDINATE, COORDINATE)
def test_cross_track_changes_sign_when_the_path_is_reversed(points, x, y):
    there, back = Path(points).project(x, y), Path(points[::-1]).project(x, y)
    assert abs(back.cross_track) == pytest.approx(abs(there.cross_track), abs=1e-6)
    unique = abs(there.s + back.s - Path(points).length) < 1e-6  # the same point was nearest
    reversal = np.abs(np.abs(Path(points).turns) - math.pi).min() < 1e-3
    if unique and abs(there.cross_track) > 1e-6 and not reversal:
        assert np.sign(back.cross_track) == -np.sign(there.cross_track)


@given(POINTS, COORDINATE, COORDINATE, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_a_window_bounds_the_arc_length(points, x, y, first, share):
    path = Path(points)
    s_from = first * path.length
    s_to = s_from + share * (path.length - s_from)
    at = path.project(x, y, s_from, s_to)
    assert s_from - 1e-9 <= at.s <= s_to + 1e-9
    sampled = [path.point_at(s) for s in np.linspace(s_from, s_to, 50)]
    assert abs(at.cross_track) <= min(math.hypot(x - px, y - py) for px, py in sampled) + 1e-6


def test_left_of_the_path_is_positive():
    path = Path([[0.0, 0.0], [10.0, 0.0]])
    assert path.project(5.0, 2.0).cross_track == 2.0
    assert path.project(5.0, -2.0).cross_track == -2.0


def test_overshoot_past_a_corner_is_the_distance_to_the_corner_and_on_the_outside():
    path = right_angle(100.0)  # left-hand corner at (100, 0)
    at = path.project(130.0, -40.0)
    assert (at.x, at.y) == (100.0, 0.0)
    assert at.cross_track == pytest.approx(-50.0)
    assert path.project(70.0, 30.0).cross_track == pytest.approx(30.0)


def test_at_a_vertex_the_normal_of_the_bisector_decides_the_side():
    path = Path([[0.0, 0.0], [100.0, 0.0], [0.0, 10.0]])  # a sharp left-hand corner
    assert path.project(110.0, 0.5).cross_track < 0.0
    assert path.project(110.0, -3.0).cross_track < 0.0
    assert path.project(110.0, -3.0, 100.0).cross_track < 0.0  # whatever of it the window holds


def test_the_last_segment_does_not_go_on_where_its_end_is_not_nearest():
    """Prolonged, it crosses the path's own beginning; a vehicle there has not arrived."""
    path = Path([[0, 0], [60, 0], [60, 6], [50, 6], [50, 3]])
    at = path.project(50.0, -0.1, 40.0, 79.0)
    assert at.s == pytest.approx(50.0)
    assert path.project(50.0, 1.5, 78.0).s == pytest.approx(80.5)


def test_a_turn_back_along_the_line_is_never_simplified_away():
    there_and_back = Path([[0.0, 0.0], [3000.0, 0.0], [2800.0, 0.0], [6000.0, 0.0]])
    assert there_and_back.simplify(3.0).tolist() == [0, 1, 2, 3]


def test_the_outer_segments_go_on():
    path = Path([[0.0, 0.0], [10.0, 0.0], [20.0, 10.0]])
    before = path.project(-5.0, 3.0)
    assert (before.s, before.cross_track) == (-5.0, 3.0)
    assert path.project(25.0, 15.0).s == pytest.approx(path.length + math.hypot(5.0, 5.0))
    assert path.point_at(-5.0) == (-5.0, 0.0)


def test_a_forward_window_does_not_jump_at_a_crossing():
    loop = Path([[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [50.0, 100.0], [50.0, -50.0]])
    assert loop.project(50.0, -1.0, 40.0, 80.0).s == pytest.approx(50.0)
    assert loop.project(50.0, -1.0, 300.0, 390.0).s == pytest.approx(351.0)


def test_turns_of_a_square_are_right_angles():
    path = Path([[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]])
    assert np.allclose(path.turns, [0.0, *[math.pi / 2] * 3, 0.0])
    assert path.length == 40.0


def test_headings_are_unwrapped_around_a_circle():
    path = circle(100.0, 3.0, 1.0)
    assert path.headings[-1] - path.headings[0] == pytest.approx(6 * math.pi, abs=0.05)
    assert path.with_tolerance(0.1).mean_curvature(100.0, 150.0) == pytest.approx(0.01, rel=1e-4)


def test_the_heading_turns_gradually_along_a_curve_and_at_once_at_a_corner():
    curve = circle(100.0, 0.5, 5.0).with_tolerance(0.05)
    assert curve.heading_at(curve.s[6]) == pytest.approx(0.05 * 6, rel=1e-6)
    corner = right_angle(100.0).with_tolerance(0.05)
    assert corner.heading_at(99.0) == 0.0
    assert corner.heading_at(101.0) == pytest.approx(math.pi / 2)


@given(POINTS, st.floats(0.5, 50.0))
def test_resampling_keeps_the_ends_and_never_lengthens(points, spacing):
    path = Path(points)
    line = resampled(path.points, path.s, spacing)
    steps = np.hypot(*np.diff(line, axis=0).T)
    assert np.allclose(line[[0, -1]], path.points[[0, -1]])
    assert steps.sum() <= path.length + 1e-6
    assert steps.max() <= spacing + 1e-6


@given(POINTS, st.floats(0.1, 50.0))
def test_simplifying_stays_within_the_tolerance(points, tolerance):
    path = Path(points)
    kept = path.simplify(tolerance)
    assert kept[0] == 0
    assert kept[-1] == len(points) - 1
    for a, b in pairwise(kept):
        if (points[a] != points[b]).any():
            inner = Path(points[[a, b]])
            for x, y in points[a : b + 1]:
                foot = np.clip(inner.project(x, y).s, 0.0, inner.length)
                px, py = inner.point_at(foot)
                assert math.hypot(x - px, y - py) <= tolerance * (1 + 1e-9) + 1e-9


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ([[0.0, 0.0]], "at least two points"),
        (np.empty((0, 2)), "at least two points"),
        ([[0.0, 0.0], [math.nan, 1.0]], "point 2 is"),
        ([[0.0, 0.0], [1.0, math.inf]], "must be finite"),
        ([[0.0, 0.0], [1.0, 1.0], [1.0, 1.0]], "points 2 and 3 are in the same place"),
        ([[0.0, 0.0, 1.0], [0.0, 0.0, 9.0]], "points 1 and 2 are in the same place"),
        ([[0.0], [1.0]], "rows of x, y"),
        ([[0.0, 0.0], [1e300, 0.0]], "beyond 1e"),
    ],
)
def test_what_is_no_path_is_refused_in_one_line(points, message):
    with pytest.raises(InputError, match=message) as error:
        Path(np.array(points))
    assert "\n" not in str(error.value)


def test_a_path_cannot_be_changed():
    source = np.array([[0.0, 0.0], [1.0, 1.0]])
    path = Path(source)
    source[0] = 5.0
    assert path.points[0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        path.points[0, 0] = 1.0
