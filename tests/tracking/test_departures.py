import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.departures import delays, in_runs, least_waiting, too_close
from tracking.separation import separation, separation_min
from tracking.track import Track

SPEED = 50.0  # [m/s]


def flight(start, course, seconds):
    t = np.linspace(0.0, seconds, 20 * seconds + 1)
    x, y = (start[i] + SPEED * t * (math.cos(course), math.sin(course))[i] for i in (0, 1))
    return Track(("t", "x", "y", "z"), np.column_stack([t, x, y, np.zeros(len(t))]), "completed")


def places(start, course, seconds):
    track = flight(start, course, seconds)
    return np.column_stack([track[axis][::20] for axis in "xyz"])


def test_square_crossings_are_too_close_within_root_two_distances():
    """Relative to each other they move at 45 deg: the smallest distance is V |delay| / sqrt(2)."""
    east, north = places((-2000.0, 0.0), 0.0, 80), places((0.0, -2000.0), math.pi / 2, 80)
    ((first, last),) = too_close(east, north, 700.0)
    assert (first, last) == (-19, 19)
    assert math.sqrt(2.0) * 700.0 / SPEED == pytest.approx(19.8, abs=0.01)


def test_on_one_track_they_are_too_close_until_the_first_is_gone():
    one = places((0.0, 0.0), 0.0, 60)
    assert too_close(one, one, 100.0) == [(-1, 1)]  # exactly 100 m after two seconds
    other = places((3000.0, 0.0), math.pi, 60)
    assert too_close(one, other, 100.0) == [(-60, 60)]


def test_what_stays_apart_needs_no_delay():
    tracks = [flight((0.0, 1000.0 * i), 0.0, 30) for i in range(3)]
    assert delays(tracks, 999.0) == (0.0, 0.0, 0.0)


def test_delays_keep_the_distance_they_were_asked_for():
    tracks = [
        flight((-2000.0, 0.0), 0.0, 80),
        flight((0.0, -2000.0), math.pi / 2, 80),
        flight((2000.0, 0.0), math.pi, 80),
    ]
    leaving = delays(tracks, 500.0)
    assert min(leaving) == 0.0
    assert separation_min(separation(tracks, leaving)).value >= 500.0
    for i, delay in enumerate(leaving):
        if delay:
            earlier = [*leaving[:i], delay - 1.0, *leaving[i + 1 :]]
            assert separation_min(separation(tracks, earlier)).value < 500.0


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_what_turns_stays_apart_too(seed):
    """Circles of trucks, 8 m/s at 0.6 g, whose places a second apart are 0.7 m off the straight lines between."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0.0, 20.0, 401)
    tracks = []
    for _ in range(2):
        angle = rng.uniform(0.0, 2.0 * math.pi) + 8.0 / 10.9 * t
        x, y = (rng.uniform(-15.0, 15.0) + 10.9 * turned(angle) for turned in (np.cos, np.sin))
        tracks.append(Track(("t", "x", "y", "z"), np.column_stack([t, x, y, np.zeros(401)]), "completed"))
    assert separation_min(separation(tracks, delays(tracks, 1.001 * 12.0))).value >= 12.0


RUNS = st.lists(st.tuples(st.integers(-6, 6), st.integers(0, 3)), max_size=3)


@settings(max_examples=60, deadline=None)
@given(st.tuples(RUNS, RUNS, RUNS))
def test_the_waiting_is_the_least_there_is(drawn):
    pairs = ((0, 1), (0, 2), (1, 2))
    conflicts = {
        pair: in_runs(sorted({second for low, length in runs for second in range(low, low + length + 1)}))
        for pair, runs in zip(pairs, drawn, strict=True)
    }

    def free(waits):
        return not any(low <= waits[j] - waits[i] <= high for (i, j), runs in conflicts.items() for low, high in runs)

    found = least_waiting(3, conflicts)
    assert free(found)
    best = min(sum(waits) for waits in product(range(22), repeat=3) if min(waits) == 0 and free(waits))
    assert sum(found) == best
