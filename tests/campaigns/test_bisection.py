"""Bisection for a border, whichever end of the range is the easy one."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from campaigns.bisection import border

LOW, HIGH = 0.5, 100.0


@given(st.floats(0.6, 90.0), st.floats(0.001, 0.5))
def test_the_smallest_that_holds_is_found_to_the_tolerance(least, tolerance):
    found, beyond = border(lambda value: value >= least, HIGH, LOW, tolerance)
    assert beyond < least <= found <= (1.0 + tolerance) * beyond


@given(st.floats(0.6, 90.0), st.floats(0.001, 0.5))
def test_the_largest_that_holds_is_found_to_the_tolerance(most, tolerance):
    found, beyond = border(lambda value: value <= most, LOW, HIGH, tolerance)
    assert found <= most < beyond <= (1.0 + tolerance) * found


def test_it_takes_no_more_tries_than_the_logarithm_says():
    """The interval of logarithms is halved each time, after both ends."""
    tried = []
    border(lambda value: tried.append(value) or value >= 7.0, HIGH, LOW, 0.02)
    assert len(tried) == len(set(tried)) == 2 + math.ceil(math.log2(math.log(HIGH / LOW) / math.log(1.02)))


@pytest.mark.parametrize(("near", "far"), [(LOW, HIGH), (HIGH, LOW)])
def test_where_nothing_or_everything_holds_the_ends_tell(near, far):
    assert border(lambda _: False, near, far, 0.02) == (None, near)
    assert border(lambda _: True, near, far, 0.02) == (far, None)


@pytest.mark.parametrize(("near", "far"), [(2.5, HIGH), (HIGH, LOW)])
def test_where_it_holds_in_parts_one_of_the_borders_is_found(near, far):
    def holds(value):
        return 2.0 <= value <= 3.0 or 50.0 <= value <= 100.0

    found, beyond = border(lambda value: holds(value) and value != far, near, far, 0.02)
    assert holds(found)
    assert not holds(beyond) or beyond == far
    assert max(found, beyond) <= 1.02 * min(found, beyond)
