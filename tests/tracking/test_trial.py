import math

import numpy as np
import pytest

from planners.frame import Frame
from planners.map import Circle, Map
from planners.path import Path
from sample_paths import circle, right_angle
from sim.truck import Truck
from sim.vehicle import Conditions
from sim.vehicles import make_vehicle
from sim.wind import Wind
from tracking.controllers import make_controller
from tracking.loop import follow
from tracking.trial import Trial, run_trial


def failed(trial):
    outcome = run_trial(trial)
    assert not outcome.verdict.trackworthy
    return {margin.metric.name for margin in outcome.verdict.margins if not margin.met}


@pytest.mark.parametrize("radius", [40.0, 90.0, 150.0])
def test_an_aircraft_that_leaves_out_a_loop_is_not_trackworthy(radius):
    ring = circle(radius, 1.0, radius / 30).points
    path = Path(np.concatenate([[[-3000.0, 0.0]], ring, [[1.0, 0.0], [3000.0, 0.0]]]))
    assert "cross_track_max" in failed(Trial("loop", path, "c172x"))


@pytest.mark.parametrize("radius", [2.0, 3.0, 4.0])
def test_a_truck_that_leaves_out_a_loop_is_not_trackworthy(radius):
    ring = circle(radius, 1.0, radius / 30).points
    path = Path(np.concatenate([[[-60.0, 0.0]], ring, [[0.1, 0.0], [60.0, 0.0]]]))
    assert "cross_track_max" in failed(Trial("loop", path, "truck", speed=10.0))


def test_an_aircraft_that_leaves_out_a_spur_is_not_trackworthy():
    spur = Path([[0.0, 0.0], [3000.0, 0.0], [3000.0, 250.0], [3000.5, 0.0], [6000.0, 0.0]])
    assert "cross_track_max" in failed(Trial("spur", spur, "c172x"))


def test_an_aircraft_that_does_not_turn_back_is_not_trackworthy():
    back = Path([[0.0, 0.0], [3000.0, 0.0], [2800.0, 0.0], [6000.0, 0.0]])
    assert "cross_track_max" in failed(Trial("back", back, "c172x"))


@pytest.mark.parametrize("start", [0.0, 1.1, 2.5])
def test_a_closed_path_does_not_end_where_it_begins(start):
    angle = start + np.linspace(0.0, 2 * math.pi, 60)
    ring = Path(90.0 * np.column_stack([np.cos(angle), np.sin(angle)]))
    assert "cross_track_max" in failed(Trial("ring", ring, "c172x"))


def test_a_run_ends_only_where_the_path_does():
    path = Path([[0, 0], [60, 0], [60, 6], [50, 6], [50, 3]])
    for controller in ("pure-pursuit", "l1", "stanley"):
        assert "cross_track_max" in failed(Trial("hook", path, "truck", controller, speed=8.0))


def test_no_wind_moves_a_truck():
    path = Path(np.concatenate([[[-60.0, 0.0]], circle(25.0, 1.0, 0.5).points, [[0.5, 0.0], [80.0, 0.0]]]))
    calm, windy = (
        run_trial(Trial("w", path, "truck", speed=10.0, conditions=Conditions(wind=wind)))
        for wind in (Wind(), Wind(20.0, 0.0))
    )
    assert calm.track.data.tobytes() == windy.track.data.tobytes()
    assert windy.conditions.wind.speed == 0.0


def test_the_corridor_judges_and_does_not_steer():
    tight, wide = (run_trial(Trial("c", right_angle(3000.0), "c172x", corridor=c)) for c in (5.0, 300.0))
    assert tight.track.data.tobytes() == wide.track.data.tobytes()


class Breaking(Truck):
    """A truck whose numbers are lost after two seconds."""

    def step(self, command):
        if self._t >= 2.0:
            self._plant.position[:] = math.nan
        return super().step(command)


def test_numbers_that_are_lost_end_the_run_with_a_verdict(monkeypatch):
    monkeypatch.setattr("tracking.trial.make_vehicle", lambda *_: Breaking())
    outcome = run_trial(Trial("nan", Path([[0.0, 0.0], [100.0, 0.0]]), "truck", speed=10.0))
    assert outcome.track.ended == "not a number"
    assert not outcome.verdict.trackworthy
    assert all(math.isfinite(metric.value) for metric in outcome.metrics.values() if metric.valid)


def test_out_and_back_is_measured():
    outcome = run_trial(Trial("out and back", Path([[0.0, 0.0], [4999.5, 0.0], [0.0, 0.0]]), "c172x"))
    assert outcome.metrics["frechet"].valid
    assert not outcome.verdict.trackworthy


def test_a_path_on_the_planet_is_flown_there():
    """Coriolis: at 47 deg north the same commands do not give the same bits as at the equator."""
    path = [[0.0, 0.0], [2000.0, 0.0]]
    north, equator = (
        run_trial(Trial("p", Path(path, frame=Frame(lat, 8.0)), "c172x")).track["cross_track"] for lat in (47.0, 0.0)
    )
    assert not np.array_equal(north, equator)


def test_an_aircrafts_body_is_half_a_span_wide():
    tree = Map(circles=(Circle(1000.0, 40.0, 10.0),))
    outcome = run_trial(Trial("t", Path([[0.0, 0.0], [2000.0, 0.0]]), "c172x", obstacles=tree))
    assert outcome.metrics["clearance_min"].value == pytest.approx(30.0 - 10.97 / 2, abs=0.5)


def test_heading_error_in_crosswind_is_the_crab():
    outcome = run_trial(
        Trial("x", Path([[0.0, 0.0], [6000.0, 0.0]]), "c172x", conditions=Conditions(wind=Wind(north=10.0)))
    )
    assert outcome.metrics["heading_error_max"].value == pytest.approx(math.asin(10.0 / 55.0), abs=0.01)
    assert outcome.metrics["course_error_max"].value < 0.01


def test_a_truck_stays_on_the_ground():
    outcome = run_trial(Trial("g", Path([[0.0, 0.0], [50.0, 0.0]]), "truck"))
    assert (outcome.track["z"] == 0.0).all()


def test_a_climb_is_steeper_with_the_wind_behind():
    path = Path([[0.0, 0.0, 500.0], [3000.0, 0.0, 500.0 + 0.058 * 3000.0]])
    assert run_trial(Trial("calm", path, "c172x")).feasibility.steep == ()
    (slope,) = run_trial(
        Trial("tailwind", path, "c172x", conditions=Conditions(wind=Wind(east=15.0)))
    ).feasibility.steep
    assert slope.gradient == pytest.approx(0.058 * 70.0 / 55.0)


def test_the_time_budget_knows_the_wind():
    path = Path([[0.0, 0.0], [3000.0, 0.0]])
    track = follow(path, make_vehicle("c172x"), make_controller("lqr"), 55.0, 1000.0, Conditions(wind=Wind(east=-48.0)))
    assert track.ended == "completed"
    assert track["t"][-1] > 2 * 3000.0 / 55.0 + 60.0
