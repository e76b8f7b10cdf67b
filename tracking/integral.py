"""The one integral term: it removes the steady bias that wind, slip and torque leave any controller."""

from __future__ import annotations

from sim.vehicle import Limits
from tracking.controllers.controller import delay


class Integral:
    """Integral of the cross-track error as a curvature [1/m].

    Its gain is a fraction of the stability bound of the slowest controller, so that it may be added to each. Anti-
    windup: the error counts up to the corridor only, the term stays within the vehicle's own curvature, and it
    stands still while the vehicle is saturated.
    """

    def __init__(self, limits: Limits, corridor: float, dt: float) -> None:
        self._gain = 0.08 / (3.0 * delay(limits, dt)) ** 3
        self._limits, self._corridor, self._dt = limits, corridor, dt
        self._sum = 0.0  # of e dt / v [s^2]

    def curvature(self, cross_track: float, ground_speed: float, saturated: bool) -> float:
        """The curvature [1/m] to add to the controller's."""
        if not saturated:
            e = max(-self._corridor, min(self._corridor, cross_track))
            self._sum += e / ground_speed * self._dt
            most = 1.0 / self._limits.turn_radius(ground_speed) * ground_speed / self._gain
            self._sum = max(-most, min(most, self._sum))
        return -self._gain * self._sum / ground_speed
