"""What a well-behaved vehicle must reach on a path it can follow: the promises of the README."""

import numpy as np
import pytest

from sample_paths import aircraft_weave, road_weave
from sim.vehicle import Conditions
from sim.wind import Wind
from tracking.controllers import ALL_CONTROLLERS
from tracking.trial import Trial, run_trial

NAMES = [controller.name for controller in ALL_CONTROLLERS]


def fly(controller, wind=None):
    outcome = run_trial(
        Trial("weave", aircraft_weave(), "c172x", controller, speed=55.0, conditions=Conditions(wind=wind or Wind()))
    )
    assert outcome.track.ended == "completed"
    return outcome


def drive(controller, speed_kmh, steering_hz=20.0, vehicle="truck", lateral_g=0.5):
    speed = speed_kmh / 3.6
    path = road_weave(speed, lateral_g)
    outcome = run_trial(Trial("weave", path, vehicle, controller, speed=speed, steering_hz=steering_hz))
    assert outcome.track.ended == "completed"
    return outcome


def value(outcome, metric):
    assert outcome.metrics[metric].valid
    return outcome.metrics[metric].value


@pytest.mark.parametrize("controller", ["lqr", "l1"])
def test_c172x_in_calm(controller):
    outcome = fly(controller)
    assert value(outcome, "cross_track_p95") <= 2.0
    assert abs(value(outcome, "cross_track_mean")) <= 0.3
    assert value(outcome, "altitude_error_max") <= 8.0
    assert value(outcome, "speed_error_max") <= 2.0


@pytest.mark.parametrize("controller", ["lqr", "l1"])
@pytest.mark.parametrize("direction", range(0, 360, 45))
def test_c172x_in_wind(controller, direction):
    outcome = fly(controller, Wind.blowing_from(10.0, direction))
    assert value(outcome, "cross_track_p95") <= 4.0
    assert value(outcome, "altitude_error_max") <= 8.0
    assert value(outcome, "speed_error_max") <= 2.0


@pytest.mark.parametrize("controller", NAMES)
def test_c172x_under_every_controller(controller):
    assert value(fly(controller), "cross_track_p95") <= 10.0


@pytest.mark.parametrize("speed_kmh", [30.0, 45.0, 60.0])
def test_truck_under_lqr(speed_kmh):
    assert value(drive("lqr", speed_kmh), "cross_track_p95") <= 0.15
    assert value(drive("lqr", speed_kmh, steering_hz=2.0), "cross_track_p95") <= 0.35


@pytest.mark.parametrize("speed_kmh", [30.0, 45.0, 60.0])
@pytest.mark.parametrize("controller", NAMES)
def test_truck_under_every_controller(controller, speed_kmh):
    outcome = drive(controller, speed_kmh)
    assert value(outcome, "cross_track_p95") <= 0.5
    assert outcome.verdict.trackworthy


@pytest.mark.parametrize("speed_kmh", [45.0, 60.0])
@pytest.mark.parametrize("controller", ["lqr", "stanley"])
def test_slipping_tyres_cost_accuracy_and_not_the_road(controller, speed_kmh):
    slipping = drive(controller, speed_kmh, vehicle="truck-dynamic", lateral_g=0.3)
    rolling = drive(controller, speed_kmh, lateral_g=0.3)
    assert 5.0 * value(rolling, "cross_track_p95") < value(slipping, "cross_track_p95") <= 1.0


@pytest.mark.parametrize("controller", NAMES)
def test_no_controller_loses_the_road_at_half_a_g(controller):
    assert value(drive(controller, 60.0, vehicle="truck-dynamic"), "cross_track_max") <= 6.0


def test_pure_pursuit_flies_off_beside_the_path_in_crosswind_without_the_integral_term(monkeypatch):
    """Its look-ahead starts at the body heading, so crab is a steady bias: the integral term must take it away."""
    crosswind = Wind.blowing_from(10.0, 0.0)

    def late_bias():
        from planners.path import Path

        outcome = run_trial(
            Trial("line", Path([[0, 0], [12_000.0, 0]]), "c172x", "pure-pursuit", conditions=Conditions(wind=crosswind))
        )
        return abs(float(np.mean(outcome.track["cross_track"][-200:])))

    with_integral = late_bias()
    monkeypatch.setattr("tracking.integral.Integral.curvature", lambda *_: 0.0)
    assert late_bias() > 15.0
    assert with_integral < 2.0
