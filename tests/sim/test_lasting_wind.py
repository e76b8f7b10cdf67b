import math

import numpy as np
import pytest

from sim import autopilot
from sim.aircraft_file import load_aircraft
from sim.fixed_wing import FixedWing
from sim.lasting_wind import LastingWind
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Gust, Wind

V, FOOT = 55.0, 0.3048
EASTWARDS = Pose(0.0, 0.0, 1000.0, 0.0)
ALTITUDE_BOUND = 30.48  # 100 ft, the default requirement


@pytest.fixture
def fly(monkeypatch):
    """Fly at 1000 m; altitude errors, airspeeds, and the airspeeds in the lasting wind [m, m/s, m/s]."""
    lasting = []

    class Recorded(LastingWind):
        def airspeed(self):
            lasting.append(super().airspeed())
            return lasting[-1]

    monkeypatch.setattr(autopilot, "LastingWind", Recorded)

    def run(conditions, seconds, seed=0, curvature=0.0, speed=V):
        lasting.clear()
        aircraft = FixedWing(load_aircraft("c172x"))
        states = [aircraft.reset(EASTWARDS, speed, conditions, seed)]
        states += [aircraft.step(Command(curvature, speed, 1000.0)) for _ in range(round(seconds / aircraft.period))]
        return tuple(np.array(c) for c in ([s.z - 1000.0 for s in states], [s.airspeed for s in states], lasting))

    return run


@pytest.mark.parametrize("wind", [Wind(), Wind(10.0, -5.0)])
def test_in_a_steady_wind_it_is_the_airspeed_in_turns_too(fly, wind):
    _, airspeed, lasting = fly(Conditions(wind), 60.0, curvature=1 / 500.0)
    assert lasting == pytest.approx(airspeed[:-1], abs=0.01)
    assert np.ptp(lasting) > 0.1


def test_a_lull_that_passes_commands_no_descent(fly):
    """10 m/s from behind, 1 - cos over 5 s: the low pass of 10 s lets through less than its mean, 5 m/s 5 s / 10 s."""
    altitude, airspeed, lasting = fly(Conditions(gust=Gust(10.0, 0.0, 0.0, 5.0, 5.0)), 40.0)
    assert airspeed.min() < V - 8.0
    assert lasting.min() > V - 2.5
    assert np.abs(altitude).max() < 3.0


def test_a_wind_that_lasts_counts(fly):
    """1 - cos over 120 s is slow against 10 s: the airspeed held is the true one, within the lag of the low pass.

    That is its rate times 10 s, at most 10 s * pi * 10 m/s / 120 s = 2.6 m/s.
    """
    _, airspeed, lasting = fly(Conditions(gust=Gust(10.0, 0.0, 0.0, 5.0, 120.0)), 130.0)
    lag = 10.0 * math.pi * 10.0 / 120.0
    assert np.abs(lasting - airspeed[:-1]).max() == pytest.approx(lag, rel=0.2)


@pytest.mark.parametrize(("severity", "sigma"), [(3, FOOT * 7.3), (4, FOOT * 10.4)])
def test_turbulence_neither_makes_it_descend_nor_adds_to_its_airspeed(fly, severity, sigma):
    """Five minutes level in five weathers, light and moderate (`sigma` of MIL-F-8785C, figure 7, at 1000 m).

    Altitude: three sigma within the default bound. Airspeed: at most what a constant ground velocity would meet.
    """
    runs = [fly(Conditions(turbulence=severity), 300.0, seed) for seed in range(5)]
    altitude, airspeed = (np.concatenate([run[k] for run in runs]) for k in (0, 1))
    assert 3.0 * np.mean(altitude**2) ** 0.5 < ALTITUDE_BOUND
    assert abs(altitude.mean()) < 3.0
    assert np.mean((airspeed - V) ** 2) ** 0.5 < sigma


def test_near_the_slowest_speed_the_same_lull_takes_the_climb_away(fly):
    """At 38 m/s it leaves less than the envelope's slowest, 35 m/s, and airspeed comes before altitude at once."""
    altitude, _, lasting = fly(Conditions(gust=Gust(10.0, 0.0, 0.0, 5.0, 5.0)), 40.0, speed=38.0)
    assert lasting.min() > 38.0 - 4.0  # within the reserve
    assert altitude.min() < -5.0
