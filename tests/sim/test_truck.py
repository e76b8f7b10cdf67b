import math

import numpy as np
import pytest
from highway_env.vehicle.kinematics import Vehicle as HighwayVehicle

from sim.truck import Truck
from sim.truck_limits import WHEELBASE
from sim.vehicle import Command, Conditions, Pose

G = 9.80665


def drive(truck, speed, curvature, seconds, conditions=None):
    truck.reset(Pose(0.0, 0.0, 0.0, 0.0), speed, conditions or Conditions(), 0)
    return [truck.step(Command(curvature, speed)) for _ in range(round(seconds / truck.period))]


def circle_radius(x, y):
    """Radius of the circle through points, least squares (Kasa 1976)."""
    a = np.column_stack([2 * x, 2 * y, np.ones_like(x)])
    cx, cy, c = np.linalg.lstsq(a, x**2 + y**2, rcond=None)[0]
    return math.sqrt(c + cx**2 + cy**2)


@pytest.mark.parametrize("steering_deg", [-20.0, 5.0, 20.0, 40.0])
def test_the_rear_axle_circles_at_wheelbase_over_tan_delta_and_the_centre_farther_out(steering_deg):
    delta = math.radians(steering_deg)
    states = drive(Truck(), 3.0, math.tan(delta) / WHEELBASE, 40.0)[200:]
    x, y = np.array([state.x for state in states]), np.array([state.y for state in states])
    heading = np.array([state.heading for state in states])
    rear = WHEELBASE / abs(math.tan(delta))
    # highway-env's explicit Euler step of 0.01 s puts the centre up to 6 mm beside the circle's tangent
    assert circle_radius(x, y) == pytest.approx(rear, rel=2e-3)
    centre_x, centre_y = x + WHEELBASE / 2 * np.cos(heading), y + WHEELBASE / 2 * np.sin(heading)
    assert circle_radius(centre_x, centre_y) == pytest.approx(math.hypot(rear, WHEELBASE / 2), rel=2e-3)


def test_highway_env_integrates_it(monkeypatch):
    steps = []
    own = HighwayVehicle.step
    monkeypatch.setattr(HighwayVehicle, "step", lambda self, dt: (steps.append(dt), own(self, dt)))
    drive(Truck(), 5.0, 0.0, 1.0)
    assert sum(steps) == pytest.approx(1.0)


@pytest.mark.parametrize(("friction", "grip"), [(0.3, 0.3), (1.0, 1.0), (None, 0.8)])
def test_beyond_its_grip_it_runs_wide(friction, grip):
    speed = 60.0 / 3.6
    states = drive(Truck(), speed, 1.2 * G / speed**2, 10.0, Conditions(friction=friction))
    lateral = np.array([state.channels[2] for state in states])
    grip_used = np.array([state.channels[3] for state in states])
    assert lateral.max() == pytest.approx(grip * G, rel=1e-3)
    assert grip_used.max() == pytest.approx(1.0, rel=1e-3)
    assert states[-1].saturated


def test_within_its_grip_lateral_acceleration_is_speed_squared_times_curvature():
    speed = 12.5
    state = drive(Truck(), speed, 0.5 * G / speed**2, 10.0)[-1]
    assert state.channels[2] == pytest.approx(0.5 * G, rel=1e-3)
    assert not state.saturated


def test_it_holds_its_speed_at_the_rear_axle():
    truck = Truck()
    truck.reset(Pose(0.0, 0.0, 0.0, 0.0), 10.0, Conditions(), 0)
    speeds = [truck.step(Command(0.0, 12.0)).ground_speed for _ in range(200)]
    assert np.diff(speeds).max() == pytest.approx(2.0 * truck.period, rel=1e-6)
    assert speeds[-1] == pytest.approx(12.0, rel=1e-3)
    curve = [truck.step(Command(0.08, 12.0)).ground_speed for _ in range(200)]
    assert curve[-1] == pytest.approx(12.0, rel=1e-3)


def test_full_steering_reaches_its_limits_and_no_more():
    """From straight ahead to the largest curvature: the rate at once, the angle in the end."""
    truck = Truck()
    states = drive(truck, 2.0, 1.0, 5.0)
    angles, rates = (np.array([state.channels[i] for state in states]) for i in (0, 1))
    assert rates.max() == pytest.approx(truck.limits.steering_rate)
    assert angles[-1] == pytest.approx(truck.limits.steering_max, rel=1e-3)
    assert angles.max() <= truck.limits.steering_max
