"""JSBSim as a quiet library: a loaded model in equilibrium, and errors as exceptions."""

from __future__ import annotations

import atexit
import math
import shutil
import tempfile
import xml.etree.ElementTree as ET
from functools import lru_cache
from pathlib import Path

import jsbsim

from planners.errors import InputError, TrackworthyError
from planners.typed_toml import suggestion
from planners.units import METRES_PER_FOOT
from sim.aircraft_file import Aircraft
from sim.ballast import add_ballast
from sim.jsbsim_log import listening
from sim.planet import Planet
from sim.planet_air import add_mach, load_planet
from sim.vehicle import Pose
from sim.wind import Wind, ground_speed_on_course, heading_for_course

ATTITUDE_HOLD = Path(__file__).parent / "attitude_hold.xml"
# Shares of the wind to trim in. JSBSim's trim takes the wind with the wrong sign, which does not matter unless it then
# seems to come exactly from the side: a wind 2 % off will do, and the real one follows with a step below 1 m/s.
WIND_TRIED = (1.0, 0.98, 1.02)
KILOGRAMS_PER_POUND = 0.45359237
FULL_TRIM = 1  # JSBSim's TrimMode.FULL: forces and moments about all axes


class NoEquilibriumError(InputError):
    """The aircraft cannot hold that speed, altitude and mass in level flight."""


def load_model(aircraft: Aircraft, dt: float, planet: Planet | None = None) -> jsbsim.FGFDMExec:
    """Load the JSBSim model of `aircraft` on `planet`, None at home, with our attitude loops, stepping by `dt` [s]."""
    model = aircraft.model
    folder = Path(aircraft.root or jsbsim.get_default_root_dir())
    file = folder / "aircraft" / model / f"{model}.xml"
    if not model or not file.is_file():
        known = sorted(path.parent.name for path in folder.glob("aircraft/*/*.xml") if path.stem == path.parent.name)
        raise InputError(
            "aircraft",
            f"JSBSim has no model {model!r} in {folder / 'aircraft'}",
            suggestion(model, known) if known else "it has none at all",
        )
    own = aircraft.own_autopilot
    planet = planet or aircraft.home
    with listening() as listener:
        fdm = jsbsim.FGFDMExec(str(folder))
        fdm.set_debug_level(0)
        fdm.set_aircraft_path(str(_with_attitude_hold(file, own.systems, own.outputs, planet)))
        load_planet(fdm, planet)
        try:
            loaded, reason = fdm.load_model(model), ""
        except jsbsim.BaseError as error:
            loaded, reason = False, str(error)
    if not loaded:
        why = " ".join(f"{listener.errors()} {reason}".split())
        raise InputError(str(file), f"JSBSim cannot load it ({why})", "mend the model")
    fdm.set_dt(dt)
    fdm.disable_output()
    return fdm


@lru_cache
def _with_attitude_hold(file: Path, replaced: tuple[str, ...], outputs: tuple[str, ...], planet: Planet) -> Path:
    """An aircraft folder, for this process, whose aircraft, that of `file`, has our loops, ballast and Mach number.

    The systems `replaced`, the model's own autopilot, are left out; `outputs` are the properties that the flight
    controls read from them, which stay 0 as they are when it is switched off.
    """
    try:
        model = ET.parse(file)
    except ET.ParseError as error:
        raise InputError(str(file), f"is not XML ({error})") from error
    root = model.getroot()
    for element in [*root.findall("system"), *root.findall("autopilot")]:
        if element.get("file") in replaced:
            root.remove(element)
    for element in [*root.findall("output"), *root.findall("input")]:
        root.remove(element)  # it would write beside JSBSim's own data, or listen on a port
    off = ET.SubElement(root, "system", name="own autopilot, off")
    for name in outputs:
        ET.SubElement(off, "property", value="0").text = name
    ET.SubElement(root, "system", file=ATTITUDE_HOLD.stem)
    add_ballast(root)
    add_mach(root, planet)

    folder = Path(tempfile.mkdtemp(prefix="trackworthy-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    aircraft = folder / file.stem
    shutil.copytree(file.parent, aircraft)
    (aircraft / "Systems").mkdir(exist_ok=True)
    shutil.copy(ATTITUDE_HOLD, aircraft / "Systems")
    model.write(aircraft / file.name)
    return folder


def property_node(fdm: jsbsim.FGFDMExec, name: str) -> jsbsim.FGPropertyNode:
    """The property of that name, far faster than `fdm[name]` when it is used often."""
    node = fdm.get_property_manager().get_node(name)
    if node is None:
        raise TrackworthyError(f"this JSBSim model has no property {name}")
    return node


def start_in_equilibrium(
    fdm: jsbsim.FGFDMExec, pose: Pose, lat: float, lon: float, airspeed: float, wind: Wind
) -> None:
    """Trim wings level on the course of `pose` at `airspeed` [m/s] in `wind`, at `lat`, `lon` [deg], engines running.

    Order matters to JSBSim: attitude and airspeed, then the wind, then the inertial velocity, which is the air velocity
    plus the wind. Raises `InputError` if the wind is too strong or the aircraft cannot hold that speed.
    """
    heading = heading_for_course(airspeed, pose.course, wind)
    if math.isnan(heading):
        raise InputError("wind", f"{wind.speed:.4g} m/s of wind cannot be held at an airspeed of {airspeed:.4g} m/s")
    if ground_speed_on_course(airspeed, pose.course, wind) <= 0.0:
        raise InputError("wind", f"against {wind.speed:.4g} m/s of wind, {airspeed:.4g} m/s of airspeed gain no way")
    for share in WIND_TRIED:
        with listening() as listener:
            _initialise(fdm, pose.z, lat, lon, airspeed, heading, Wind(share * wind.east, share * wind.north))
            if _trimmed(fdm):
                fdm["atmosphere/wind-north-fps"] = wind.north / METRES_PER_FOOT
                fdm["atmosphere/wind-east-fps"] = wind.east / METRES_PER_FOOT
                return
    kilograms = KILOGRAMS_PER_POUND * fdm["inertia/weight-lbs"]
    said = f" ({listener.errors()})" if listener.errors() else ""
    raise NoEquilibriumError(
        "speed, altitude or mass",
        f"JSBSim finds no equilibrium for {kilograms:.0f} kg at {airspeed:.4g} m/s and {pose.z:.0f} m{said}",
        "choose others",
    )


def release_level(fdm: jsbsim.FGFDMExec, pose: Pose, lat: float, lon: float, airspeed: float, wind: Wind) -> None:
    """Let go of what has no equilibrium: level on the course of `pose` at `airspeed` [m/s], throttle full."""
    heading = heading_for_course(airspeed, pose.course, wind)
    with listening():
        _initialise(fdm, pose.z, lat, lon, airspeed, heading, wind)
    fdm["atmosphere/wind-north-fps"] = wind.north / METRES_PER_FOOT
    fdm["atmosphere/wind-east-fps"] = wind.east / METRES_PER_FOOT
    for engine in range(fdm.get_propulsion().get_num_engines()):
        fdm[f"fcs/throttle-cmd-norm[{engine}]"] = 1.0


def _initialise(
    fdm: jsbsim.FGFDMExec, height: float, lat: float, lon: float, airspeed: float, heading: float, wind: Wind
) -> None:
    """Put the aircraft into the air, level, engines running."""
    vt = airspeed / METRES_PER_FOOT
    settings = {
        "ic/lat-geod-deg": lat,
        "ic/long-gc-deg": lon,
        "ic/h-sl-ft": height / METRES_PER_FOOT,
        "ic/psi-true-deg": 90.0 - math.degrees(heading),
        "ic/vt-fps": vt,
        "ic/alpha-deg": 0.0,
        "ic/vw-mag-fps": wind.speed / METRES_PER_FOOT,
        "ic/vw-dir-deg": (wind.from_deg + 180.0) % 360.0,  # JSBSim wants where it blows to
        "ic/vn-fps": vt * math.sin(heading) + wind.north / METRES_PER_FOOT,
        "ic/ve-fps": vt * math.cos(heading) + wind.east / METRES_PER_FOOT,
        "ic/vd-fps": 0.0,
    }
    for name, value in settings.items():
        fdm[name] = value
    fdm.run_ic()
    fdm["propulsion/set-running"] = -1


def _trimmed(fdm: jsbsim.FGFDMExec) -> bool:
    """Whether JSBSim found an equilibrium from where it is."""
    try:
        fdm["simulation/do_simple_trim"] = FULL_TRIM
    except jsbsim.TrimFailureError:
        return False
    except jsbsim.BaseError as error:
        raise TrackworthyError(f"JSBSim failed to trim: {' '.join(str(error).split())}") from error
    return True
