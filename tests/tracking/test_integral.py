import pytest

from sim.vehicles import make_vehicle
from tracking.integral import Integral

LIMITS = make_vehicle("c172x").limits
V, DT = 55.0, 0.05


def after(steps, error, saturated=False, start=None):
    integral = start or Integral(LIMITS, LIMITS.corridor, DT)
    for _ in range(steps):
        curvature = integral.curvature(error, V, saturated)
    return curvature


def test_it_turns_towards_the_path_and_grows_with_the_error():
    assert after(10, 5.0) < 0.0 < after(10, -5.0)
    assert after(20, 5.0) == pytest.approx(2 * after(10, 5.0))


def test_it_stands_still_while_the_vehicle_is_saturated():
    integral = Integral(LIMITS, LIMITS.corridor, DT)
    before = after(10, 5.0, start=integral)
    assert after(100, 5.0, saturated=True, start=integral) == before


def test_an_error_beyond_the_corridor_counts_as_the_corridor():
    assert after(10, 500.0) == after(10, LIMITS.corridor)


def test_it_stays_within_what_the_vehicle_can_turn():
    assert abs(after(100_000, 30.0)) == pytest.approx(1.0 / LIMITS.turn_radius(V), rel=0.01)
