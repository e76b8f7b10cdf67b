import numpy as np
import pytest

from planners.path import Path
from sim.vehicle import Conditions
from sim.vehicles import make_vehicle
from tracking.feasibility import assess
from tracking.metrics.fuel import fuel
from tracking.run import Run
from tracking.track import Track

LINE = Path([[0.0, 0.0], [1000.0, 0.0]])
LIMITS = make_vehicle("truck").limits


def burned(**columns):
    data = np.column_stack([np.linspace(0.0, 1000.0, 11), np.zeros(11), *columns.values()])
    track = Track(("x", "y", *columns), data, "completed")
    run = Run(LINE, track, LIMITS, 10.0, 0.5, Conditions(), assess(LINE, LIMITS, 10.0, Conditions().wind, 0.5))
    return {metric.name: metric for metric in fuel(run)}


def test_range_is_the_distance_flown_times_all_fuel_over_that_used():
    found = burned(fuel=np.linspace(50.0, 48.0, 11))
    assert found["fuel_used"].value == pytest.approx(2.0)
    assert found["fuel_range"].value == pytest.approx(25_000.0)


def test_without_consumption_there_is_no_range():
    found = burned(fuel=np.full(11, 50.0))
    assert (found["fuel_used"].value, found["fuel_range"].valid) == (0.0, False)


def test_what_has_no_tank_has_no_fuel():
    assert burned() == {}
