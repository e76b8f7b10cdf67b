import math
from functools import lru_cache

import numpy as np
import pytest

from planners.errors import InputError
from sim.aircraft_file import load_aircraft
from sim.fixed_wing import STEP
from sim.jsbsim_model import load_model, start_in_equilibrium
from sim.modes import modes_of
from sim.planet import EARTH, MARS
from sim.vehicle import Pose
from sim.wind import Wind

CASES = {"ares": (MARS, 140.0, 1500.0), "c172x": (EARTH, 55.0, 1000.0)}


@lru_cache
def modes(name):
    planet, speed, altitude = CASES[name]
    return {mode.name: mode for mode in modes_of(load_aircraft(name), planet, speed, altitude)}


@pytest.fixture(scope="module", params=CASES)
def name(request):
    return request.param


def disturbed(name, cause, change, seconds, watched):
    """The property `watched` (n,) at every step after half a second of a change, no loops closed; less its drift."""
    _, speed, altitude = CASES[name]
    fdm = load_model(load_aircraft(name), STEP)
    start_in_equilibrium(fdm, Pose(0.0, 0.0, altitude, 0.0), 0.0, 0.0, speed, Wind())
    before, values = fdm[cause], []
    for i in range(round(seconds / STEP)):
        fdm[cause] = before + (change if i * STEP < 0.5 else 0.0)
        fdm.run()
        values.append(fdm[watched])
    values = np.array(values[round(0.5 / STEP) :])
    steps = np.arange(len(values))
    return values - np.polyval(np.polyfit(steps, values, 1), steps)


def frequency_of(values):
    """Damped frequency [rad/s] from the first and the last of the times at which `values` rise through 0."""
    rising = np.flatnonzero((values[:-1] < 0.0) & (values[1:] >= 0.0))
    return 2.0 * math.pi * (len(rising) - 1) / ((rising[-1] - rising[0]) * STEP)


def test_every_aircraft_has_the_five_modes(name):
    found = modes(name)
    assert set(found) == {"short period", "phugoid", "Dutch roll", "roll", "spiral"}
    assert found["short period"].frequency > 5.0 * found["phugoid"].frequency
    assert found["roll"].time_constant < 0.1 * abs(found["spiral"].time_constant)


def test_the_dutch_roll_swings_in_flight_as_linearised(name):
    dutch_roll = modes(name)["Dutch roll"]
    damped = dutch_roll.frequency * math.sqrt(1.0 - dutch_roll.damping**2)
    sideslip = disturbed(name, "fcs/rudder-cmd-norm", 0.05, 4.0 * 2.0 * math.pi / damped, "aero/beta-rad")
    assert frequency_of(sideslip) == pytest.approx(damped, rel=0.05)


def test_the_phugoid_swings_in_flight_as_linearised():
    """Of ares: that of c172x is faster, since its propeller changes speed."""
    phugoid = modes("ares")["phugoid"]
    seconds = 2.7 * 2.0 * math.pi / phugoid.frequency
    climb = disturbed("ares", "atmosphere/gust-down-fps", 5.0, seconds, "velocities/h-dot-fps")
    assert frequency_of(climb) == pytest.approx(phugoid.frequency, rel=0.1)


def test_the_phugoid_is_lanchesters_and_slower_with_much_pitch_damping():
    """sqrt(2) g / V, times sqrt(M_alpha) over the short period's frequency (McRuer, Ashkenas and Graham 1973, ch. 5).

    M_alpha of ares is nearly all of its short period; that of c172x, whose pitch is damped by 0.7, half of it.
    """
    assert modes("ares")["phugoid"].frequency == pytest.approx(math.sqrt(2.0) * 3.71 / 140.0, rel=0.1)
    assert 0.7 < modes("c172x")["phugoid"].frequency / (math.sqrt(2.0) * 9.8 / 55.0) < 0.9


def test_the_modes_of_ares_are_those_of_its_derivatives():
    """Two-degree-of-freedom approximations (Etkin and Reid 1996, ch. 6) with the derivatives of ares.xml in cruise."""
    speed, mass, density = 140.0, 149.0, 0.01318
    area, span, chord = 7.0, 6.25, 1.12
    wing, tail, fin, downwash = 4.86, 4.20, 2.71, 0.555  # lift slopes [1/rad] and downwash slope
    slope = wing + 0.19 * tail * (1.0 - downwash)
    force = 0.5 * density * speed**2 * area
    found = modes("ares")

    lift = slope * force / (mass * speed)
    pitching = force * chord / 107.0
    pitch_damping = 1.892 * tail * chord / (2.0 * speed) * pitching
    frequency = math.sqrt(0.1 * slope * pitching + lift * pitch_damping)
    short = found["short period"]
    assert short.frequency == pytest.approx(frequency, rel=0.03)
    assert 2.0 * short.damping * short.frequency == pytest.approx(lift + (1.0 + downwash) * pitch_damping, rel=0.05)

    rolling = force * span / 91.0
    assert found["roll"].time_constant == pytest.approx(2.0 * speed / span / (0.1389 * wing * rolling), rel=0.1)

    yawing = force * span / 162.0
    frequency = math.sqrt((0.0488 * fin - 0.03) * yawing)
    assert found["Dutch roll"].frequency == pytest.approx(frequency, rel=0.05)
    assert found["Dutch roll"].damping < 0.05
    assert found["spiral"].half_time < -60.0


def test_time_constants_and_half_times_follow_from_the_decay(name):
    for mode in modes(name).values():
        assert mode.half_time == pytest.approx(math.log(2.0) * mode.time_constant)
        assert mode.decay == pytest.approx(mode.damping * mode.frequency)


def test_an_aircraft_without_equilibrium_has_no_modes():
    with pytest.raises(InputError, match="no equilibrium"):
        modes_of(load_aircraft("c172x"), MARS, 55.0, 1500.0)
