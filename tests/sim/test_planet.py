import math
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.errors import InputError
from sim.planet import ALL_PLANETS, EARTH, MARS, planet_of
from sim.vehicles import make_vehicle


@pytest.mark.parametrize(("lat", "normal"), [(0.0, 9.7803253359), (90.0, 9.8321849378)])
def test_gravitation_less_the_spin_is_normal_gravity(lat, normal):
    """Normal gravity of WGS 84, NGA.STND.0036; a field to J2 alone differs from it by 1e-5."""
    spin = 7.292115e-5**2 * EARTH.a * math.cos(math.radians(lat))
    assert EARTH.gravitation(lat, 0.0) - spin == pytest.approx(normal, rel=2e-5)


def test_gravity_on_mars_is_that_of_the_fact_sheet():
    """3.71 m/s^2 at the equator, where the spin takes 0.017 m/s^2."""
    assert MARS.gravitation(0.0, 0.0) - 7.088218e-5**2 * MARS.a == pytest.approx(3.71, rel=2e-3)


@given(st.sampled_from(ALL_PLANETS), st.floats(-90.0, 90.0), st.floats(0.0, 20e3))
def test_gravitation_falls_with_the_square_of_the_distance(planet, lat, height):
    """To 4 m in 6 times the height: the ellipsoid's normal is not quite the radius."""
    expected = planet.gravitation(lat, 0.0) * (1.0 - 2.0 * height / planet.a)
    assert planet.gravitation(lat, height) == pytest.approx(expected, rel=2e-4)


@pytest.mark.parametrize(
    ("height", "temperature", "pressure"),
    [
        (0.0, 288.15, 101325.0),
        (5000.0, 255.676, 54048.0),
        (10000.0, 223.252, 26500.0),
        (15000.0, 216.65, 12112.0),
        (25000.0, 221.552, 2549.2),
    ],
)
def test_air_on_earth_is_the_standard_atmosphere(height, temperature, pressure):
    """U.S. Standard Atmosphere 1976, table I."""
    assert EARTH.air(height) == (pytest.approx(temperature, abs=0.01), pytest.approx(pressure, rel=2e-4))


def test_air_on_mars_at_1500_m():
    """NASA Glenn's model in its metric form: -31 - 0.000998 h deg C, 0.699 exp(-0.00009 h) kPa, rounded otherwise."""
    temperature, pressure = MARS.air(1500.0)
    assert temperature == pytest.approx(273.15 - 32.5, abs=1.1)
    assert pressure == pytest.approx(699.0 * math.exp(-0.135), rel=0.015)
    assert MARS.density(1500.0) == pytest.approx(0.0132, rel=0.015)


@pytest.mark.parametrize(
    ("temperature", "heat"),
    [(175.0, 709.0), (200.0, 735.0), (225.0, 763.0), (250.0, 791.0), (275.0, 819.0), (300.0, 846.0)],
)
def test_the_speed_of_sound_on_mars_is_that_of_the_tabulated_heat_capacity(temperature, heat):
    """Heat capacity cp [J/kg/K] of CO2: The Engineering ToolBox (2005), "Carbon Dioxide - Specific Heat of Gas"."""
    sound = math.sqrt(heat / (heat - 188.92) * 188.92 * temperature)
    assert MARS.speed_of_sound(temperature) == pytest.approx(sound, rel=1e-3)


def test_the_speed_of_sound_in_carbon_dioxide_and_air_at_0_c():
    """259 m/s and 331.4 m/s: CRC Handbook of Chemistry and Physics, "Speed of Sound in Various Media"."""
    assert MARS.speed_of_sound(273.15) == pytest.approx(259.0, abs=0.5)
    assert EARTH.speed_of_sound(273.15) == pytest.approx(331.4, abs=0.2)


def test_planets_by_name():
    assert planet_of("mars") is MARS
    with pytest.raises(InputError, match=r"planet: there is no planet 'marz'; did you mean 'mars'"):
        planet_of("marz")


@pytest.mark.parametrize("planet", ALL_PLANETS)
def test_a_planet_passes_between_processes(planet):
    assert pickle.loads(pickle.dumps(planet)) == planet


def test_a_vehicle_is_at_home_unless_told_otherwise():
    earthly, at_home, away = make_vehicle("c172x"), make_vehicle("ares"), make_vehicle("c172x", planet=MARS)
    assert earthly.limits.lateral_acceleration == pytest.approx(9.80665)  # g tan(45 deg)
    assert at_home.limits.lateral_acceleration == pytest.approx(3.71)
    assert away.limits.lateral_acceleration == pytest.approx(3.71)
