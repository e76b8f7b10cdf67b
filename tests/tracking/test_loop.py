import math

import numpy as np
import pytest

from planners.path import Path
from sample_paths import circle, road_weave
from sim.truck import Truck
from sim.vehicle import Command, Conditions, State
from sim.vehicles import make_vehicle
from tracking.controllers import make_controller
from tracking.loop import COMPLETED, LOST, OUT_OF_TIME, follow

STRAIGHT = Path([[0.0, 0.0], [100.0, 0.0]])


class Stubborn:
    """A controller that commands one curvature whatever happens."""

    name = "stubborn"

    def __init__(self, curvature=0.0):
        self.command = curvature

    def reset(self, limits, dt):
        pass

    def curvature(self, state, path, at):
        return self.command


class Broken(Truck):
    """A truck that reports a fault, or stands still, after two seconds."""

    def __init__(self, fault="", stands=False):
        super().__init__()
        self.fault, self.stands = fault, stands
        self.last = None

    def step(self, command: Command) -> State:
        from msgspec.structs import replace

        if self.stands and self.last is not None and self.last.t >= 2.0:
            self.last = replace(self.last, t=self.last.t + self.period, ground_speed=0.0)
            return self.last
        state = super().step(command)
        self.last = replace(state, fault=self.fault) if self.fault and state.t >= 2.0 else state
        return self.last


def go(path=STRAIGHT, vehicle=None, controller=None, speed=10.0):
    vehicle = vehicle or Truck()
    return follow(path, vehicle, controller or make_controller("lqr"), speed, 0.0, Conditions())


def test_it_ends_when_the_path_is_completed():
    track = go()
    assert track.ended == COMPLETED
    assert track["s"][-1] >= 100.0 > track["s"][-2]
    assert track["t"][-1] == pytest.approx(10.0, abs=0.1)


@pytest.mark.parametrize("fault", ["stall", "ground", "not a number"])
def test_it_ends_with_the_vehicles_fault(fault):
    track = go(vehicle=Broken(fault))
    assert track.ended == fault
    assert track["t"][-1] == pytest.approx(1.95 if fault == "not a number" else 2.0)
    assert np.isfinite(track.data).all()


def test_it_ends_when_the_corridor_is_lost_for_good():
    assert go(controller=Stubborn(0.05), path=Path([[0.0, 0.0], [2000.0, 0.0]])).ended == LOST


def test_it_ends_when_the_time_budget_is_spent():
    slow = follow(Path([[0.0, 0.0], [3000.0, 0.0]]), Crawling(), make_controller("lqr"), 10.0, 0.0, Conditions())
    assert slow.ended == OUT_OF_TIME
    assert slow["t"][-1] == pytest.approx(2 * 300.0 + 60.0, abs=1.0)


class Crawling(Truck):
    """A truck that never drives faster than 2 m/s."""

    def step(self, command):
        return super().step(Command(command.curvature, min(command.speed, 2.0)))


def test_a_vehicle_that_stands_still_is_lost():
    assert go(vehicle=Broken(stands=True)).ended == LOST


def test_a_shortcut_through_a_loop_is_not_hidden():
    """A vehicle that goes straight on where the path makes a loop is off the path all the way round."""
    loop = circle(30.0, 1.0, 0.5)
    path = Path(np.concatenate([[[-50.0, 0.0]], loop.points, [[0.5, 0.0], [80.0, 0.0]]]))
    track = go(path, controller=Stubborn())
    assert track.ended != COMPLETED
    assert np.abs(track["cross_track"]).max() > 20.0


def test_a_loop_that_is_followed_is_followed_all_the_way_round():
    path = Path(np.concatenate([[[-50.0, 0.0]], circle(30.0, 1.0, 0.5).points, [[0.5, 0.0], [80.0, 0.0]]]))
    track = go(path, speed=8.0)
    assert track.ended == COMPLETED
    assert np.diff(track["s"]).max() < 2.0
    assert np.abs(track["cross_track"]).max() < 0.5


@pytest.mark.parametrize("vehicle", ["c172x", "truck"])
def test_samples_are_at_least_ten_a_second(vehicle):
    plant = make_vehicle(vehicle)
    assert plant.guidance_period <= 0.05 + 1e-12
    track = follow(STRAIGHT, plant, make_controller("l1"), plant.limits.speed, 1000.0, Conditions())
    assert np.diff(track["t"]).max() <= 0.1


def test_steering_twice_a_second_holds_the_command_but_samples_go_on():
    track = go(road_weave(10.0), Truck(steering_hz=2.0))
    changes = np.flatnonzero(np.diff(track["curvature_command"]))
    assert (np.diff(changes) % 10 == 0).all()
    assert np.diff(track["t"]).max() == pytest.approx(0.05)


def test_the_path_is_climbed_where_it_has_heights():
    path = Path([[0.0, 0.0, 500.0], [3000.0, 0.0, 600.0]])
    vehicle = make_vehicle("c172x")
    track = follow(path, vehicle, make_controller("lqr"), 55.0, 9999.0, Conditions())
    assert track["altitude_command"][-1] == pytest.approx(600.0)
    assert np.abs(track["z"] - track["altitude_command"]).max() < 8.0


def test_the_same_run_gives_the_same_bits():
    once, again = go(road_weave(10.0)), go(road_weave(10.0))
    assert once.columns == again.columns
    assert once.data.tobytes() == again.data.tobytes()


def test_errors_are_those_of_the_true_position():
    path = road_weave(10.0)
    track = go(path)
    for i in range(0, len(track), 50):
        at = path.project(track["x"][i], track["y"][i])
        assert track["cross_track"][i] == pytest.approx(at.cross_track, abs=1e-9)
        assert math.isclose(track["s"][i], at.s, abs_tol=1e-9)
