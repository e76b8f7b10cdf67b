import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.needed import curvature_needed, lateral_acceleration_needed
from planners.path import Path
from planners.units import STANDARD_GRAVITY
from sample_paths import circle, right_angle


def turning(step, turn, count=12, run_up=0.0):
    """A polyline of `count` legs of `step` [m] that turns by `turn` [rad] at each vertex, after a straight."""
    headings = turn * np.arange(count)
    legs = step * np.column_stack([np.cos(headings), np.sin(headings)])
    points = np.concatenate([[[0.0, 0.0]], np.cumsum(legs, axis=0)])
    return Path(points if run_up == 0.0 else np.concatenate([[[-run_up, 0.0]], points]))


@given(st.floats(5.0, 200.0), st.floats(0.02, 0.5), st.floats(0.3, 8.0))
def test_chords_of_a_circle_need_its_curvature_wherever_one_looks(radius, angle, distance):
    """Their length is 2 R sin(a / 2) and they turn by a: a little more than 1 / R."""
    path = circle(radius, 0.5 + 2 * distance / radius, angle * radius)
    s, curvature = curvature_needed(path, distance)
    leg = path.s[1]
    inner = (s > distance / 2 + leg / 2) & (s < path.length - distance / 2 - leg / 2)
    longest = min(distance / leg, 1.0)  # legs longer than that are straight in their middle
    if longest == 1.0:
        assert curvature[inner] == pytest.approx(angle / leg, rel=1e-9)
        assert 1 / radius <= angle / leg <= 1.011 / radius
    else:
        assert curvature.max() == pytest.approx(angle / distance, rel=1e-9)


@pytest.mark.parametrize(("kmh", "turn_deg", "g"), [(30, 36.0, 1.07), (45, 30.0, 1.33), (60, 18.0, 1.07)])
def test_the_paths_that_paper_004_prints_need_far_more_than_its_limit(kmh, turn_deg, g):
    """Its Tables 3 and 4: turns of 36, 30 and 18 deg, one every v * 0.5 s; v^2 d / r, beside its limit of 0.6 g."""
    speed = kmh / 3.6
    s, needed = lateral_acceleration_needed(turning(0.5 * speed, math.radians(turn_deg), run_up=30.0), speed)
    assert np.abs(needed).max() == pytest.approx(speed * math.radians(turn_deg) / 0.5)
    assert np.abs(needed).max() / STANDARD_GRAVITY == pytest.approx(g, abs=0.005)
    assert np.all(needed[s < 30.0 - 0.75 * speed] == 0.0)


def test_at_a_radius_it_is_speed_squared_over_the_radius():
    _, needed = lateral_acceleration_needed(circle(50.0, 0.5, 0.5, run_up=40.0), 12.5)
    assert needed.max() == pytest.approx(12.5**2 / 50.0, rel=1e-4)
    assert needed.min() == 0.0


def test_a_straight_path_needs_nothing_however_it_is_sampled():
    x = np.sort(np.random.default_rng(1).uniform(0.0, 200.0, 60))
    assert not np.any(lateral_acceleration_needed(Path(np.column_stack([x, np.zeros(60)])), 10.0)[1])


@pytest.mark.parametrize("distance", [1.0, 6.25, 30.0])
def test_a_corner_alone_is_turned_over_the_distance_and_worst_at_itself(distance):
    s, curvature = curvature_needed(right_angle(100.0), distance)
    assert curvature.max() == pytest.approx(math.pi / 2 / distance)
    assert s[curvature.argmax()] == pytest.approx(100.0)
    assert not np.any(curvature[np.abs(s - 100.0) >= distance])


def test_opposite_corners_within_the_distance_cancel():
    """A lane change in 1 m and back to the old heading, seen over 10 m, is no turn at all in its middle."""
    path = Path([[0.0, 0.0], [50.0, 0.0], [51.0, 1.0], [101.0, 1.0]])
    s, curvature = curvature_needed(path, 10.0)
    assert np.interp(50.0 + math.sqrt(0.5), s, curvature) == pytest.approx(0.0, abs=1e-9)
    assert np.abs(curvature).max() <= math.pi / 4 / 10.0 + 1e-12


def test_corners_within_the_distance_add_up():
    """Twice 45 deg at 1 m, each spread over 5 m to its outside and 0.5 m to its inside: 0.5 m of each is not seen."""
    path = Path([[0.0, 0.0], [50.0, 0.0], [50.0 + math.sqrt(0.5), math.sqrt(0.5)], [50.0 + math.sqrt(0.5), 50.0]])
    assert curvature_needed(path, 10.0)[1].max() == pytest.approx(math.pi / 2 / 10.0 * (1.0 - 0.5 / 5.5))


@given(st.floats(0.5, 1.0), st.integers(0, 1000))
def test_steps_snapped_to_pixels_change_it_little(share, seed):
    """Steps of 0.5 to 1 times the distance of a steering action, at random, with the same turn for the same way."""
    steps = np.random.default_rng(seed).uniform(share, 1.0, 40)
    turns = 0.1 * (steps[:-1] + steps[1:]) / 2
    headings = np.concatenate([[0.0], np.cumsum(turns)])
    points = np.cumsum(steps[:, None] * np.column_stack([np.cos(headings), np.sin(headings)]), axis=0)
    s, curvature = curvature_needed(Path(np.concatenate([[[0.0, 0.0]], points])), 1.0)
    inner = (s > 1.0) & (s < steps.sum() - 1.0)
    assert curvature[inner] == pytest.approx(0.1, rel=1e-9)


@given(st.integers(0, 1000), st.floats(0.5, 50.0))
def test_the_whole_turn_is_there_once_and_mirroring_turns_its_sign(seed, distance):
    """The integral of the curvature is the turn from the first leg to the last one, where both are long enough."""
    inner = np.random.default_rng(seed).uniform(-30.0, 30.0, (6, 2))
    points = np.vstack([inner[0] - [200.0, 0.0], inner, inner[-1] + [0.0, 200.0]])
    path = Path(points)
    s, curvature = curvature_needed(path, distance)
    assert np.all(np.diff(s) > 0.0)
    assert (s[0], s[-1]) == (0.0, path.length)
    assert np.trapezoid(curvature, s) == pytest.approx(path.turns.sum())
    s, mirrored = curvature_needed(Path(points * [1.0, -1.0]), distance)
    assert np.trapezoid(mirrored, s) == pytest.approx(-path.turns.sum())
