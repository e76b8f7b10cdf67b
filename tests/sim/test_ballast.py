import math
import xml.etree.ElementTree as ET
from statistics import fmean

import jsbsim
import pytest

from planners.errors import InputError
from sim.aircraft_file import load_aircraft
from sim.ballast import add_ballast, scale_mass
from sim.fixed_wing import STEP, FixedWing
from sim.jsbsim_model import load_model, start_in_equilibrium
from sim.vehicle import Command, Conditions, Pose
from sim.wind import Wind

V = 55.0
START = Pose(0.0, 0.0, 1000.0, 0.3)
BALANCE = ("cg-x-in", "cg-y-in", "cg-z-in", "ixx-slugs_ft2", "iyy-slugs_ft2", "izz-slugs_ft2", "ixz-slugs_ft2")


def trimmed(factor):
    fdm = load_model(load_aircraft("c172x"), STEP)
    scale_mass(fdm, factor)
    start_in_equilibrium(fdm, START, 47.0, 8.0, V, Wind())
    return fdm


@pytest.mark.parametrize("factor", [0.5, 0.9, 1.2, 2.0])
def test_mass_is_multiplied_where_the_centre_of_gravity_is(factor):
    own, other = trimmed(1.0), trimmed(factor)
    assert other["inertia/mass-slugs"] == pytest.approx(factor * own["inertia/mass-slugs"], rel=1e-12)
    for name in BALANCE:
        assert other[f"inertia/{name}"] == pytest.approx(own[f"inertia/{name}"], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("factor", [0.5, 1.2, 2.0])
def test_the_lift_coefficient_is_proportional_to_mass(factor):
    """L = m g in level flight; the propeller, up to 3 deg above the path, carries up to 1 % of it."""
    own, other = trimmed(1.0), trimmed(factor)
    assert other["aero/qbar-psf"] == pytest.approx(own["aero/qbar-psf"], rel=1e-4)
    assert other["forces/fwz-aero-lbs"] / own["forces/fwz-aero-lbs"] == pytest.approx(factor, rel=0.01)


def test_the_angle_of_attack_rises_linearly_with_mass():
    """Where CL is linear in the angle of attack, by 2 W (f - 1) / (rho V^2 S CL_alpha): 1.2 deg for half the mass."""
    half, own, more, double = (trimmed(factor)["aero/alpha-deg"] for factor in (0.5, 1.0, 1.5, 2.0))
    assert own - half == pytest.approx(1.21, abs=0.02)
    assert more - own == pytest.approx(own - half, rel=0.02)
    assert double - more == pytest.approx(own - half, rel=0.02)


def test_a_heavier_aircraft_starts_in_equilibrium_and_turns_as_tightly():
    """Mass cancels in V^2 / (g tan(bank))."""
    aircraft = FixedWing(load_aircraft("c172x"))
    states = [aircraft.reset(START, V, Conditions(mass_factor=1.3), 0)]
    states += [aircraft.step(Command(0.0, V, 1000.0)) for _ in range(40)]
    assert all(state.airspeed == pytest.approx(V, abs=0.1) for state in states)
    assert all(state.z == pytest.approx(1000.0, abs=0.5) for state in states)
    turning = [aircraft.step(Command(1 / 800.0, V, 1000.0)) for _ in range(1600)][600:]
    bank, curvature = (fmean(values) for values in zip(*((s.channels[0], s.curvature) for s in turning), strict=True))
    assert math.degrees(bank) == pytest.approx(math.degrees(math.atan(V**2 / 9.8 / 800.0)), abs=1.0)
    assert curvature == pytest.approx(9.8 * math.tan(bank) / fmean(s.airspeed for s in turning) ** 2, rel=0.01)


@pytest.mark.parametrize("factor", [0.0, -1.0, math.nan, math.inf])
def test_what_is_no_mass_is_refused(factor):
    with pytest.raises(InputError, match=r"mass: .* choose a factor above 0"):
        FixedWing(load_aircraft("c172x")).reset(START, V, Conditions(mass_factor=factor), 0)


@pytest.mark.parametrize("factor", [3.0, 10.0])
def test_a_mass_that_does_not_fly_is_refused_with_its_kilograms(factor, capfd):
    kilograms = round(2480.0 * 0.45359237 * factor)
    with pytest.raises(InputError, match=rf"mass: JSBSim finds no equilibrium for {kilograms} kg at 55 m/s") as error:
        FixedWing(load_aircraft("c172x")).reset(START, V, Conditions(mass_factor=factor), 0)
    assert "\n" not in str(error.value)
    assert capfd.readouterr() == ("", "")


def test_a_model_whose_masses_are_elsewhere_keeps_them():
    model = ET.fromstring('<fdm_config><mass_balance file="elsewhere"/></fdm_config>')
    add_ballast(model)
    assert ET.tostring(model) == b'<fdm_config><mass_balance file="elsewhere" /></fdm_config>'
    stock = jsbsim.FGFDMExec(jsbsim.get_default_root_dir())
    stock.load_model("c172x")
    with pytest.raises(InputError, match="in another file"):
        scale_mass(stock, 1.2)
    scale_mass(stock, 1.0)
