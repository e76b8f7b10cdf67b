"""A planet in JSBSim: loaded, given its true Mach number, and held to our closed forms."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import jsbsim

from planners.errors import TrackworthyError
from planners.units import METRES_PER_FOOT
from sim.planet import EARTH, Planet

PLANETS_FOLDER = Path(__file__).parent / "planets"
TEMPERATURES = range(100, 401, 10)  # [K] in which the speed of sound is tabulated, to 1e-4 between them
RANKINE_PER_KELVIN = 1.8
KILOGRAMS_PER_CUBIC_METRE = 515.378818  # in a slug per cubic foot
AIR_TOLERANCE = 0.02  # JSBSim's Mars has a gas constant 1.2 % above that of CO2
TEMPERATURE_TOLERANCE = 0.01
GRAVITY_TOLERANCE = 0.002


def load_planet(fdm: jsbsim.FGFDMExec, planet: Planet) -> None:
    """Put `fdm`, which has no aircraft yet, on `planet`."""
    file = PLANETS_FOLDER / f"{planet.name}.xml"
    if planet != EARTH and not fdm.load_planet(str(file), False):
        raise TrackworthyError(f"JSBSim cannot load {file}")


def add_mach(model: ET.Element, planet: Planet) -> None:
    """Give the JSBSim `model` the property planet/mach, the true Mach number on `planet`.

    JSBSim's own has the speed of sound of air on Earth, 39 % too high on Mars.
    """
    system = ET.SubElement(model, "system", name="planet")
    function = ET.SubElement(
        ET.SubElement(ET.SubElement(system, "channel", name="Mach"), "fcs_function", name="planet/mach"), "function"
    )
    quotient = ET.SubElement(function, "quotient")
    ET.SubElement(quotient, "property").text = "velocities/vt-fps"
    table = ET.SubElement(quotient, "table")
    ET.SubElement(table, "independentVar").text = "atmosphere/T-R"
    ET.SubElement(table, "tableData").text = "\n".join(
        f"{RANKINE_PER_KELVIN * kelvin:.6g} {planet.speed_of_sound(kelvin) / METRES_PER_FOOT:.8g}"
        for kelvin in TEMPERATURES
    )


def check_planet(fdm: jsbsim.FGFDMExec, planet: Planet, lat: float, height: float) -> None:
    """Raise `TrackworthyError` where JSBSim flies in other air or gravity than that of `planet`.

    JSBSim up to 1.3.1 flies a planet file of Mars in the Earth's air without a word.
    """
    quantities = (
        ("density", "kg/m^3", fdm["atmosphere/rho-slugs_ft3"] * KILOGRAMS_PER_CUBIC_METRE, planet.density(height)),
        ("temperature", "K", fdm["atmosphere/T-R"] / RANKINE_PER_KELVIN, planet.air(height)[0]),
        (
            "gravity",
            "m/s^2",
            fdm["accelerations/gravity-ft_sec2"] * METRES_PER_FOOT,
            planet.gravitation(lat, height),
        ),
    )
    tolerances = (AIR_TOLERANCE, TEMPERATURE_TOLERANCE, GRAVITY_TOLERANCE)
    for (name, unit, flown, true), tolerance in zip(quantities, tolerances, strict=True):
        if not abs(flown / true - 1.0) <= tolerance:
            raise TrackworthyError(
                f"JSBSim {jsbsim.__version__} flies at a {name} of {flown:.4g} {unit}, "
                f"not the {true:.4g} {unit} of {planet.name} at {height:.0f} m; use JSBSim 1.3.3 or later"
            )
