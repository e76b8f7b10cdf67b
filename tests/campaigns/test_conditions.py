import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from campaigns.conditions import CALM, ConditionKeys, DrydenKeys, GustKeys, WindKeys, draw, known_wind
from campaigns.distribution import Distribution
from planners.errors import InputError
from planners.typed_toml import convert
from sim.planet import MARS
from sim.vehicle import Conditions
from sim.wind import Dryden, Wind
from tracking.loop import ON_PATH
from tracking.sensors import PERFECT

SEEDS = st.integers(0, 2**53 - 1)
ALL_DRAWN = ConditionKeys(
    wind=WindKeys(Distribution(weibull=(2.0, 8.0)), Distribution(uniform=(0.0, 360.0))),
    turbulence=Distribution(uniform=(0.0, 7.0)),
    gust=GustKeys(
        Distribution(uniform=(1.0, 9.0)), Distribution(uniform=(0.0, 360.0)), Distribution(normal=(0.0, 2.0)),
        Distribution(uniform=(0.0, 60.0)), Distribution(uniform=(1.0, 8.0)),
    ),
    dryden=DrydenKeys(Distribution(uniform=(0.0, 3.0)), Distribution(uniform=(100.0, 900.0))),
    cross_track_offset=Distribution(normal=(0.0, 3.0)),
    heading_offset=Distribution(normal=(0.0, 10.0)),
    mass=Distribution(uniform=(0.8, 1.2)),
    friction=Distribution(uniform=(0.3, 0.9)),
    position_noise=Distribution(uniform=(0.0, 2.0)),
    heading_noise=Distribution(uniform=(0.0, 2.0)),
    speed_noise=Distribution(uniform=(0.0, 2.0)),
    noise_time=Distribution(uniform=(0.0, 9.0)),
    latency=Distribution(uniform=(0.0, 1.0)),
)  # fmt: skip


def numbers(one):
    """All the numbers of a draw."""
    c, o, s = one.conditions, one.offset, one.sensors
    g = c.gust
    return (
        c.wind.east, c.wind.north, c.turbulence, g.east, g.north, g.up, g.start, g.duration, c.mass_factor, c.friction,
        o.cross_track, o.heading, s.position, s.heading, s.speed, s.correlation_time, s.latency,
    )  # fmt: skip


def test_without_keys_a_trial_meets_nothing():
    one = draw(CALM, 1)
    assert one.conditions == Conditions()
    assert one.offset == ON_PATH
    assert one.sensors == PERFECT


@given(SEEDS)
def test_fixed_values_are_what_every_trial_meets(seed):
    keys = ConditionKeys(
        wind="10@270", turbulence=5.0, gust=GustKeys(6.0, 180.0, 2.0, 7.0, 3.0), cross_track_offset=-2.0,
        heading_offset=-90.0, mass=1.1, friction=0.4, position_noise=1.5, heading_noise=180.0, speed_noise=0.3,
        noise_time=20.0, latency=0.15,
    )  # fmt: skip
    expected = (10, 0, 5, 0, 6, 2, 7, 3, 1.1, 0.4, -2, -math.pi / 2, 1.5, math.pi, 0.3, 20, 0.15)
    assert numbers(draw(keys, seed)) == pytest.approx(expected, abs=1e-12)


@given(SEEDS)
def test_a_draw_is_a_function_of_keys_and_seed_alone(seed):
    again = ConditionKeys(**{name: getattr(ALL_DRAWN, name) for name in ALL_DRAWN.__struct_fields__})
    assert draw(ALL_DRAWN, seed) == draw(again, seed)


def test_another_seed_draws_every_number_anew():
    """But for the turbulence, which has eight values only."""
    for one, other in zip(numbers(draw(ALL_DRAWN, 1)), numbers(draw(ALL_DRAWN, 2)), strict=True):
        assert one != other or one in range(8)
    one, other = (draw(ALL_DRAWN, seed).conditions.dryden for seed in (1, 2))
    assert one.sigma != other.sigma
    assert one.length != other.length
    assert len({draw(ALL_DRAWN, seed).conditions.turbulence for seed in range(200)}) == 8


@given(SEEDS)
def test_a_drawn_turbulence_is_a_curve_of_the_standard(seed):
    severity = draw(ConditionKeys(turbulence=Distribution(uniform=(0.0, 7.0))), seed).conditions.turbulence
    assert severity in range(8)


@pytest.mark.parametrize(("word", "curve"), [("light", 3.0), ("moderate", 4.0), ("severe", 6.0)])
def test_turbulence_words_are_the_curves_of_mil_f_8785c(word, curve):
    assert draw(ConditionKeys(turbulence=word), 0).conditions.turbulence == curve


@pytest.mark.parametrize(
    ("origin", "east", "north"), [(0.0, 0.0, -10.0), (90.0, -10.0, 0.0), (180.0, 0.0, 10.0), (270.0, 10.0, 0.0)]
)
def test_wind_and_gust_blow_from_where_they_say(origin, east, north):
    for wind in (f"10@{origin:g}", WindKeys(10.0, origin)):
        found = draw(ConditionKeys(wind=wind), 0).conditions.wind
        assert (found.east, found.north) == pytest.approx((east, north), abs=1e-12)
    gust = draw(ConditionKeys(gust=GustKeys(10.0, origin)), 0).conditions.gust
    assert (gust.east, gust.north, gust.up) == pytest.approx((east, north, 0.0), abs=1e-12)


def test_dryden_turbulence_is_that_of_a_day_on_mars_unless_said_otherwise():
    assert draw(ConditionKeys(dryden=DrydenKeys()), 0).conditions.dryden == MARS.daytime
    assert draw(ConditionKeys(dryden=DrydenKeys(1.5, 300.0)), 0).conditions.dryden == Dryden(1.5, 300.0)


@given(st.floats(-180.0, 180.0), st.floats(0.0, 180.0))
def test_degrees_become_radians(offset, noise):
    one = draw(ConditionKeys(heading_offset=offset, heading_noise=noise), 0)
    assert one.offset.heading == math.radians(offset)
    assert one.sensors.heading == math.radians(noise)


NUMBERS = [name for name in ConditionKeys.__struct_fields__ if name not in ("wind", "gust", "dryden")]
PLACES = [
    *((f"conditions.{name}", lambda value, name=name: {name: value}) for name in NUMBERS),
    *((f"conditions.wind.{name}", lambda value, name=name: {"wind": {"speed": 3.0, name: value}})
      for name in ("speed", "from")),
    *((f"conditions.gust.{name}", lambda value, name=name: {"gust": {"speed": 3.0, name: value}})
      for name in ("speed", "from", "up", "start", "duration")),
    *((f"conditions.dryden.{name}", lambda value, name=name: {"dryden": {name: value}})
      for name in ("sigma", "length")),
]  # fmt: skip


def refused(keys, place):
    with pytest.raises(InputError) as caught:
        draw(convert(keys, ConditionKeys, "file"), 1)
    text = str(caught.value)
    assert text.startswith(f"{place}: ")
    assert "\n" not in text


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e7, -1e7])
@pytest.mark.parametrize(("place", "keys"), PLACES, ids=[place for place, _ in PLACES])
def test_a_value_that_means_nothing_is_refused_by_its_key(place, keys, value):
    refused(keys(value), place)
    refused(keys({"normal": [value, 0.0]}), place)


@pytest.mark.parametrize(
    "keys",
    [
        {"mass": 0.0},
        {"friction": 0.0},
        {"position_noise": -1.0},
        {"heading_noise": -1.0},
        {"speed_noise": -0.1},
        {"noise_time": -1.0},
        {"latency": -0.1},
        {"latency": 61.0},
        {"turbulence": 8.0},
        {"turbulence": -1.0},
        {"heading_offset": 181.0},
    ],
)
def test_what_cannot_be_is_refused_by_its_key(keys):
    (name,) = keys
    refused(keys, f"conditions.{name}")


def test_every_key_takes_a_distribution():
    for place, keys in PLACES:
        low, high = (1.0, 2.0) if "turbulence" not in place else (1.0, 7.0)
        asked = convert(keys({"uniform": [low, high]}), ConditionKeys, "file")
        assert len({str(draw(asked, seed)) for seed in range(12)}) > 1


@pytest.mark.parametrize("text", ["10", "10@west", "nan@3", "-3@270", "inf@270"])
def test_what_is_no_wind_is_refused(text):
    refused({"wind": text}, "conditions.wind")


@pytest.mark.parametrize("text", ["10000000@270", "9" * 400 + "@270", "10@" + "9" * 400])
def test_a_wind_in_words_has_the_bounds_of_a_wind_in_a_table(text):
    refused({"wind": text}, "conditions.wind")


def test_a_wind_from_the_same_place_is_the_same_in_words_and_in_a_table():
    assert draw(ConditionKeys(wind="8@320"), 0) == draw(ConditionKeys(wind=WindKeys(8.0, 320.0)), 0)


def test_a_plan_may_count_on_the_steady_wind_only():
    somewhere, some = Distribution(uniform=(0.0, 360.0)), Distribution(weibull=(2.0, 8.0))
    steady = Wind.blowing_from(8.0, 320.0)
    assert known_wind(ConditionKeys(wind="8@320")) == steady
    assert known_wind(ConditionKeys(wind=WindKeys(8.0, 320.0))) == steady
    assert known_wind(ConditionKeys(wind=WindKeys(8.0, 320.0), gust=GustKeys(9.0), turbulence="severe")) == steady
    assert known_wind(CALM) == Wind()
    assert known_wind(ConditionKeys(wind=WindKeys(0.0, somewhere))) == Wind()
    for drawn in (WindKeys(some), WindKeys(some, somewhere), WindKeys(8.0, somewhere)):
        assert known_wind(ConditionKeys(wind=drawn)) is None


def test_the_known_wind_is_the_one_that_trials_meet():
    keys = ConditionKeys(wind=WindKeys(7.0, 123.0))
    assert draw(keys, 99).conditions.wind == known_wind(keys)
