"""A mass at an aircraft's centre of gravity that makes it as heavy, or as light, as a trial wants it."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET

import jsbsim

from planners.errors import InputError
from sim.jsbsim_log import listening

INDEX = "ballast/point-mass"  # property: which of the model's point masses is ours


def add_ballast(model: ET.Element) -> None:
    """Give the JSBSim `model` one more point mass, of no weight; after its own, whose numbers must stay."""
    balance = model.find("mass_balance")
    if balance is None or balance.get("file"):
        return
    index = len(balance.findall("pointmass"))
    point = ET.SubElement(balance, "pointmass", name="ballast")
    ET.SubElement(point, "weight", unit="LBS").text = "0"
    location = ET.SubElement(point, "location", unit="IN")
    for axis in "xyz":
        ET.SubElement(location, axis).text = "0"
    system = ET.SubElement(model, "system", name="ballast")
    ET.SubElement(system, "property", value=str(index)).text = INDEX


def scale_mass(fdm: jsbsim.FGFDMExec, factor: float) -> None:
    """Multiply the mass of the aircraft, with fuel and payload, by `factor`; before it is put into the air.

    At the centre of gravity, which stays where it is, so moments of inertia stay too. Raises `InputError` for what is
    no factor; whether the aircraft flies at that mass is for trim to say.
    """
    if not 0.0 < factor < math.inf:
        raise InputError("mass", f"{factor:g} times its mass is none", "choose a factor above 0, as 1.2")
    if factor == 1.0:
        return
    if fdm.get_property_manager().get_node(INDEX) is None:
        raise InputError("mass", "the aircraft's model has its mass_balance in another file", "leave its mass as it is")
    with listening():
        fdm.run_ic()  # tanks count only from here on
    index = int(fdm[INDEX])
    for axis in "xyz":
        fdm[f"inertia/pointmass-location-{axis.upper()}-inches[{index}]"] = fdm[f"inertia/cg-{axis}-in"]
    fdm[f"inertia/pointmass-weight-lbs[{index}]"] = (factor - 1.0) * fdm["inertia/weight-lbs"]
