import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.path import Path
from sim.vehicle import Conditions
from sim.vehicles import make_vehicle
from tracking.feasibility import assess
from tracking.outcome import Outcome
from tracking.profile import PIECES, error_profile
from tracking.track import GUIDANCE_COLUMNS, STATE_COLUMNS, Track
from tracking.trial import Trial, run_trial
from tracking.verdict import Verdict

LIMITS = make_vehicle("truck").limits
LINE = Path([[0.0, 0.0], [500.0, 0.0]])
MIDDLES = (np.arange(PIECES) + 0.5) / PIECES  # of the pieces, as shares of the path


def outcome_along(x, y, path=LINE):
    """The outcome of a track through x, y (N,) at 10 m/s."""
    x, y = np.asarray(x, dtype=float), np.broadcast_to(np.asarray(y, dtype=float), len(x))
    at = [path.project(*point) for point in zip(x, y, strict=True)]
    values = {
        "t": np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))]) / 10.0,
        "x": x,
        "y": y,
        "s": [p.s for p in at],
        "cross_track": [p.cross_track for p in at],
    }
    names = (*STATE_COLUMNS, *GUIDANCE_COLUMNS)
    data = np.column_stack([np.broadcast_to(values.get(name, 0.0), len(x)) for name in names])
    conditions = Conditions()
    return Outcome(
        "p", path, None, "truck", LIMITS, "lqr", 10.0, 0.5, conditions, 0, Track(names, data, "completed"), {},
        assess(path, LIMITS, 10.0, conditions.wind, 0.5), Verdict(()),
    )  # fmt: skip


@given(st.floats(-3.0, 3.0), st.integers(2, 2000))
def test_a_constant_error_is_the_same_in_every_piece(e, samples):
    profile = error_profile(outcome_along(np.linspace(0.0, 500.0, samples), e))
    assert profile.shape == (PIECES,)
    assert profile == pytest.approx(np.full(PIECES, e), abs=1e-9)


def test_an_error_that_grows_along_the_path_grows_along_the_profile():
    """Within half a sample, 0.05 m of the way at a slope of 1 %."""
    x = np.linspace(0.0, 500.0, 5001)
    assert error_profile(outcome_along(x, 0.01 * x - 1.0)) == pytest.approx(5.0 * MIDDLES - 1.0, abs=0.01 * 0.051)


def test_a_piece_is_the_mean_by_distance_and_not_by_samples():
    """Ten times as many samples in the first half of every piece: counted alike, they would take 1 m off its middle."""
    halves = np.arange(0.0, 500.0, 2.5)
    steps = [np.arange(0.0, 2.5, 0.025 if i % 2 == 0 else 0.25) for i in range(len(halves))]
    x = np.concatenate([*(start + step for start, step in zip(halves, steps, strict=True)), [500.0]])
    assert error_profile(outcome_along(x, 0.01 * x)) == pytest.approx(5.0 * MIDDLES, abs=0.01 * 0.15)


def test_left_is_positive():
    profile = error_profile(outcome_along(np.linspace(0.0, 500.0, 501), -0.4))
    assert (profile < 0.0).all()


def test_path_that_was_not_reached_counts_with_its_distance():
    profile = error_profile(outcome_along(np.linspace(0.0, 250.0, 501), 0.0))
    assert np.abs(profile[:49]).max() == 0.0
    # Piece 50 holds the last sample too, whose quarter of a metre is without error
    assert abs(profile[50]) == pytest.approx(2.5 * 5.0 / 5.25, abs=1e-6)
    assert np.abs(profile[51:]) == pytest.approx(500.0 * MIDDLES[51:] - 250.0, abs=1e-6)


def test_path_that_was_not_reached_counts_on_the_side_of_the_tracks_bias():
    right = error_profile(outcome_along(np.linspace(0.0, 250.0, 501), -0.3))
    assert (right[50:] < 0.0).all()
    assert right[-1] == pytest.approx(-np.hypot(500.0 * MIDDLES[-1] - 250.0, 0.3), abs=0.05)


@pytest.mark.parametrize("samples", [2, 3, 7])
def test_a_path_of_fewer_samples_than_pieces_has_a_whole_profile(samples):
    path = Path([[0.0, 0.0], [2.0, 0.0]])
    x = np.linspace(0.0, 2.0, samples)
    profile = error_profile(outcome_along(x, 0.1 * x, path))
    inner = slice(PIECES // samples, -(PIECES // samples))
    assert profile.shape == (PIECES,)
    assert (np.diff(profile) >= 0.0).all()
    assert (profile[0], profile[-1]) == pytest.approx((0.0, 0.2), abs=1e-9)
    assert profile[inner] == pytest.approx(0.2 * MIDDLES[inner], abs=0.002)  # a sample stands anywhere in its piece


def test_a_single_sample_has_a_whole_profile():
    profile = error_profile(outcome_along([0.0], 0.2))
    assert profile.shape == (PIECES,)
    assert np.isfinite(profile).all()
    assert profile[-1] == pytest.approx(np.hypot(500.0 * MIDDLES[-1], 0.2), abs=0.6)


def test_a_real_run_has_the_profile_of_its_track():
    path = Path([[0.0, 0.0], [200.0, 0.0]])
    outcome = run_trial(Trial("r", path, "truck", speed=10.0))
    track = outcome.track
    assert error_profile(outcome) == pytest.approx(
        np.interp(200.0 * MIDDLES, track["s"], track["cross_track"]), abs=1e-3
    )
