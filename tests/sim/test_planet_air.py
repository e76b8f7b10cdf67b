import math
from dataclasses import replace

import numpy as np
import pytest
from pyproj import Geod

from planners.errors import InputError, TrackworthyError
from planners.frame import MARS_A, MARS_B, Frame
from sim.aircraft_file import load_aircraft
from sim.fixed_wing import STEP, FixedWing
from sim.jsbsim_model import load_model, start_in_equilibrium
from sim.planet import EARTH, MARS
from sim.planet_air import check_planet
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Dryden, Wind

FOOT, V = 0.3048, 140.0
START = Pose(0.0, 0.0, 1500.0, 0.0)
MARS_GEOD = Geod(a=MARS_A, b=MARS_B)


def trimmed(name, speed, height, lat=0.0):
    fdm = load_model(load_aircraft(name), STEP)
    start_in_equilibrium(fdm, replace(START, z=height), lat, 0.0, speed, Wind())
    return fdm


@pytest.mark.parametrize(("lat", "height"), [(0.0, 1500.0), (0.0, 300.0), (45.0, 2500.0), (-80.0, 1500.0)])
def test_jsbsim_flies_in_the_air_and_the_gravity_of_mars(lat, height):
    fdm = trimmed("ares", V, height, lat)
    check_planet(fdm, MARS, lat, height)
    density, temperature = 515.379 * fdm["atmosphere/rho-slugs_ft3"], fdm["atmosphere/T-R"] / 1.8
    pressure = 47.8803 * fdm["atmosphere/P-psf"]
    assert density == pytest.approx(pressure / (188.92 * temperature), rel=0.02)
    assert FOOT * fdm["accelerations/gravity-ft_sec2"] == pytest.approx(MARS.gravitation(lat, height), rel=1e-5)
    fdm.run()
    assert fdm["planet/mach"] == pytest.approx(V / MARS.speed_of_sound(temperature), rel=2e-4)
    assert V / fdm["planet/mach"] == pytest.approx(244.5, rel=0.01)


def test_the_mach_number_on_earth_is_jsbsims():
    fdm = trimmed("c172x", 55.0, 1000.0)
    fdm.run()
    assert fdm["planet/mach"] == pytest.approx(fdm["velocities/mach"], rel=1e-3)


@pytest.mark.parametrize("height", [100.0, 1000.0, 3000.0])
def test_the_earth_passes_for_the_earth_and_not_for_mars(height):
    """As JSBSim up to 1.3.1, which flies a planet file of Mars in the Earth's air."""
    fdm = trimmed("c172x", 55.0, height)
    check_planet(fdm, EARTH, 0.0, height)
    with pytest.raises(TrackworthyError, match=r"density of .* kg/m\^3, not the 0\.01.* of mars"):
        check_planet(fdm, MARS, 0.0, height)


@pytest.mark.parametrize(("course", "azimuth"), [(0.0, 90.0), (math.pi / 2, 0.0)])
def test_a_distance_flown_on_mars_is_the_geodesic_on_its_ellipsoid(course, azimuth):
    """Eastwards the equator's radius counts, northwards the meridian's, 1.2 % smaller; at height R / (R + h) of it."""
    aircraft, frame = FixedWing(load_aircraft("ares")), MARS.frame()
    aircraft.reset(replace(START, course=course), V, Conditions(), 0)
    for _ in range(1200):
        state = aircraft.step(Command(0.0, V, START.z))
    lat, lon = frame.to_geographic(np.array([[state.x, state.y]]))[0]
    flown_azimuth, _, distance = MARS_GEOD.inv(0.0, 0.0, lon, lat)
    assert flown_azimuth == pytest.approx(azimuth, abs=0.2)
    assert math.hypot(state.x, state.y) == pytest.approx(distance, abs=0.01)
    radius = MARS_A if azimuth else MARS_B**2 / MARS_A
    assert distance == pytest.approx(V * 60.0 * radius / (radius + START.z), rel=1e-4)


def test_a_c172x_on_mars_falls():
    """Its lift is 2 % of its weight: 1500 m take some 30 s, a stone's sqrt(2 h / g) = 28 s and some drag."""
    aircraft = FixedWing(load_aircraft("c172x"), MARS)
    first = aircraft.reset(START, 55.0, Conditions(), 0)
    assert first.channels[aircraft.channels.index("load_factor")] == pytest.approx(0.02, abs=0.01)
    assert first.channels[aircraft.channels.index("throttle")] == 1.0
    faults = {}
    while "ground" not in faults:
        state = aircraft.step(Command(0.0, 55.0, START.z))
        faults.setdefault(state.fault, state.t)
    assert faults["stall"] < 5.0
    assert faults["ground"] == pytest.approx(30.0, abs=3.0)


def test_at_home_no_equilibrium_is_the_users_business():
    with pytest.raises(InputError, match="no equilibrium for 1125 kg at 62 m/s and 9000 m"):
        FixedWing(load_aircraft("c172x")).reset(replace(START, z=9000.0), 62.0, Conditions(), 0)


def test_severities_of_the_earths_turbulence_are_refused_elsewhere():
    aircraft = FixedWing(load_aircraft("ares"))
    with pytest.raises(InputError, match=r"turbulence: .* not of mars; give dryden"):
        aircraft.reset(START, V, Conditions(turbulence=4), 0)
    aircraft.reset(START, V, Conditions(dryden=Dryden(1.0, 500.0)), 0)


def test_a_frame_of_another_planet_is_refused():
    with pytest.raises(InputError, match=r"frame: its ellipsoid of 6378137 m is not that of mars, 3396190 m"):
        FixedWing(load_aircraft("ares")).reset(START, V, Conditions(frame=Frame(0.0, 0.0)), 0)
