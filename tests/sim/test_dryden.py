import math
from itertools import islice, pairwise

import numpy as np
import pytest
from scipy.signal import welch

from planners.errors import InputError
from sim.aircraft_file import load_aircraft
from sim.dryden import dryden_gusts
from sim.fixed_wing import FixedWing
from sim.planet import MARS
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Dryden, Gust

V, L, DT = 140.0, 560.0, 0.4  # a tenth of L / V
SIGMA = (3.0, 2.0, 1.0)


def series(count, dt=DT, seed=0):
    """Gusts (count, 3): along, across, up; without the first ten lengths."""
    gusts = dryden_gusts(Dryden(SIGMA, L), V, dt, np.random.default_rng(seed))
    return np.array(list(islice(gusts, count)))[round(10.0 * L / V / dt) :]


@pytest.fixture(scope="module")
def long():
    return series(200_000)


def autocovariance(values, lag):
    return np.mean(values[lag:] * values[:-lag], axis=0)


def test_it_is_as_strong_as_asked(long):
    """20 000 lengths: the standard error of the variance is 1 %."""
    assert np.var(long, axis=0) == pytest.approx(np.square(SIGMA), rel=0.04)
    assert np.abs(np.mean(long, axis=0) / SIGMA).max() < 0.04


@pytest.mark.parametrize("lag", [1, 5, 10, 20, 40])
def test_it_forgets_as_dryden_says(long, lag):
    """Along e^(-r/L), across and up e^(-r/L) (1 - r / 2L), at a distance r."""
    r = 0.1 * lag
    expected = np.square(SIGMA) * math.exp(-r) * np.array([1.0, 1.0 - r / 2.0, 1.0 - r / 2.0])
    assert autocovariance(long, lag) == pytest.approx(expected, abs=0.03 * max(SIGMA) ** 2)


def test_its_spectra_are_those_of_the_standard(long):
    """MIL-F-8785C, 3.7.1.2, over Omega L = omega L / V, where sampling folds little back."""
    frequency, power = welch(long, fs=1.0 / DT, nperseg=2048, axis=0)
    chosen = (frequency > 0.005) & (frequency < 0.05 / DT)
    x = 2.0 * math.pi * frequency[chosen] * L / V
    along = 2.0 / math.pi / (1.0 + x**2)
    across = 1.0 / math.pi * (1.0 + 3.0 * x**2) / (1.0 + x**2) ** 2
    # per hertz instead of per rad/m
    expected = np.square(SIGMA) * 2.0 * math.pi * L / V * np.column_stack([along, across, across])
    ratio = power[chosen] / expected
    bands = np.array([band.mean(axis=0) for band in np.array_split(ratio, 4)])
    assert bands == pytest.approx(1.0, abs=0.12)


def test_the_time_step_does_not_change_the_statistics():
    """Ten times the step is every tenth value of the same process."""
    coarse = series(40_000, dt=10.0 * DT)
    assert np.var(coarse, axis=0) == pytest.approx(np.square(SIGMA), rel=0.04)
    expected = np.square(SIGMA) * math.exp(-1.0) * np.array([1.0, 0.5, 0.5])
    assert autocovariance(coarse, 1) == pytest.approx(expected, abs=0.03 * max(SIGMA) ** 2)


def test_axes_are_independent(long):
    assert np.abs(np.corrcoef(long.T) - np.eye(3)).max() < 0.03


def test_it_starts_from_calm_and_its_seed_decides_it():
    first, again, other = (
        np.array(list(islice(dryden_gusts(Dryden(2.0, L), V, 1 / 120, np.random.default_rng(seed)), 240)))
        for seed in (1, 1, 2)
    )
    assert np.abs(first[0]).max() < 0.5
    assert (first == again).all()
    assert not (first == other).any()


@pytest.mark.parametrize(
    "turbulence", [Dryden(-1.0, 500.0), Dryden(1.0, 0.0), Dryden(math.nan, 500.0), Dryden((1.0, 1.0, math.inf), 500.0)]
)
def test_what_is_no_turbulence_is_refused(turbulence):
    with pytest.raises(InputError, match=r"dryden: .* is no turbulence; give finite numbers"):
        FixedWing(load_aircraft("ares")).reset(Pose(0.0, 0.0, 1500.0, 0.0), V, Conditions(dryden=turbulence), 0)


def fly(dryden, seed, gust=None, seconds=20.0):
    aircraft = FixedWing(load_aircraft("ares"))
    states = [aircraft.reset(Pose(0.0, 0.0, 1500.0, 0.3), V, Conditions(dryden=dryden, gust=gust), seed)]
    states += [aircraft.step(Command(0.0, V, 1500.0)) for _ in range(round(seconds / aircraft.period))]
    return states


def test_the_aircraft_feels_it_and_the_same_seed_flies_the_same_bits():
    runs = [fly(MARS.daytime, seed) for seed in (0, 0, 1, -1)]
    assert runs[0] == runs[1]
    assert runs[0][-1] != runs[2][-1]
    assert runs[2][-1] != runs[3][-1]
    assert np.std([state.airspeed for state in runs[0]]) > 0.5
    calm = fly(Dryden(0.0, 500.0), 0)
    assert max(abs(after.airspeed - before.airspeed) for before, after in pairwise(calm)) < 1e-3


def test_it_adds_to_a_gust():
    """Airspeed in a gust in turbulence, less that in turbulence alone, is the gust, but for the aircraft's answer."""
    gust = Gust(-8.0 * math.cos(0.3), -8.0 * math.sin(0.3), 0.0, start=1.0, duration=1.0)
    both, alone = fly(MARS.daytime, 3, gust, 1.5), fly(MARS.daytime, 3, None, 1.5)
    assert both[-1].airspeed - alone[-1].airspeed == pytest.approx(8.0, abs=0.3)
    assert both[20].airspeed == alone[20].airspeed
