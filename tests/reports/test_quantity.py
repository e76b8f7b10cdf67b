import math

import pytest

from planners.units import degrees
from reports.words.quantity import number, pair, span, text, text_with_g


@pytest.mark.parametrize(
    ("value", "unit", "shown"),
    [
        (math.radians(45.0), "rad", "45°"),
        (math.radians(30.0), "rad/s", "30°/s"),
        (42.13, "m", "42.1 m"),
        (530.0, "m", "530 m"),
        (3412.0, "m", "3.41 km"),
        (-1500.0, "m", "−1.5 km"),
        (0.9412, "share", "94.1 %"),
        (0.002, "1/m", "2 1/km"),
        (1.0034, "1", "1.003"),
        (3.8, "g", "3.8 g"),
        (55.0, "m/s", "55 m/s"),
        (0.0, "m", "0 m"),
        (-1e-12, "m", "0 m"),
        (1e-12, "m", "0 m"),
        (12345.0, "s", "12345 s"),
        (math.nan, "m", "n/a"),
        (math.inf, "m", "∞ m"),
        (-math.inf, "s", "−∞ s"),
    ],
)
def test_text(value, unit, shown):
    assert text(value, unit) == shown


def test_acceleration_also_in_g():
    assert text_with_g(0.6 * 9.80665, "m/s^2") == "5.88 m/s² (0.6 g)"
    assert text_with_g(math.nan, "m/s^2") == "n/a"
    assert text_with_g(3.0, "m") == "3 m"


def test_a_missed_limit_never_looks_met():
    assert pair(30.001, 30.0, "m") == ("30.001 m", "30 m")
    assert pair(0.9996, 1.0, "share") == ("99.96 %", "100 %")
    assert pair(42.1, 30.0, "m") == ("42.1 m", "30 m")


def test_a_met_limit_keeps_its_few_digits():
    assert pair(29.99999, 30.0, "m", met=True) == ("30 m", "30 m")


def test_pair_ends_for_equal_numbers():
    assert pair(30.0, 30.0, "m") == ("30 m", "30 m")


@pytest.mark.parametrize(("value", "shown"), [(0.00004, "0.00004"), (1234.5, "1234"), (0.05, "0.05"), (99.96, "100")])
def test_number_has_no_exponent(value, shown):
    assert number(value) == shown


def test_degrees_for_machines():
    assert degrees(math.pi, "rad") == (180.0, "deg")
    assert degrees(math.pi, "rad/s") == (180.0, "deg/s")
    assert degrees(5.0, "m/s^2") == (5.0, "m/s^2")


@pytest.mark.parametrize(
    ("low", "high", "shown"),
    [
        (60.0, 107.0, "60 – 107 m"),
        (80.0, 80.0, "80 m"),
        (990.0, 1200.0, "990 m – 1.2 km"),
        (16_201.0, 16_203.0, "16.201 – 16.203 km"),
    ],
)
def test_span(low, high, shown):
    assert span(low, high, "m") == shown
