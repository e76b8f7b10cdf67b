import math
from itertools import pairwise

import numpy as np
import pytest

from planners.errors import InputError
from sim import fixed_wing
from sim.aircraft_file import load_aircraft
from sim.disturbance import SEEDS, jsbsim_seed
from sim.fixed_wing import FixedWing
from sim.jsbsim_model import load_model
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Gust, Wind

V, FOOT, KNOT = 55.0, 0.3048, 1852.0 / 3600.0
EASTWARDS = Pose(0.0, 0.0, 1000.0, 0.0)
GUST = Gust(east=-10.0, north=4.0, up=2.0, start=1.0, duration=2.0)
AXES = ("north", "east", "down")


@pytest.fixture
def fly(monkeypatch):
    """Fly level for `seconds`; the states, and beside them the named JSBSim properties (n, names)."""
    loaded = []
    monkeypatch.setattr(fixed_wing, "load_model", lambda *args: loaded.append(load_model(*args)) or loaded[-1])

    def run(conditions, seconds, names=(), seed=0, altitude=1000.0):
        aircraft = FixedWing(load_aircraft("c172x"))
        states = [aircraft.reset(Pose(0.0, 0.0, altitude, 0.0), V, conditions, seed)]
        command = Command(0.0, V, altitude)
        rows = [[loaded[-1][name] for name in names]]
        for _ in range(round(seconds / aircraft.period)):
            states.append(aircraft.step(command))
            rows.append([loaded[-1][name] for name in names])
        return states, np.array(rows)

    return run


@pytest.mark.parametrize(
    ("severity", "altitude", "sigma"),
    [
        # Table of MIL-F-8785C's figure 7 between 1750 and 3750 ft, the same along all axes
        (3, 1000.0, [FOOT * (6.9 + (1000.0 / FOOT - 1750.0) / 2000.0 * (7.4 - 6.9))] * 3),
        (4, 1000.0, [FOOT * (9.6 + (1000.0 / FOOT - 1750.0) / 2000.0 * (10.6 - 9.6))] * 3),
        # Below 1000 ft, sigma_w = 0.1 W20 and sigma_u = sigma_w / (0.177 + 0.000823 h)^0.4; W20 of severe is 45 kt
        (6, 150.0, [4.5 * KNOT / (0.177 + 0.000823 * 150.0 / FOOT) ** 0.4] * 2 + [4.5 * KNOT]),
    ],
)
def test_turbulence_is_as_strong_as_the_standard_says(fly, severity, altitude, sigma):
    """A Dryden process of time constant L/V has the standard error sqrt(L / (2 V T)) of its sigma: 13 % in 300 s.

    Of the components the second and third forget faster (0.6 L/V); pooled, 6 %: within 15 %, 2.5 standard errors.
    """
    names = [f"atmosphere/turb-{axis}-fps" for axis in AXES]
    _, velocities = fly(Conditions(turbulence=severity), 320.0, names, altitude=altitude)
    velocities = FOOT * velocities[400:]
    assert np.mean((velocities / sigma) ** 2) ** 0.5 == pytest.approx(1.0, abs=0.15)
    assert np.std(velocities / sigma, axis=0) == pytest.approx(1.0, abs=0.4)
    assert np.abs(np.corrcoef(velocities.T) - np.eye(3)).max() < 0.5


@pytest.mark.parametrize("conditions", [Conditions(turbulence=4), Conditions(Wind(3.0, -8.0), turbulence=6, gust=GUST)])
def test_the_aircraft_feels_it(fly, conditions):
    """Air velocity is ground velocity minus wind, and the wind is the steady one, the gust and the turbulence."""
    parts = [f"atmosphere/{kind}-{axis}-fps" for kind in ("total-wind", "wind", "gust", "turb") for axis in AXES]
    ground = [f"velocities/v-{axis}-fps" for axis in AXES]
    states, rows = fly(conditions, 4.0, [*parts, *ground])
    total, wind, gust, turbulence, velocity = np.split(rows[1:], 5, axis=1)
    assert total == pytest.approx(wind + gust + turbulence, abs=1e-9)
    airspeed = FOOT * np.linalg.norm(velocity - total, axis=1)
    assert airspeed == pytest.approx(np.array([state.airspeed for state in states[1:]]), abs=1e-6)
    assert np.ptp(airspeed) > 1.0


def test_the_same_seed_gives_the_same_bits_and_another_seed_another_weather(fly):
    runs = {seed: fly(Conditions(turbulence=4), 2.0, seed=seed)[0] for seed in (0, 1, -1, 2**31 - 1, 2**63 + 1)}
    assert fly(Conditions(turbulence=4), 2.0, seed=1)[0] == runs[1]
    for one, other in pairwise(runs.values()):
        assert one[0] == other[0]  # in equilibrium, in calm
        assert one[1:] != other[1:]
    assert fly(Conditions(), 2.0, seed=0)[0] == fly(Conditions(), 2.0, seed=1)[0]


def test_any_seed_becomes_one_of_jsbsims_and_neighbours_do_not_meet():
    seeds = {jsbsim_seed(seed) for seed in (*range(-1000, 1000), 2**63, -(2**63), 2**64 - 1)}
    assert len(seeds) == 2003
    assert min(seeds) >= 1
    assert max(seeds) <= SEEDS


def test_a_gust_is_one_minus_cosine_in_its_place_and_time(fly):
    names = [f"atmosphere/total-wind-{axis}-fps" for axis in AXES]
    calm, no_wind = fly(Conditions(), 4.0, names)
    states, rows = fly(Conditions(gust=GUST), 4.0, names)
    t = np.array([state.t for state in states])
    during = (t > 1.0) & (t < 3.0)
    share = np.where(during, (1.0 - np.cos(2.0 * math.pi * (t - 1.0) / 2.0)) / 2.0, 0.0)
    assert FOOT * rows == pytest.approx(np.outer(share, (4.0, -10.0, -2.0)), abs=1e-9)
    assert np.all(rows[t > 3.0 + 1e-9] == no_wind[t > 3.0 + 1e-9])
    before = [state for state in states if state.t <= 1.0]
    assert before == calm[: len(before)]


def test_a_head_gust_is_airspeed_gained_less_what_drag_takes():
    """10 m/s at its peak after a second; drag at 55 m/s is about a tenth of the weight, a gust's worth 0.5 m/s."""
    aircraft = FixedWing(load_aircraft("c172x"))
    aircraft.reset(EASTWARDS, V, Conditions(gust=Gust(-10.0, 0.0, 0.0, 0.0, 2.0)), 0)
    airspeeds = [aircraft.step(Command(0.0, V, 1000.0)).airspeed for _ in range(20)]
    assert airspeeds[-1] == pytest.approx(V + 10.0, abs=1.0)


@pytest.mark.parametrize("severity", [-1.0, 3.5, 8.0, math.nan, math.inf])
def test_a_severity_off_the_chart_is_refused(severity):
    with pytest.raises(InputError, match=r"turbulence: .* is not a severity; choose .* 0 \(none\) to 7") as error:
        FixedWing(load_aircraft("c172x")).reset(EASTWARDS, V, Conditions(turbulence=severity), 0)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    "gust",
    [
        Gust(1.0, 0.0, 0.0, 5.0, 0.0),
        Gust(1.0, 0.0, 0.0, 5.0, -2.0),
        Gust(1.0, 0.0, 0.0, 5.0, math.nan),
        Gust(1.0, 0.0, 0.0, -5.0, 2.0),
        Gust(math.inf, 0.0, 0.0, 5.0, 2.0),
    ],
)
def test_what_is_no_gust_is_refused(gust):
    with pytest.raises(InputError, match=r"gust: .* is none; give"):
        FixedWing(load_aircraft("c172x")).reset(EASTWARDS, V, Conditions(gust=gust), 0)
