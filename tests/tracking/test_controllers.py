import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.errors import InputError
from planners.path import Path
from sample_paths import circle, road_weave
from sim.vehicle import State
from sim.vehicles import ALL_VEHICLES, make_vehicle
from tracking.controllers import ALL_CONTROLLERS, make_controller

EAST = Path([[0.0, 0.0], [20_000.0, 0.0]]).with_tolerance(1.0)


def state(x, y, heading, speed, curvature=0.0):
    return State(0.0, x, y, 0.0, heading, heading, speed, speed, 0.0, curvature, False, ())


def ready(controller, vehicle):
    chosen, limits = controller(), make_vehicle(vehicle).limits
    chosen.reset(limits, 0.05)
    return chosen, limits


@pytest.fixture(params=ALL_VEHICLES)
def vehicle(request):
    return request.param


@pytest.fixture(params=ALL_CONTROLLERS, ids=lambda controller: controller.name)
def controller(request):
    return request.param


def test_on_a_straight_path_it_commands_nothing(controller, vehicle):
    chosen, limits = ready(controller, vehicle)
    at = EAST.project(1000.0, 0.0)
    assert chosen.curvature(state(1000.0, 0.0, 0.0, limits.speed), EAST, at) == pytest.approx(0.0, abs=1e-12)


def test_left_of_the_path_it_turns_right_and_mirrored(controller, vehicle):
    chosen, limits = ready(controller, vehicle)
    offset = 0.2 * limits.corridor
    left = chosen.curvature(state(1000.0, offset, 0.0, limits.speed), EAST, EAST.project(1000.0, offset))
    right = chosen.curvature(state(1000.0, -offset, 0.0, limits.speed), EAST, EAST.project(1000.0, -offset))
    assert left < 0.0
    assert right == pytest.approx(-left)


def test_heading_left_it_turns_right(controller, vehicle):
    chosen, limits = ready(controller, vehicle)
    assert chosen.curvature(state(1000.0, 0.0, 0.1, limits.speed), EAST, EAST.project(1000.0, 0.0)) < 0.0


def test_on_a_circle_it_commands_the_circle(controller, vehicle):
    """Every controller's command is the path's curvature when the vehicle is on it in steady turn."""
    chosen, limits = ready(controller, vehicle)
    speed = limits.speed
    radius = 4.0 * limits.turn_radius(speed)
    path = circle(radius, 1.0, radius / 400).with_tolerance(0.1 * limits.corridor)
    s = 0.4 * path.length
    x, y = path.point_at(s)
    at = path.project(x, y)
    command = chosen.curvature(state(x, y, path.heading_at(s), speed, 1.0 / radius), path, at)
    assert command == pytest.approx(1.0 / radius, rel=0.03)


@given(st.floats(-5000.0, 5000.0), st.floats(-math.pi, math.pi), st.floats(0.3, 1.5))
def test_far_off_and_in_any_direction_the_command_is_finite(offset, heading, share):
    for controller in ALL_CONTROLLERS:
        for vehicle in ALL_VEHICLES:
            chosen, limits = ready(controller, vehicle)
            now = state(1000.0, offset, heading, share * limits.speed)
            assert math.isfinite(chosen.curvature(now, EAST, EAST.project(1000.0, offset)))


def test_it_keeps_no_state_but_its_settings(controller, vehicle):
    """Trials may share a process: what was asked before must not change the answer."""
    chosen, limits = ready(controller, vehicle)
    path = road_weave(10.0).with_tolerance(0.05)
    at = path.project(30.0, 1.0)
    first = chosen.curvature(state(30.0, 1.0, 0.2, limits.speed), path, at)
    for x in np.linspace(0.0, 100.0, 20):
        chosen.curvature(state(float(x), 3.0, 1.0, limits.speed), path, path.project(float(x), 3.0))
    assert chosen.curvature(state(30.0, 1.0, 0.2, limits.speed), path, at) == first


def test_names_are_unique_and_an_unknown_one_is_refused():
    names = [controller.name for controller in ALL_CONTROLLERS]
    assert len(set(names)) == len(names)
    assert make_controller("l1").name == "l1"
    with pytest.raises(InputError, match=r"no controller 'mpc'.*lqr"):
        make_controller("mpc")
