import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.errors import InputError
from sim.wind import Gust, Wind, ground_speed_on_course, heading_for_course, parse_wind


def test_wind_from_the_west_blows_east():
    wind = parse_wind("10@270")
    assert (wind.east, wind.north) == pytest.approx((10.0, 0.0), abs=1e-12)
    assert parse_wind("10m/s@0").north == pytest.approx(-10.0)
    assert wind.from_deg == pytest.approx(270.0)


@given(st.floats(20.0, 100.0), st.floats(-4.0, 4.0), st.floats(0.0, 19.0), st.floats(0.0, 360.0))
def test_air_velocity_plus_wind_is_ground_velocity(airspeed, course, speed, direction):
    wind = Wind.blowing_from(speed, direction)
    heading = heading_for_course(airspeed, course, wind)
    ground_speed = ground_speed_on_course(airspeed, course, wind)
    assert airspeed * math.cos(heading) + wind.east == pytest.approx(ground_speed * math.cos(course), abs=1e-9)
    assert airspeed * math.sin(heading) + wind.north == pytest.approx(ground_speed * math.sin(course), abs=1e-9)


def test_a_course_that_the_wind_does_not_allow_has_no_heading():
    assert math.isnan(heading_for_course(10.0, 0.0, Wind(north=12.0)))
    assert math.isnan(ground_speed_on_course(10.0, 0.0, Wind(north=12.0)))


@pytest.mark.parametrize("text", ["10", "10@west", "-3@270", "10kt@270", "nan@3", "@"])
def test_what_is_no_wind_is_refused(text):
    with pytest.raises(InputError, match=r"wind: .*speed@direction"):
        parse_wind(text)


@given(st.floats(0.0, 100.0), st.floats(0.1, 50.0))
def test_a_gust_rises_and_falls_by_half_a_cosine_each(start, duration):
    gust = Gust(10.0, 0.0, 0.0, start, duration)
    quarters = [gust.share(start + part * duration) for part in (-0.5, 0.0, 0.25, 0.5, 0.75, 1.0, 1.5)]
    assert quarters == pytest.approx([0.0, 0.0, 0.5, 1.0, 0.5, 0.0, 0.0], abs=1e-9)
