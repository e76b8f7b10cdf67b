import math

import numpy as np
import pytest

import sim.truck_dynamic
from sim.truck_dynamic import MAN_KAT1, RESPONSE_TIME, TruckDynamic
from sim.vehicle import Command, Conditions, Pose

G = 9.80665
PAPER_SPEEDS = [30.0 / 3.6, 45.0 / 3.6, 60.0 / 3.6]
STEERING, RATE, LATERAL, USE, YAW_RATE = range(5)


def drive(speed, curvature, seconds, friction=None):
    """States under `curvature(t)` [1/m]."""
    truck = TruckDynamic()
    states = [truck.reset(Pose(0.0, 0.0, 0.0, 0.0), speed, Conditions(friction=friction), 0)]
    for _ in range(round(seconds / truck.period)):
        states.append(truck.step(Command(curvature(states[-1].t), speed)))
    return states


def turn(speed, lateral_g, seconds, friction=None):
    """A step of the steering to a curvature of `lateral_g`, after a second."""
    return drive(speed, lambda t: lateral_g * G / speed**2 if t > 0.999 else 0.0, seconds, friction)


def weave(speed, lateral_g, seconds):
    return drive(speed, lambda t: lateral_g * G / speed**2 * math.sin(t), seconds)


@pytest.mark.parametrize("speed", [5.0, *PAPER_SPEEDS, 25.0, 40.0])
def test_in_a_gentle_turn_the_yaw_rate_is_that_of_its_understeer(speed):
    """v / (L + K v^2) (Gillespie 1992, ch. 6; Rajamani 2012, ch. 3), within 1 %."""
    last = turn(speed, 0.03, 20.0)[-1]
    expected = speed / (4.5 + MAN_KAT1.understeer * speed**2)
    assert last.channels[YAW_RATE] / last.channels[STEERING] == pytest.approx(expected, rel=0.01)
    assert last.curvature == pytest.approx(last.channels[YAW_RATE] / speed, rel=1e-4)


@pytest.mark.parametrize("steering_deg", [-20.0, 5.0, 40.0])
def test_at_walking_pace_it_circles_at_wheelbase_over_tan_delta(steering_deg):
    curvature = math.tan(math.radians(steering_deg)) / 4.5
    last = drive(1.0, lambda _: curvature, 20.0)[-1]
    assert last.curvature == pytest.approx(curvature, rel=5e-3)
    assert abs(last.course - last.heading) < 5e-3


@pytest.mark.parametrize("speed", PAPER_SPEEDS)
@pytest.mark.parametrize("lateral_g", [0.1, 0.5])
def test_a_step_of_the_steering_settles(speed, lateral_g):
    rate = np.array([state.channels[YAW_RATE] for state in turn(speed, lateral_g, 15.0)])
    late = rate[-100:]
    assert np.ptp(late) < 0.005 * late.mean()
    assert rate.max() < 1.1 * late.mean()


@pytest.mark.parametrize("speed", PAPER_SPEEDS)
def test_in_a_steady_turn_lateral_acceleration_is_speed_times_yaw_rate_and_the_tail_hangs_out(speed):
    last = turn(speed, 0.4, 20.0)[-1]
    sideslip = last.course - last.heading
    forward = last.ground_speed * math.cos(sideslip)
    assert last.channels[LATERAL] == pytest.approx(forward * last.channels[YAW_RATE], rel=1e-3)
    # the rear axle slips by what carries its share of the load: more than the linear tyre's 0.4 / 7.29
    assert -0.09 < sideslip < -0.4 / 7.29
    assert last.ground_speed == pytest.approx(speed, rel=1e-3)


@pytest.mark.parametrize("speed", PAPER_SPEEDS)
def test_course_and_curvature_are_those_of_its_positions(speed):
    states = weave(speed, 0.5, 10.0)
    x, y, course, curvature, v = (
        np.array([getattr(state, name) for state in states])
        for name in ("x", "y", "course", "curvature", "ground_speed")
    )
    chord = np.unwrap(np.arctan2(np.diff(y), np.diff(x)))
    assert chord == pytest.approx((course[1:] + course[:-1]) / 2.0, abs=2e-3)
    assert np.hypot(np.diff(x), np.diff(y)) / TruckDynamic.period == pytest.approx((v[1:] + v[:-1]) / 2.0, rel=1e-3)
    turned = (curvature[1:] * v[1:] + curvature[:-1] * v[:-1]) / 2.0 * TruckDynamic.period
    assert np.diff(course) == pytest.approx(turned, abs=2e-3)


@pytest.mark.parametrize("speed", PAPER_SPEEDS)
@pytest.mark.parametrize("friction", [0.1, 0.8])
def test_beyond_its_grip_it_slides_and_runs_wide(speed, friction):
    """The tyres give friction times g and no more; the front ones slide first, since the truck understeers."""
    states = turn(speed, 3.0 * friction, 15.0, friction)
    lateral = np.array([abs(state.channels[LATERAL]) for state in states])
    assert lateral.max() <= friction * G * (1.0 + 1e-9)
    assert lateral[-1] > 0.6 * friction * G
    assert states[-1].channels[USE] == pytest.approx(1.0)
    assert states[-1].saturated
    assert states[-1].curvature < 0.7 * 3.0 * friction * G / speed**2


def test_within_its_grip_no_axle_slides():
    last = turn(12.5, 0.5, 10.0)[-1]
    assert last.channels[USE] == pytest.approx(0.5 / 0.8, rel=0.05)
    assert not last.saturated


def test_its_response_time_is_the_mean_delay_of_the_curvature_driven():
    """The area between the step commanded and the curvature's response to it, over the step."""
    states = turn(12.5, 0.01, 15.0)
    response = np.array([state.curvature for state in states if state.t > 0.999])
    share = 1.0 - response / response[-1]
    area = TruckDynamic.period * (np.sum(share) - 0.5 * share[0])
    assert area == pytest.approx(RESPONSE_TIME, rel=0.01)


@pytest.mark.parametrize("speed", [1.0, *PAPER_SPEEDS, 40.0])
def test_half_the_time_step_changes_little(speed, monkeypatch):
    def end():
        last = weave(speed, min(0.5, 0.2 * speed**2 / G), 20.0)[-1]
        return np.array([last.x, last.y, last.heading, *last.channels])

    coarse = end()
    monkeypatch.setattr(sim.truck_dynamic, "SUBSTEPS", 2 * sim.truck_dynamic.SUBSTEPS)
    assert end() == pytest.approx(coarse, abs=1e-3)


def test_right_is_the_mirror_of_left():
    left, right = turn(12.5, 0.6, 5.0)[-1], turn(12.5, -0.6, 5.0)[-1]
    assert (right.x, -right.y, -right.heading) == pytest.approx((left.x, left.y, left.heading))
    assert right.channels[LATERAL] == pytest.approx(-left.channels[LATERAL])


def test_swinging_from_lock_to_lock_on_ice_nothing_grows_without_end():
    states = drive(60.0 / 3.6, lambda t: 10.0 * math.copysign(1.0, math.sin(t)), 30.0, friction=0.1)
    assert not any(state.fault for state in states)
    assert max(state.ground_speed for state in states) < 60.0 / 3.6 * 1.2
    assert max(abs(state.channels[YAW_RATE]) for state in states) < 1.0
