import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from campaigns.distribution import MOST_DRAWS, Distribution, drawn
from planners.errors import InputError

COUNT = 40_000
DISTRIBUTIONS = (
    Distribution(normal=(3.0, 2.0)),
    Distribution(uniform=(-1.0, 5.0)),
    Distribution(weibull=(2.0, 8.0)),
    Distribution(weibull=(0.8, 3.0)),
)


def closed_form(distribution):
    """Mean and standard deviation."""
    if distribution.normal:
        return distribution.normal
    if distribution.uniform:
        a, b = distribution.uniform
        return (a + b) / 2, (b - a) / math.sqrt(12.0)
    shape, scale = distribution.weibull
    first, second = math.gamma(1.0 + 1.0 / shape), math.gamma(1.0 + 2.0 / shape)
    return scale * first, scale * math.sqrt(second - first**2)


def rng(seed=0):
    return np.random.default_rng(seed)


def name_of(distribution):
    return str(distribution).removeprefix("Distribution")


@pytest.mark.parametrize("distribution", DISTRIBUTIONS, ids=name_of)
def test_draws_have_the_mean_and_deviation_of_the_closed_form(distribution):
    """Within five standard errors, from the draws' own fourth moment for the deviation."""
    source = rng()
    values = np.array([drawn(distribution, source, "p") for _ in range(COUNT)])
    mean, deviation = closed_form(distribution)
    fourth = np.mean((values - mean) ** 4)
    assert values.mean() == pytest.approx(mean, abs=5.0 * deviation / math.sqrt(COUNT))
    assert values.var() == pytest.approx(deviation**2, abs=5.0 * math.sqrt((fourth - deviation**4) / COUNT))


def test_a_weibull_of_shape_one_is_the_exponential():
    """P(X > scale) = 1/e; five standard errors of a share of 40,000."""
    source = rng()
    above = np.mean([drawn(Distribution(weibull=(1.0, 7.0)), source, "p") > 7.0 for _ in range(COUNT)])
    assert above == pytest.approx(math.exp(-1.0), abs=5.0 * 0.5 / math.sqrt(COUNT))


@given(st.floats(-1e6, 1e6), st.integers(0, 2**53))
def test_a_fixed_value_passes_unchanged_and_draws_nothing(value, seed):
    source, fresh = rng(seed), rng(seed)
    assert drawn(value, source, "p") == value
    assert source.random() == fresh.random()


@given(st.floats(-5.0, 5.0), st.floats(0.01, 5.0), st.integers(0, 2**53))
def test_draws_stay_within_their_bounds(low, width, seed):
    value = drawn(Distribution(uniform=(-20.0, 20.0)), rng(seed), "p", low - 1.0, low + width)
    assert low - 1.0 <= value <= low + width


def test_what_falls_outside_is_drawn_again_not_moved_to_the_bound():
    """A normal cut at its mean is the half-normal, whose mean is sd sqrt(2 / pi)."""
    source = rng()
    values = np.array([drawn(Distribution(normal=(0.0, 1.0)), source, "p", low=0.0) for _ in range(COUNT)])
    assert (values > 0.0).all()
    assert values.mean() == pytest.approx(math.sqrt(2.0 / math.pi), abs=5.0 * 0.6028 / math.sqrt(COUNT))


def test_a_distribution_without_spread_is_its_value():
    assert drawn(Distribution(normal=(4.0, 0.0)), rng(), "p") == 4.0
    assert drawn(Distribution(uniform=(4.0, 4.0)), rng(), "p") == 4.0
    assert drawn(Distribution(normal=(0.0, 0.0)), rng(), "p") == 0.0


def refused(value, low=-math.inf, high=math.inf, place="conditions.mass"):
    with pytest.raises(InputError) as caught:
        drawn(value, rng(), place, low, high)
    text = str(caught.value)
    assert text.startswith(f"{place}: ")
    assert "\n" not in text
    return text


@pytest.mark.parametrize(
    ("distribution", "low", "high", "limits"),
    [
        (Distribution(normal=(-5.0, 0.1)), 0.0, math.inf, "0 or more"),
        (Distribution(uniform=(8.0, 9.0)), 0.0, 7.0, "0 to 7"),
        (Distribution(weibull=(2.0, 1e-9)), 0.01, 100.0, "0.01 to 100"),
    ],
)
def test_a_distribution_that_never_gets_inside_is_refused(distribution, low, high, limits):
    assert refused(distribution, low, high).endswith(f"choose one with values {limits}")


def test_a_distribution_that_seldom_gets_inside_is_drawn():
    """One draw in a hundred is inside: that a thousand are not has a chance of 4e-5."""
    assert MOST_DRAWS >= 1000
    for seed in range(20):
        assert 0.0 <= drawn(Distribution(uniform=(0.0, 100.0)), rng(seed), "p", 0.0, 1.0) <= 1.0


@pytest.mark.parametrize("value", [-0.1, 7.1, math.nan, math.inf, -math.inf])
def test_a_fixed_value_outside_is_refused(value):
    assert "is out of range; choose 0 to 7" in refused(value, 0.0, 7.0)


@pytest.mark.parametrize("value", [0.0, 3.5, 7.0])
def test_the_bounds_themselves_are_inside(value):
    assert drawn(value, rng(), "p", 0.0, 7.0) == value


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("name", ["normal", "uniform", "weibull"])
@pytest.mark.parametrize("position", [0, 1])
def test_a_parameter_that_is_not_finite_is_refused(name, bad, position):
    pair = [1.0, 1.0]
    pair[position] = bad
    assert "not finite" in refused(Distribution(**{name: tuple(pair)}))


@pytest.mark.parametrize(
    ("distribution", "why"),
    [
        (Distribution(normal=(0.0, -1.0)), "deviation -1 is negative"),
        (Distribution(uniform=(2.0, 1.0)), "runs backwards"),
        (Distribution(weibull=(0.0, 1.0)), "is none"),
        (Distribution(weibull=(2.0, 0.0)), "is none"),
        (Distribution(weibull=(2.0, -1.0)), "is none"),
        (Distribution(), "names no distribution"),
        (Distribution(normal=(0.0, 1.0), uniform=(0.0, 1.0)), "names 2 distributions"),
        (Distribution(normal=(0.0, 1.0), uniform=(0.0, 1.0), weibull=(1.0, 1.0)), "names 3 distributions"),
    ],
)
def test_what_is_no_distribution_is_refused(distribution, why):
    assert why in refused(distribution)


def test_a_range_too_wide_for_a_number_is_refused():
    refused(Distribution(uniform=(-1e308, 1e308)))
