import math
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.path import Path
from sample_paths import road_weave
from sim.vehicle import Conditions, State
from sim.vehicles import make_vehicle
from sim.wind import Wind
from tracking.controllers import make_controller
from tracking.loop import COMPLETED, ON_PATH, Offset, follow
from tracking.sensors import PERFECT, Estimate, Sensors

PERIOD = 0.05
ROAD = road_weave(10.0)
START = State(0.0, 5.0, -3.0, 700.0, 0.2, 0.7, 30.0, 28.0, 1.5, 0.01, False, (1.0,))
SEEN_MOVING = ("x", "y", "z", "heading", "course", "ground_speed", "airspeed", "climb_rate", "curvature")


def truth(i):
    """A state `i` periods after the start in which every quantity is another polynomial of the time."""
    t = i * PERIOD
    moving = {name: getattr(START, name) + k * t + 0.1 * k * t * t for k, name in enumerate(SEEN_MOVING, start=1)}
    return msgspec.structs.replace(START, t=t, saturated=i % 2 == 1, **moving)


def moving(state):
    return [getattr(state, name) for name in SEEN_MOVING]


def drive(sensors=PERFECT, seed=0, path=ROAD, offset=ON_PATH):
    return follow(path, make_vehicle("truck"), make_controller("lqr"), 10.0, 0.0, Conditions(), seed, sensors, offset)


def fly(sensors=PERFECT, path=None, wind=None, offset=ON_PATH):
    path = path or Path([[0.0, 0.0], [6000.0, 0.0]])
    conditions = Conditions(wind=wind or Wind())
    return follow(path, make_vehicle("c172x"), make_controller("lqr"), 55.0, 1000.0, conditions, 0, sensors, offset)


def rms(track):
    return float(np.sqrt(np.mean(track["cross_track"] ** 2)))


def errors(sensors, count, seed=0, period=PERIOD):
    """Errors of x, y, heading, course, ground speed, airspeed (count, 6) of a vehicle that stands still."""
    estimate, names = Estimate(sensors, period, seed), ("x", "y", "heading", "course", "ground_speed", "airspeed")
    still = [msgspec.structs.replace(START, t=i * period) for i in range(count)]
    seen = np.array([[getattr(one, name) for name in names] for one in map(estimate.observe, still)])
    return seen - [getattr(START, name) for name in names]


# What is seen: late


@pytest.mark.parametrize("periods", [0, 1, 4, 13])
def test_a_latency_of_whole_periods_shows_the_truth_of_then(periods):
    estimate = Estimate(Sensors(latency=periods * PERIOD), PERIOD, 0)
    for i in range(60):
        seen = estimate.observe(truth(i))
        if i >= periods:
            assert moving(seen) == pytest.approx(moving(truth(i - periods)), abs=1e-9)


@given(st.floats(0.0, 0.6))
def test_a_latency_between_periods_shows_what_lies_linearly_between(latency):
    estimate = Estimate(Sensors(latency=latency), PERIOD, 0)
    whole, share = divmod(latency / PERIOD, 1.0)
    for i in range(40):
        seen = estimate.observe(truth(i))
        if i > whole:
            later, before = (np.array(moving(truth(i - int(whole) - k))) for k in (0, 1))
            assert moving(seen) == pytest.approx((1.0 - share) * later + share * before, abs=1e-9)


def test_before_the_start_it_comes_in_along_its_course_at_its_ground_speed():
    estimate = Estimate(Sensors(latency=1.0), PERIOD, 0)
    for i in range(20):
        seen = estimate.observe(truth(i))
        back = START.ground_speed * (1.0 - i * PERIOD)
        assert seen.x == pytest.approx(START.x - back * math.cos(START.course))
        assert seen.y == pytest.approx(START.y - back * math.sin(START.course))
        assert moving(seen)[2:] == moving(START)[2:]


def test_a_vehicle_knows_at_once_that_it_is_saturated():
    estimate = Estimate(Sensors(latency=1.05), PERIOD, 0)
    assert [estimate.observe(truth(i)).saturated for i in range(4)] == [False, True, False, True]


# What is seen: with errors

NOISY = Sensors(position=1.5, heading=0.02, speed=0.4)


@pytest.mark.parametrize("correlation_time", [0.0, 0.3])
def test_errors_have_their_standard_deviation_and_no_bias(correlation_time):
    """Within five standard errors: one false alarm in a million.

    A stationary Gauss-Markov sequence of N samples with correlation r from one to the next has a mean with the variance
    sd^2 (1 + r) / (1 - r) / N, and a variance with the relative variance 2 (1 + r^2) / (1 - r^2) / N (Bartlett
    1946), so that the relative error of the deviation is half of its root.
    """
    count = 20_000
    e = errors(replace(NOISY, correlation_time=correlation_time), count)
    r = math.exp(-PERIOD / correlation_time) if correlation_time else 0.0
    deviations = np.array([1.5, 1.5, 0.02, 0.02, 0.4, 0.4])
    assert (np.abs(e.mean(axis=0)) <= 5.0 * deviations * math.sqrt((1 + r) / (1 - r) / count)).all()
    assert (np.abs(e.std(axis=0) / deviations - 1.0) <= 5.0 * math.sqrt((1 + r * r) / (1 - r * r) / (2 * count))).all()


def test_errors_are_as_large_at_the_start_as_ever():
    """No warming up: over 2000 seeds the first error has the deviation already (five standard errors: 8 %)."""
    first = np.array([errors(Sensors(position=1.5, correlation_time=10.0), 1, seed)[0, 0] for seed in range(2000)])
    assert first.std() == pytest.approx(1.5, rel=5.0 / math.sqrt(2 * 2000))


@pytest.mark.parametrize(("correlation_time", "period"), [(0.5, 0.05), (0.5, 0.1), (0.1, 0.05), (0.0, 0.05)])
def test_errors_are_correlated_as_gauss_markov_says(correlation_time, period):
    """exp(-dt / tau) at every lag, whatever the period, within five of Bartlett's (1946) standard errors.

    For correlation r^k at lag k: N var = (1 + r^2)(1 - r^2k) / (1 - r^2) - 2 k r^2k.
    """
    count = 20_000
    e = errors(Sensors(position=1.0, correlation_time=correlation_time), count, seed=1, period=period)[:, 0]
    r = math.exp(-period / correlation_time) if correlation_time else 0.0
    for k in (1, 2, 5, 10, 20):
        expected = math.exp(-k * period / correlation_time) if correlation_time else 0.0
        variance = ((1 + r * r) * (1 - r ** (2 * k)) / (1 - r * r) - 2 * k * r ** (2 * k)) / count
        assert np.mean(e[k:] * e[:-k]) / np.mean(e * e) == pytest.approx(expected, abs=5.0 * math.sqrt(variance))


def test_heading_and_course_err_alike_and_so_do_the_speeds_but_x_and_y_do_not():
    x, y, heading, course, ground_speed, airspeed = errors(NOISY, 5000).T
    assert heading == pytest.approx(course, abs=1e-12)
    assert ground_speed == pytest.approx(airspeed, abs=1e-12)
    assert abs(np.corrcoef(x, y)[0, 1]) < 5.0 / math.sqrt(5000)
    assert abs(np.corrcoef(x, heading)[0, 1]) < 5.0 / math.sqrt(5000)


def test_errors_are_added_to_the_late_truth():
    noisy, late = Estimate(Sensors(position=2.0, latency=0.2), PERIOD, 3), Estimate(Sensors(latency=0.2), PERIOD, 3)
    e = errors(Sensors(position=2.0), 30, seed=3)
    for i in range(30):
        a, b = noisy.observe(truth(i)), late.observe(truth(i))
        assert (a.x - b.x, a.y - b.y) == pytest.approx((e[i, 0], e[i, 1]), abs=1e-9)


# In the loop


def test_without_errors_and_latency_the_controller_sees_the_truth(monkeypatch):
    """Byte for byte where there is nothing to look through, and to rounding where it is looked through."""
    bare = drive()
    assert drive(Sensors(correlation_time=3.0)).data.tobytes() == bare.data.tobytes()
    monkeypatch.setattr(Sensors, "perfect", property(lambda _: False))
    looked_through = drive()
    assert looked_through.ended == bare.ended
    assert looked_through.data == pytest.approx(bare.data, abs=1e-9)


@pytest.mark.parametrize(
    "sensors", [Sensors(position=0.1), Sensors(heading=0.01), Sensors(speed=0.1), Sensors(latency=0.1)]
)
def test_each_error_alone_counts(sensors):
    assert not sensors.perfect
    assert drive(sensors).data.tobytes() != drive().data.tobytes()


def test_the_seed_decides_the_errors():
    sensors = Sensors(position=0.2, heading=0.01, speed=0.1, correlation_time=1.0, latency=0.07)
    once, again, other = (drive(sensors, seed) for seed in (7, 7, 8))
    assert once.data.tobytes() == again.data.tobytes()
    assert once.data.tobytes() != other.data.tobytes()


def test_latency_costs_accuracy():
    """At 10 m/s on curves of 0.5 g, 0.2 s are 2 m of the way."""
    prompt, late = drive(), drive(Sensors(latency=0.2))
    assert late.ended == COMPLETED
    assert rms(late) > 2.0 * rms(prompt)


def test_the_track_is_the_truth_whatever_the_controller_sees():
    track = drive(Sensors(position=1.0, correlation_time=1.0))
    assert track.ended == COMPLETED
    assert rms(track) > 2.0 * rms(drive())
    for i in range(0, len(track), 5):
        s = track["s"][i]
        at = ROAD.project(track["x"][i], track["y"][i], s - 5.0, s + 5.0)
        assert track["cross_track"][i] == pytest.approx(at.cross_track, abs=1e-9)
        assert s == pytest.approx(at.s, abs=1e-9)
    speed = np.hypot(np.diff(track["x"]), np.diff(track["y"])) / PERIOD
    assert speed == pytest.approx(np.full(len(speed), 10.0), rel=0.02)  # noise in the track would be 1 m a sample


@pytest.mark.parametrize("tailwind", [-15.0, 0.0, 15.0])
def test_a_late_estimate_on_a_straight_line_is_still_on_it(tailwind):
    """Late by the way of half a second, it is late along the path: no error across, with or against the wind."""
    track = fly(Sensors(latency=0.5), wind=Wind(east=tailwind))
    assert np.abs(track["cross_track"]).max() < 0.2


# Where it starts

DIAGONAL = math.radians(30.0)


def slanted(length):
    return Path([[100.0, 50.0], [100.0 + length * math.cos(DIAGONAL), 50.0 + length * math.sin(DIAGONAL)]])


@pytest.mark.parametrize(("left", "turn"), [(2.0, 0.0), (-2.0, 0.0), (0.0, 0.15), (1.5, -0.15), (-1.0, -0.1)])
def test_a_truck_starts_at_its_offset_and_comes_to_the_path(left, turn):
    track = drive(path=slanted(300.0), offset=Offset(left, turn))
    _starts_at(track, left, turn, 1e-9)
    assert track.ended == COMPLETED
    assert np.abs(track["cross_track"][-20:]).max() < 0.05


@pytest.mark.parametrize(("left", "turn"), [(100.0, 0.0), (-100.0, 0.3), (0.0, -0.3)])
def test_an_aircraft_starts_at_its_offset_and_comes_to_the_path(left, turn):
    track = fly(path=slanted(6000.0), offset=Offset(left, turn))
    _starts_at(track, left, turn, 1e-5)
    assert track.ended == COMPLETED
    assert np.abs(track["cross_track"][-20:]).max() < 1.0


def test_in_crosswind_the_heading_offset_is_the_courses():
    track = fly(path=slanted(500.0), offset=Offset(20.0, 0.3), wind=Wind(north=10.0))
    assert track["course"][0] == pytest.approx(DIAGONAL + 0.3, abs=1e-5)
    assert track["heading"][0] < track["course"][0] - 0.05


def _starts_at(track, left, turn, tolerance):
    assert track["x"][0] == pytest.approx(100.0 - left * math.sin(DIAGONAL), abs=tolerance)
    assert track["y"][0] == pytest.approx(50.0 + left * math.cos(DIAGONAL), abs=tolerance)
    assert track["heading"][0] == pytest.approx(DIAGONAL + turn, abs=max(tolerance, 1e-9))
    assert track["cross_track"][0] == pytest.approx(left, abs=tolerance)
    assert track["s"][0] == pytest.approx(0.0, abs=tolerance)
