import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import binom

from campaigns.attempt import Measured
from campaigns.statistics import clopper_pearson, error_band, statistics
from campaigns.store import Row
from tracking.profile import PIECES

BETTER = {"error": "lower", "completion": "higher", "bias": "neither"}


def row(trial, metrics=None, profile=0.0, trackworthy=True, passed=True, error="", kind=""):
    measured = {name: Measured(value, None, None) for name, value in (metrics or {}).items()}
    whole = b"" if error else np.broadcast_to(np.asarray(profile, np.float32), PIECES).tobytes()
    return Row(trial, 1000 + trial, error, kind, trackworthy, passed, 0.0, "", "completed", measured, whole)


def of_values(name, values):
    rows = [row(trial, {name: value}) for trial, value in enumerate(values, start=1)]
    return statistics(rows, BETTER).metrics[name]


# Shares


@given(st.integers(1, 3000))
def test_none_and_all_have_intervals_in_closed_form(n):
    """0 of n: up to 1 - (alpha/2)^(1/n); n of n: from (alpha/2)^(1/n)."""
    edge = 0.025 ** (1.0 / n)
    assert clopper_pearson(0, n) == pytest.approx((0.0, 1.0 - edge), abs=1e-9)
    assert clopper_pearson(n, n) == pytest.approx((edge, 1.0), abs=1e-9)


@pytest.mark.parametrize(
    ("successes", "tries", "low", "high"),
    [  # Newcombe 1998, Statistics in Medicine 17, 857-872, table I, method 5
        (81, 263, 0.2527, 0.3676),
        (15, 148, 0.0578, 0.1617),
        (0, 20, 0.0000, 0.1684),
        (1, 29, 0.0009, 0.1776),
    ],
)
def test_clopper_and_pearsons_interval_as_tabulated(successes, tries, low, high):
    assert clopper_pearson(successes, tries) == pytest.approx((low, high), abs=0.00005)


def test_conovers_table():
    """5 of 25: 0.068 to 0.407 (Conover 1999, Practical Nonparametric Statistics, table A4)."""
    assert clopper_pearson(5, 25) == pytest.approx((0.068, 0.407), abs=0.0005)


@given(st.integers(2, 500), st.data())
def test_at_either_end_of_the_interval_what_was_seen_has_a_chance_of_a_fortieth(n, data):
    """Clopper and Pearson's own definition (Biometrika 26, 1934)."""
    k = data.draw(st.integers(1, n - 1))
    low, high = clopper_pearson(k, n)
    assert binom.sf(k - 1, n, low) == pytest.approx(0.025, rel=1e-5)
    assert binom.cdf(k, n, high) == pytest.approx(0.025, rel=1e-5)


def test_without_tries_nothing_is_known():
    assert clopper_pearson(0, 0) == (0.0, 1.0)
    nothing = statistics([], BETTER)
    assert (nothing.tried, nothing.errors, nothing.share, nothing.interval) == (0, 0, 0.0, (0.0, 1.0))
    assert nothing.metrics == {}
    assert nothing.band is None


def test_trials_are_counted():
    rows = [row(1), row(2, trackworthy=False, passed=True), row(3, trackworthy=False, passed=False), row(4)]
    found = statistics(rows, BETTER)
    assert (found.tried, found.trackworthy, found.passed, found.errors) == (4, 2, 3, 0)
    assert found.share == 0.5
    assert found.interval == clopper_pearson(2, 4)
    assert found.seeds == (1001, 1002, 1003, 1004)
    assert found.trials == (1, 2, 3, 4)


def test_trials_with_an_error_are_counted_and_not_measured():
    clean = [row(1, {"error": 1.0}, 0.1), row(3, {"error": 3.0}, 0.3, trackworthy=False)]
    broken = [row(0, error="first", kind="died"), row(2, error="second", kind="input", trackworthy=True)]
    found = statistics([broken[0], clean[0], broken[1], clean[1]], BETTER)
    alone = statistics(clean, BETTER)
    assert (found.errors, found.first_error, found.kinds) == (2, "first", {"died", "input"})
    assert (found.tried, found.trackworthy, found.share, found.interval) == (2, 1, 0.5, clopper_pearson(1, 2))
    assert found.trials == (1, 3)
    assert found.metrics == alone.metrics
    assert (found.bias, found.spread) == (alone.bias, alone.spread)
    assert found.values.tolist() == [[1.0], [3.0]]


def test_errors_alone_leave_nothing_to_measure():
    found = statistics([row(1, error="no", kind="machinery")], BETTER)
    assert (found.errors, found.tried, found.share) == (1, 0, 0.0)
    assert found.metrics == {}


# Metrics

HUNDRED = [float(value) for value in np.random.default_rng(0).permutation(np.arange(101))]


def test_the_bad_end_is_the_upper_one_where_lower_is_better():
    found = of_values("error", HUNDRED)
    assert (found.median, found.p95, found.worst) == (50.0, 95.0, 100.0)
    assert found.worst_trial == HUNDRED.index(100.0) + 1
    assert found.count == 101


def test_the_bad_end_is_the_lower_one_where_higher_is_better():
    found = of_values("completion", HUNDRED)
    assert (found.median, found.p95, found.worst) == (50.0, 5.0, 0.0)
    assert found.worst_trial == HUNDRED.index(0.0) + 1


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_worst_of_what_has_no_direction_is_the_largest_size(sign):
    found = of_values("bias", [sign * value for value in (0.5, -3.0, 2.0)])
    assert (found.worst, found.worst_trial) == (-3.0 * sign, 2)


def test_the_bad_end_of_what_has_no_direction_is_the_large_one():
    assert of_values("bias", [-value for value in HUNDRED]).p95 == -95.0


def test_of_equally_bad_trials_the_first_is_named():
    assert of_values("error", [1.0, 4.0, 2.0, 4.0]).worst_trial == 2


def test_a_metric_of_unknown_direction_is_better_when_lower():
    rows = [row(trial, {"other": value}) for trial, value in enumerate((1.0, -5.0, 2.0), start=1)]
    assert statistics(rows, {}).metrics["other"].worst == 2.0


@given(st.lists(st.one_of(st.none(), st.floats(-1e6, 1e6)), min_size=1, max_size=30))
def test_what_was_not_measured_does_not_disturb(values):
    rows = [row(trial, {"error": value, "completion": 1.0}) for trial, value in enumerate(values, start=1)]
    found, known = statistics(rows, BETTER), [value for value in values if value is not None]
    assert found.metrics["completion"].count == len(values)
    assert found.values.shape == (len(values), 2)
    if not known:
        assert "error" not in found.metrics
        return
    metric = found.metrics["error"]
    assert (metric.count, metric.worst) == (len(known), max(known))
    assert metric.median == pytest.approx(np.median(known))
    assert values[metric.worst_trial - 1] == max(known)


def test_a_metric_that_a_later_trial_lacks_is_not_measured_there():
    found = statistics([row(1, {"error": 1.0, "completion": 0.5}), row(2, {"completion": 0.7})], BETTER)
    assert found.metrics["error"].count == 1
    assert math.isnan(found.values[1, 0])
    assert found.values[:, 1].tolist() == [0.5, 0.7]


# Profiles


def test_steady_bias_is_apart_from_spread():
    """A bias of 0.25 m, and deviations of +-0.5 m about it: all of them numbers that a 32-bit float holds."""
    found = statistics([row(i, profile=0.25 + d) for i, d in enumerate((-0.5, 0.5, 0.5, -0.5), start=1)], BETTER)
    assert (found.bias, found.spread) == (0.25, 0.5)
    assert (found.band.bias == 0.25).all()
    assert (found.band.spread == 0.5).all()
    assert (found.band.median == 0.5).all()  # of 0.25, 0.25, 0.75, 0.75


def test_a_bias_that_changes_along_the_path_is_no_spread_in_the_band():
    ramp = np.linspace(-1.0, 1.0, PIECES)
    band = error_band(np.array([ramp + d for d in (-0.1, 0.0, 0.1)]))
    assert band.bias == pytest.approx(ramp, abs=1e-12)
    assert band.spread == pytest.approx(np.full(PIECES, 0.1 * math.sqrt(2.0 / 3.0)))


def test_errors_to_both_sides_have_no_bias_and_do_not_cancel_in_the_median():
    band = error_band(np.array([[-2.0] * PIECES, [2.0] * PIECES]))
    assert (band.bias == 0.0).all()
    assert (band.median == 2.0).all()


def test_one_trial_has_no_band():
    assert statistics([row(1, profile=0.5)], BETTER).band is None
    assert statistics([row(1, profile=0.5)], BETTER).bias == 0.5


@settings(max_examples=40)
@given(st.integers(2, 40), st.integers(0, 1000))
def test_the_band_contains_the_median_and_lies_within_what_was_seen(count, seed):
    profiles = np.random.default_rng(seed).normal(0.3, 1.0, (count, PIECES))
    band = error_band(profiles)
    size = np.abs(profiles)
    assert (band.low <= band.median).all()
    assert (band.median <= band.high).all()
    assert (size.min(axis=0) <= band.low).all()
    assert (band.high <= size.max(axis=0)).all()


def test_the_band_is_the_same_every_time():
    profiles = np.random.default_rng(1).normal(0.0, 1.0, (15, PIECES))
    one, again, other = error_band(profiles), error_band(np.asfortranarray(profiles)), error_band(profiles + 0.01)
    assert (one.low.tobytes(), one.high.tobytes()) == (again.low.tobytes(), again.high.tobytes())
    assert one.low.tobytes() != other.low.tobytes()


def test_trials_without_deviation_have_a_band_without_width():
    band = error_band(np.full((8, PIECES), -0.7))
    assert (band.low == band.high).all()
    assert (band.high == 0.7).all()


def test_the_band_covers_the_true_median_nineteen_times_of_twenty():
    """The median of abs(e) of normal errors of deviation 1 is 0.67449, and the interval is made for 95 %.

    Of 101 trials, endless resampling gives the 41st to the 61st largest as the interval (P(Binomial(101, k / 101) > 50)
    reaches 2.5 % and 97.5 % there), which covers with P(41 <= Binomial(101, 1/2) < 61) = 95.4 %. 200 resamples know
    those edges with an error, which costs about 1 %. 30 cases of 100 places that know nothing of each other but the
    resampling give the share with a standard error of 0.5 %. So: 95.4 % less 1 %, and three standard errors either way.
    """
    rng = np.random.default_rng(7)
    covered = []
    for _ in range(30):
        band = error_band(rng.normal(0.0, 1.0, (101, PIECES)))
        covered.append((band.low <= 0.67449) & (band.high >= 0.67449))
    exact = binom.cdf(60, 101, 0.5) - binom.cdf(40, 101, 0.5)
    assert exact == pytest.approx(0.954, abs=0.0005)
    assert np.mean(covered) == pytest.approx(exact - 0.01, abs=0.015)
