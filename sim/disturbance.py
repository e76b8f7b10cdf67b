"""Turbulence and gusts on top of the steady wind, through JSBSim's model of winds (FGWinds)."""

from __future__ import annotations

import math
from collections.abc import Callable
from hashlib import blake2b

import jsbsim
import numpy as np

from planners.errors import InputError
from planners.units import METRES_PER_FOOT
from sim.dryden import dryden_gusts
from sim.jsbsim_model import property_node
from sim.wind import Dryden, Gust

TUSTIN_DRYDEN = 4  # JSBSim's turb-type ttTustin: Dryden's spectra as in Yeager 1998, NASA CR-1998-206937
# Wind at 20 ft [kt] by severity: 15, 30 and 45 kt are light, moderate and severe (MIL-F-8785C, low-altitude model), the
# others on straight lines between them. It sets the turbulence below 1000 ft, and its share up to 2000 ft.
WIND_AT_20_FT = (0.0, 5.0, 10.0, 15.0, 30.0, 37.5, 45.0, 52.5)
FEET_PER_SECOND_PER_KNOT = 1852.0 / 3600.0 / METRES_PER_FOOT
SEEDS = 2**31 - 2  # of JSBSim's generator, a multiplicative congruential one modulo 2^31 - 1


def start_turbulence(fdm: jsbsim.FGFDMExec, severity: float, seed: int) -> None:
    """Let Dryden turbulence of `severity` (MIL-F-8785C, figure 7, curves 1 to 7; 0 for none) grow from now on.

    Only after trim: before it, JSBSim's filters divide by a time step of 0 and stay not a number. They start at rest,
    and are at full strength after a few length scales (533 m above 2000 ft).
    """
    if severity not in range(len(WIND_AT_20_FT)):  # JSBSim would cut off a fraction without a word
        raise InputError(
            "turbulence",
            f"{severity:g} is not a severity",
            "choose a whole number from 0 (none) to 7; 3 is light, 4 moderate, 6 severe",
        )
    if not severity:
        return
    fdm["atmosphere/randomseed"] = jsbsim_seed(seed)
    # The axis of longitudinal turbulence: the wind's, north in calm, where trim leaves one made of rounding errors
    east, north = fdm["atmosphere/wind-east-fps"], fdm["atmosphere/wind-north-fps"]
    fdm["atmosphere/psiw-rad"] = math.atan2(east, north)
    fdm["atmosphere/turb-type"] = TUSTIN_DRYDEN
    fdm["atmosphere/turbulence/milspec/windspeed_at_20ft_AGL-fps"] = (
        WIND_AT_20_FT[int(severity)] * FEET_PER_SECOND_PER_KNOT
    )
    fdm["atmosphere/turbulence/milspec/severity"] = severity


def jsbsim_seed(seed: int) -> int:
    """A seed of JSBSim's for any `seed` of ours, scattered.

    JSBSim takes -2, -1, 0, 1 and 2^31 - 1 for the same, and flies s and 2^31 - 1 - s in mirrored weather.
    """
    return 1 + _scattered(seed) % SEEDS


def _scattered(seed: int) -> int:
    return int.from_bytes(blake2b(str(seed).encode(), digest_size=8).digest(), "big")


def gusts_of(
    fdm: jsbsim.FGFDMExec, gust: Gust | None, dryden: Dryden | None, airspeed: float, dt: float, seed: int
) -> Callable[[float], None] | None:
    """What makes `gust` and `dryden` blow as at a time [s] of the run, to be called before every step; None for none.

    Steps are `dt` [s] long; `seed` decides the turbulence, whose lengths pass at `airspeed` [m/s].
    """
    peaks = _peaks(gust)
    turbulence = dryden and dryden_gusts(dryden, airspeed, dt, np.random.default_rng(_scattered(seed)))
    if gust is None and turbulence is None:
        return None
    set_north, set_east, set_down = (
        property_node(fdm, f"atmosphere/gust-{axis}-fps").set_double_value for axis in ("north", "east", "down")
    )
    heading = property_node(fdm, "attitude/psi-rad").get_double_value

    def blow(t: float) -> None:
        share = gust.share(t) if gust else 0.0
        north, east, down = share * peaks[0], share * peaks[1], share * peaks[2]
        if turbulence:
            along, left, up = next(turbulence)
            psi = heading()
            north += (along * math.cos(psi) + left * math.sin(psi)) / METRES_PER_FOOT
            east += (along * math.sin(psi) - left * math.cos(psi)) / METRES_PER_FOOT
            down -= up / METRES_PER_FOOT
        set_north(north)
        set_east(east)
        set_down(down)

    return blow


def _peaks(gust: Gust | None) -> tuple[float, float, float]:
    """North, east and down [ft/s]; raises `InputError` for what is no gust."""
    if gust is None:
        return 0.0, 0.0, 0.0
    values = (gust.east, gust.north, gust.up, gust.start, gust.duration)
    if not all(map(math.isfinite, values)) or gust.duration <= 0.0 or gust.start < 0.0:
        raise InputError(
            "gust",
            f"{gust.duration:g} s from {gust.start:g} s, of ({gust.east:g}, {gust.north:g}, {gust.up:g}) m/s, is none",
            "give finite numbers, a duration above 0 s and a start at 0 s or later",
        )
    return gust.north / METRES_PER_FOOT, gust.east / METRES_PER_FOOT, -gust.up / METRES_PER_FOOT
