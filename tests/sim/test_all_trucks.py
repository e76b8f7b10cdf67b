"""What holds for every truck, whatever simulates it."""

import math

import numpy as np
import pytest

from planners.errors import InputError
from sim.planet import EARTH, MARS
from sim.truck_limits import STEERING_LIMIT, STEERING_RATE, WHEELBASE
from sim.vehicle import Command, Conditions, Pose
from sim.vehicles import ALL_TRUCKS, make_vehicle
from sim.wind import Gust, Wind


@pytest.fixture(params=ALL_TRUCKS)
def name(request):
    return request.param


def drive(name, speed, curvature, seconds, conditions=None):
    truck = make_vehicle(name)
    truck.reset(Pose(0.0, 0.0, 0.0, 0.0), speed, conditions or Conditions(), 0)
    return [truck.step(Command(curvature, speed)) for _ in range(round(seconds / truck.period))]


def test_left_steering_is_positive_and_turns_left(name):
    state = drive(name, 5.0, 0.05, 2.0)[-1]
    assert state.y > 0.0
    assert state.heading > 0.0
    assert state.curvature > 0.0
    assert state.channels[0] == pytest.approx(math.atan(0.05 * WHEELBASE), rel=1e-3)


def test_steering_lags_and_keeps_its_rate_and_its_limit(name):
    steering = np.array([state.channels[0] for state in drive(name, 2.0, 10.0, 3.0)])
    rate = np.diff(steering) / make_vehicle(name).period
    assert rate.max() == pytest.approx(STEERING_RATE, rel=1e-6)
    assert steering.max() == pytest.approx(STEERING_LIMIT, rel=1e-3)
    small = np.array([state.channels[0] for state in drive(name, 2.0, 0.01, 1.0)])
    after_a_lag = small[round(0.2 / make_vehicle(name).period) - 1] / math.atan(0.01 * WHEELBASE)
    assert after_a_lag == pytest.approx(1.0 - math.exp(-1.0), rel=1e-6)


def test_a_steering_limit_or_rate_that_holds_it_back_is_told(name):
    assert drive(name, 2.0, 10.0, 0.1)[-1].saturated
    assert not drive(name, 2.0, 0.01, 0.1)[-1].saturated


def test_it_gains_speed_as_its_cruise_control_can_and_holds_it(name):
    truck = make_vehicle(name)
    truck.reset(Pose(0.0, 0.0, 0.0, 0.0), 10.0, Conditions(), 0)
    speeds = [truck.step(Command(0.0, 12.0)).ground_speed for _ in range(200)]
    assert np.diff(speeds).max() == pytest.approx(2.0 * truck.period, rel=1e-6)
    assert speeds[-1] == pytest.approx(12.0, rel=1e-3)


def test_one_run_is_the_other_and_only_friction_is_felt(name):
    """Wind, turbulence, gusts and mass are an aircraft's."""
    own = drive(name, 60.0 / 3.6, 0.05, 5.0)
    ice = drive(name, 60.0 / 3.6, 0.05, 5.0, Conditions(friction=0.1))
    assert max(state.channels[2] for state in ice) < 0.11 * 9.80665
    stormy = Conditions(Wind(20.0, 5.0), turbulence=6.0, gust=Gust(9.0, 0.0, 0.0, 1.0, 2.0), mass_factor=3.0)
    assert drive(name, 60.0 / 3.6, 0.05, 5.0, stormy) == own


def test_it_may_steer_twice_a_second(name):
    assert make_vehicle(name, steering_hz=2.0).guidance_period == pytest.approx(0.5)
    assert make_vehicle(name).guidance_period == pytest.approx(0.05)


@pytest.mark.parametrize("rate", [0.0, -2.0, 50.0, math.nan])
def test_a_rate_it_cannot_steer_at_is_refused(name, rate):
    with pytest.raises(InputError, match="steering-hz"):
        make_vehicle(name, steering_hz=rate)


@pytest.mark.parametrize("speed", [0.5, 50.0])
def test_a_speed_it_cannot_drive_is_refused(name, speed):
    with pytest.raises(InputError, match="truck cannot drive"):
        make_vehicle(name).reset(Pose(0.0, 0.0, 0.0, 0.0), speed, Conditions(), 0)


@pytest.mark.parametrize("friction", [0.0, -0.5, math.nan, math.inf])
def test_what_is_no_friction_is_refused(name, friction):
    with pytest.raises(InputError, match=r"friction: .* choose one above 0"):
        make_vehicle(name).reset(Pose(0.0, 0.0, 0.0, 0.0), 10.0, Conditions(friction=friction), 0)


def test_it_drives_on_earth_only(name):
    assert make_vehicle(name, planet=EARTH).name == name
    with pytest.raises(InputError, match=f"the {name} drives on earth only"):
        make_vehicle(name, planet=MARS)


def test_at_walking_pace_tyres_do_not_matter():
    """After almost half a circle of 10 m, at 1 m/s, the trucks are within half a per cent of the way of each other."""
    ends = [drive(name, 1.0, 0.1, 30.0)[-1] for name in ALL_TRUCKS]
    assert math.dist((ends[0].x, ends[0].y), (ends[1].x, ends[1].y)) < 0.005 * 30.0
