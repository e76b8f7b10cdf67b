"""Stanley: steer a front point parallel to the path and onto it."""

from __future__ import annotations

import math

from planners.path import Path, Projection
from planners.units import wrap
from sim.vehicle import Limits, State
from tracking.controllers.controller import delay


class Stanley:
    """Steering psi + atan(k e / v) of the front axle (Thrun et al. 2006, eq. 5), as a curvature tan(steering) / L.

    L is the vehicle's equivalent length. The front point follows the line that it draws when the reference point
    follows the path, P + L T with heading psi_path + atan(L kappa): otherwise the rear axle would cut every curve.
    Heading is the course, since an aircraft's crab is not an error.
    """

    name = "stanley"

    def reset(self, limits: Limits, dt: float) -> None:
        """Set the gain [1/s] from the delay."""
        self._length = limits.equivalent_length
        self._delay = delay(limits, dt)
        self._gain = 1.0 / (4.0 * self._delay)

    def curvature(self, state: State, path: Path, at: Projection) -> float:
        """Curvature [1/m] at the commanded steering."""
        v, length = state.ground_speed, self._length
        bend = path.mean_curvature(at.s, at.s + 2.0 * self._delay * v)
        error = wrap(state.course - at.heading)
        front = at.cross_track + length * math.sin(error)
        steering = math.atan(length * bend) - error - math.atan(self._gain * front / v)
        return math.tan(max(-1.2, min(1.2, steering))) / length
