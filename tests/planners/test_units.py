import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.errors import InputError
from planners.units import parse_speed, wrap


@pytest.mark.parametrize(
    ("text", "speed"),
    [("55", 55.0), ("55m/s", 55.0), ("30km/h", 30 / 3.6), ("100kt", 51.4444), (" 4.5 m/s ", 4.5), (12.5, 12.5)],
)
def test_speeds_are_read_with_their_units(text, speed):
    assert parse_speed(text) == pytest.approx(speed, rel=1e-5)


@pytest.mark.parametrize("text", ["fast", "10mph", "-3", "0", "nan", "1e999", ""])
def test_what_is_no_speed_is_refused(text):
    with pytest.raises(InputError, match="speed"):
        parse_speed(text)


@given(st.floats(-100.0, 100.0))
def test_wrapping_keeps_the_direction_within_half_a_turn(angle):
    wrapped = wrap(angle)
    assert -math.pi <= wrapped <= math.pi
    assert math.cos(wrapped - angle) == pytest.approx(1.0)
