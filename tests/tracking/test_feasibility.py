import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.path import Path
from sample_paths import G, arcs, right_angle
from sim.vehicles import make_vehicle
from sim.wind import Wind
from tracking.feasibility import assess, required_radius

AIRCRAFT, TRUCK = make_vehicle("c172x").limits, make_vehicle("truck").limits
V = 55.0


def test_in_calm_a_turn_needs_the_coordinated_radius():
    assert required_radius(AIRCRAFT, V, Wind(), 0.3, 1.0) == pytest.approx(V**2 / (G * math.tan(math.radians(45.0))))


@given(st.floats(0.0, 20.0), st.floats(0.0, 360.0), st.floats(-3.0, 3.0), st.floats(-3.0, 3.0))
def test_in_wind_the_worst_heading_of_the_turn_decides(speed, direction, course, angle):
    """Vg^2 / (g tan(bank) cos(crab)) at any heading of the turn is at most what the turn requires."""
    wind = Wind.blowing_from(speed, direction)
    required = required_radius(AIRCRAFT, V, wind, course, angle)
    for bearing in (course, course + angle / 2, course + angle):
        along = wind.east * math.cos(bearing) + wind.north * math.sin(bearing)
        across = -wind.east * math.sin(bearing) + wind.north * math.cos(bearing)
        crab = math.asin(across / V)
        assert (V * math.cos(crab) + along) ** 2 / (G * math.cos(crab)) <= required * (1 + 1e-9)
    assert required <= (V + speed) ** 2 / (G * math.cos(math.asin(speed / V))) * (1 + 1e-9)


def test_turning_downwind_needs_more_than_turning_upwind():
    wind = Wind(east=10.0)
    assert required_radius(AIRCRAFT, V, wind, math.pi / 2, -math.pi / 2) == pytest.approx(65.0**2 / G, rel=1e-3)
    assert required_radius(AIRCRAFT, V, wind, math.pi / 2, math.pi / 2) < 57.0**2 / G


def test_a_wind_that_cannot_be_held_needs_an_infinite_radius():
    assert required_radius(AIRCRAFT, V, Wind(north=60.0), 0.0, 0.5) == math.inf


@pytest.mark.parametrize(("speed_kmh", "radius"), [(30.0, 11.80), (45.0, 26.56), (60.0, 47.21)])
def test_a_truck_needs_speed_squared_over_06_g(speed_kmh, radius):
    assert required_radius(TRUCK, speed_kmh / 3.6, Wind(north=9.0), 0.0, 1.0) == pytest.approx(radius, abs=0.01)


def test_a_crawling_truck_needs_its_steering_circle():
    assert required_radius(TRUCK, 1.0, Wind(), 0.0, 1.0) == pytest.approx(4.5)


def test_the_infeasible_stretches_are_named():
    found = assess(arcs(100.0, 1500.0), AIRCRAFT, V, Wind(), 30.0)
    assert len(found.stretches) == 4
    first = found.stretches[0]
    assert (first.s, first.s_end) == pytest.approx((1500.0, 1657.0), abs=50.0)
    assert first.worst.available == pytest.approx(100.0, rel=0.05)
    assert first.worst.margin == first.worst.available - first.worst.required


def test_corners_far_apart_are_stretches_of_their_own():
    corners = Path([[0.0, 0.0], [4000.0, 0.0], [4000.0, 4000.0], [8000.0, 4000.0]])
    found = assess(corners, AIRCRAFT, V, Wind(), 30.0)
    assert [(stretch.s, stretch.s_end) for stretch in found.stretches] == [(4000.0, 4000.0), (8000.0, 8000.0)]


def test_a_feasible_plan_has_none():
    found = assess(arcs(600.0, 1500.0), AIRCRAFT, V, Wind(), 30.0)
    assert found.stretches == ()
    assert found.steep == ()
    assert found.tightest is not None
    assert found.tightest.margin > 0.0


def test_a_straight_path_has_no_turns():
    found = assess(Path([[0.0, 0.0], [9.0, 0.0]]), TRUCK, 10.0, Wind(), 0.5)
    assert found.turns == ()
    assert found.tightest is None


def test_the_side_of_a_turn_is_its_sign():
    assert assess(right_angle(100.0), TRUCK, 10.0, Wind(), 0.5).turns[0].angle == pytest.approx(math.pi / 2)


def test_slopes_beyond_the_aircrafts_are_found_and_joined():
    heights = [0.0, 50.0, 250.0, 450.0, 450.0, 300.0]
    path = Path(np.column_stack([np.arange(6) * 1000.0, np.zeros(6), heights]))
    climb, descent = assess(path, AIRCRAFT, V, Wind(), 30.0).steep
    assert (climb.s, climb.s_end, climb.gradient) == pytest.approx((1000.0, 3000.0, 0.2))
    assert (descent.s, descent.s_end, descent.gradient) == pytest.approx((4000.0, 5000.0, -0.15))
    assert climb.limit > 0.0 > descent.limit


def test_a_climb_too_steep_is_flown_and_fails():
    from tracking.trial import Trial, run_trial

    path = Path([[0.0, 0.0, 500.0], [4000.0, 0.0, 1100.0]])
    outcome = run_trial(Trial("climb", path, "c172x"))
    assert not outcome.verdict.trackworthy
    assert len(outcome.feasibility.steep) == 1
    missed = {margin.requirement.metric for margin in outcome.verdict.margins if not margin.met}
    assert "altitude_error_max" in missed
