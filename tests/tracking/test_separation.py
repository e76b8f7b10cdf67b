import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.path import FARTHEST
from tracking.separation import nearest, separation, separation_min
from tracking.track import Track


def straight(start, velocity, seconds=100.0, period=0.05):
    t = np.arange(0.0, seconds + period / 2, period)
    return Track(
        ("t", "x", "y", "z"), np.column_stack([t, *(np.outer(velocity, t) + np.array([start]).T)]), "completed"
    )


@given(st.floats(-500.0, 500.0), st.floats(1.0, 150.0), st.floats(1.0, 150.0))
def test_vehicles_that_pass_each_other_are_as_near_as_their_tracks(aside, speed, other):
    """Also between the samples: at 300 m/s they are 15 m apart."""
    here, there = straight((0.0, 0.0, 0.0), (speed, 0.0, 0.0)), straight((100.0, aside, 0.0), (-other, 0.0, 0.0))
    metric = separation_min(separation([here, there], [0.0, 0.0]))
    assert metric.value == pytest.approx(abs(aside), abs=1e-6)
    assert metric.t == pytest.approx(100.0 / (speed + other), abs=1e-3)
    assert metric.who == "1 and 2"


def test_heights_count():
    low, high = straight((0.0, 0.0, 0.0), (50.0, 0.0, 0.0)), straight((30.0, 0.0, 40.0), (50.0, 0.0, 0.0))
    assert separation_min(separation([low, high], [0.0, 0.0])).value == pytest.approx(50.0)


def test_who_is_not_under_way_keeps_away_from_nobody():
    one, other = straight((0.0, 0.0, 0.0), (50.0, 0.0, 0.0)), straight((0.0, 10.0, 0.0), (50.0, 0.0, 0.0))
    later = separation([one, other], [0.0, 150.0])
    assert np.isnan(later.distances).all()
    metric = separation_min(later)
    assert (metric.value, metric.valid, metric.who) == (FARTHEST, True, "")
    assert "never two" in metric.note


def test_of_three_the_closest_pair_counts():
    tracks = [straight((0.0, y, 0.0), (50.0, 0.0, 0.0)) for y in (0.0, 500.0, 620.0)]
    metric = separation_min(separation(tracks, [0.0, 0.0, 0.0]))
    assert (metric.value, metric.who) == (pytest.approx(120.0), "2 and 3")


def test_the_nearest_of_nothing_is_infinitely_far():
    assert nearest(np.empty((0, 3)))[0] == math.inf
    assert nearest(np.full((3, 3), np.nan))[0] == math.inf
