"""The airspeed that speed control needs: free of turbulence, and yet without delay."""

from __future__ import annotations

import math

import jsbsim

from planners.units import METRES_PER_FOOT
from sim.jsbsim_model import property_node


class LastingWind:
    """The wind of about the past `time` [s], a first-order low pass that every call moves on by `period` [s].

    The airspeed in it is a complementary filter: inertial velocity when fast, air data when slow (as speed is filtered
    in ArduPilot's AP_TECS). A lull that passes leaves it alone; what drag, a climb or a turn take shows at once. In a
    steady wind it is the airspeed, in turns too.
    """

    def __init__(self, fdm: jsbsim.FGFDMExec, time: float, period: float) -> None:
        self._share = 1.0 - math.exp(-period / time)
        names = ("atmosphere/total-wind-{}-fps", "velocities/v-{}-fps")
        self._wind_now, self._velocity = (
            [property_node(fdm, name.format(axis)).get_double_value for axis in ("north", "east", "down")]
            for name in names
        )
        self._wind = [fdm[f"atmosphere/wind-{axis}-fps"] for axis in ("north", "east", "down")]

    def airspeed(self) -> float:
        """True airspeed [m/s] in the lasting wind, one period on."""
        self._wind = [
            lasting + self._share * (now() - lasting) for lasting, now in zip(self._wind, self._wind_now, strict=True)
        ]
        return METRES_PER_FOOT * math.dist([v() for v in self._velocity], self._wind)
