"""Planets to fly on: size, gravity and air, as closed forms that JSBSim is held to."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from planners.errors import InputError
from planners.frame import MARS_A, MARS_B, WGS84_A, WGS84_B, Frame
from planners.typed_toml import suggestion
from planners.units import METRES_PER_FOOT, STANDARD_GRAVITY
from sim.wind import Dryden

PASCALS_PER_PSF = 47.880259  # pound-force per square foot


@dataclass(frozen=True, slots=True)
class Planet:
    """A planet: ellipsoid of semi-axes `a`, `b` [m], `gm` [m^3/s^2] and `j2` of its gravitation, and its air.

    `gravity` [m/s^2] is that at the surface, for turns and load factors. `gas_constant` [J/kg/K] and `vibrations`, the
    (degeneracy, characteristic temperature [K]) of the molecules, give the speed of sound. `air` gives temperature [K]
    and pressure [Pa] at a height [m] above the ellipsoid. `daytime` is typical turbulence; None: JSBSim has its own.
    """

    name: str
    a: float
    b: float
    gm: float
    j2: float
    gravity: float
    gas_constant: float
    vibrations: tuple[tuple[int, float], ...]
    air: Callable[[float], tuple[float, float]]
    daytime: Dryden | None = None

    def frame(self) -> Frame:
        """A local frame where none is given: about latitude 0, longitude 0."""
        return Frame(0.0, 0.0, self.a, self.b)

    def gravitation(self, lat: float, height: float) -> float:
        """Gravitational acceleration [m/s^2] at the geodetic `lat` [deg], `height` [m]; the spin's share left out.

        Of a spheroid to J2 (Stevens, Lewis and Johnson 2016, eq. 1.6-19).
        """
        sin, cos = math.sin(math.radians(lat)), math.cos(math.radians(lat))
        normal = self.a**2 / math.hypot(self.a * cos, self.b * sin)
        x, z = (normal + height) * cos, (normal * (self.b / self.a) ** 2 + height) * sin
        r = math.hypot(x, z)
        share, up = 1.5 * self.j2 * (self.a / r) ** 2, 5.0 * (z / r) ** 2
        return self.gm / r**3 * math.hypot(x * (1.0 + share * (1.0 - up)), z * (1.0 + share * (3.0 - up)))

    def density(self, height: float) -> float:
        """Density of the air [kg/m^3] at `height` [m], p / (R T)."""
        temperature, pressure = self.air(height)
        return pressure / (self.gas_constant * temperature)

    def speed_of_sound(self, temperature: float) -> float:
        """Speed of sound [m/s] at `temperature` [K]: sqrt(gamma R T), gamma = cp / (cp - R).

        cp of a linear molecule: 7/2 R, and an Einstein function for each vibration.
        """
        heat = 3.5 + sum(count * _einstein(theta / temperature) for count, theta in self.vibrations)
        return math.sqrt(heat / (heat - 1.0) * self.gas_constant * temperature)


def planet_of(name: str) -> Planet:
    """The planet of that name; raises `InputError` for an unknown one."""
    planets = {planet.name: planet for planet in ALL_PLANETS}
    if name not in planets:
        raise InputError("planet", f"there is no planet {name!r}", suggestion(name, planets))
    return planets[name]


def _einstein(x: float) -> float:
    return float((0.5 * x / math.sinh(0.5 * x)) ** 2)


def _earth_air(height: float) -> tuple[float, float]:
    """ISO 2533:1975 up to 32 km: straight lines of temperature over geopotential height, in hydrostatic balance."""
    radius, gas = 6356766.0, 287.05287
    geopotential = radius * height / (radius + height)
    temperature, pressure = 288.15, 101325.0
    layers = ((-5000.0, 11000.0, -0.0065), (11000.0, 20000.0, 0.0), (20000.0, math.inf, 0.001))
    for bottom, top, lapse in layers:
        rise = min(geopotential, top) - max(bottom, 0.0)
        if bottom and geopotential <= bottom:
            break
        above = temperature + lapse * rise
        if lapse:
            pressure *= (above / temperature) ** (-STANDARD_GRAVITY / (gas * lapse))
        else:
            pressure *= math.exp(-STANDARD_GRAVITY * rise / (gas * temperature))
        temperature = above
    return temperature, pressure


def _mars_air(height: float) -> tuple[float, float]:
    """NASA Glenn Research Center, "Mars Atmosphere Model - Imperial Units": fits to Mars Global Surveyor, April 1996.

    As in JSBSim; the model's metric form is rounded otherwise, and 2 % apart at 2500 m.
    """
    feet = height / METRES_PER_FOOT
    fahrenheit = -25.68 - 0.000548 * feet if feet < 22960.0 else -10.34 - 0.001217 * feet
    return (fahrenheit + 459.67) / 1.8, 14.62 * PASCALS_PER_PSF * math.exp(-0.00003 * feet)


EARTH = Planet(
    "earth",
    WGS84_A,
    WGS84_B,
    gm=3.986004418e14,  # WGS 84, NGA.STND.0036
    j2=1.08262982e-3,  # the same
    gravity=STANDARD_GRAVITY,
    gas_constant=287.05287,  # ISO 2533:1975
    vibrations=(),
    air=_earth_air,
)
MARS = Planet(
    "mars",
    MARS_A,
    MARS_B,
    gm=4.2828376e13,  # as in planets/mars.xml, with its sources
    j2=1.96045e-3,
    gravity=3.71,  # NASA Mars Fact Sheet, at the equator
    gas_constant=188.92,  # of pure CO2
    vibrations=((2, 960.2), (1, 1917.9), (1, 3379.7)),  # 667, 1333 and 2349 /cm: Shimanouchi 1972, NSRDS-NBS 39
    air=_mars_air,
    # Viking 1 between 1.5 and 3.5 km: about 3 m/s (Seiff 1993, JGR 98 E4, 7461); length: 1750 ft of MIL-F-8785C
    daytime=Dryden(sigma=3.0, length=533.4),
)
ALL_PLANETS = (EARTH, MARS)
