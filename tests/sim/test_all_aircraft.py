"""What holds for every aircraft in the tree, at home, and what its file says of itself."""

import math

import numpy as np
import pytest

from sim.aircraft_file import ALL_AIRCRAFT, load_aircraft
from sim.fixed_wing import FixedWing
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Wind

HEIGHTS = {"earth": 1000.0, "mars": 1500.0}  # [m] where the envelopes were measured


@pytest.fixture(params=ALL_AIRCRAFT)
def aircraft(request):
    return load_aircraft(request.param)


def fly(aircraft, seconds, bank=0.0, wind=None, gradient=0.0, speed=None):
    speed, height = speed or aircraft.envelope.speed, HEIGHTS[aircraft.planet]
    vehicle = FixedWing(aircraft)
    states = [vehicle.reset(Pose(0.0, 0.0, height, 0.3), speed, Conditions(wind=wind or Wind()), 0)]
    curvature = aircraft.home.gravity * math.tan(bank) / speed**2
    for _ in range(round(seconds / vehicle.period)):
        climbed = gradient * speed * states[-1].t
        states.append(vehicle.step(Command(curvature, speed, height + climbed, gradient)))
    return states


def column(states, name):
    return np.array([getattr(state, name) for state in states])


def channel(states, name):
    return np.array([state.channels[FixedWing.channels.index(name)] for state in states])


@pytest.mark.parametrize("direction", [0.0, 90.0, 200.0])
def test_it_starts_in_equilibrium_on_its_course_in_wind(aircraft, direction):
    states = fly(aircraft, 3.0, wind=Wind.blowing_from(10.0, direction))
    assert column(states, "course") == pytest.approx(0.3, abs=3e-3)
    assert column(states, "airspeed") == pytest.approx(aircraft.envelope.speed, abs=0.2)
    assert np.ptp(column(states, "z")) < 1.0
    assert np.abs(channel(states, "bank")).max() < math.radians(1.0)


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_it_banks_to_the_side_of_the_curvature_as_far_and_as_fast_as_its_file_says(aircraft, sign):
    states = fly(aircraft, 30.0, bank=sign * math.radians(10.0))
    bank = sign * channel(states, "bank")
    reached = np.argmax(bank > (1.0 - math.exp(-1.0)) * math.radians(10.0)) * FixedWing.period
    assert reached == pytest.approx(aircraft.roll.response_time, abs=0.1)
    assert bank[-100:].mean() == pytest.approx(math.radians(10.0), rel=0.05)
    assert sign * (states[-1].course - states[0].course) > 0.0


@pytest.mark.parametrize("steepest", ["climb_gradient", "descent_gradient"])
def test_it_holds_the_steepest_path_that_its_file_promises(aircraft, steepest):
    gradient = getattr(aircraft.envelope, steepest) * (1.0 if steepest == "climb_gradient" else -1.0)
    late = fly(aircraft, 60.0, gradient=gradient)[800:]
    slope = np.polyfit(column(late, "t") * aircraft.envelope.speed, column(late, "z"), 1)[0]
    assert slope == pytest.approx(gradient, rel=0.05)
    assert column(late, "airspeed") == pytest.approx(aircraft.envelope.speed, rel=0.03)


@pytest.mark.parametrize("end", ["speed_min", "speed_max"])
def test_it_flies_level_and_turns_at_both_ends_of_its_envelope(aircraft, end):
    states = fly(aircraft, 40.0, bank=math.radians(30.0), speed=getattr(aircraft.envelope, end))
    assert {state.fault for state in states} == {""}
    assert np.abs(column(states, "z") - states[0].z).max() < 10.0
    assert channel(states, "stall_margin").min() > 0.0


def test_its_fuel_goes_down_and_its_load_factor_is_lift_over_weight(aircraft):
    states = fly(aircraft, 60.0, bank=math.radians(30.0))
    assert (np.diff(channel(states, "fuel")) <= 0.0).all()
    assert channel(states, "fuel")[-1] < channel(states, "fuel")[0]
    assert channel(states, "load_factor")[-200:].mean() == pytest.approx(1.0 / math.cos(math.radians(30.0)), rel=0.03)
