"""Vector field: a course for every place, and a rate towards it."""

from __future__ import annotations

import math

from planners.path import Path, Projection
from planners.units import wrap
from sim.vehicle import Limits, State
from tracking.controllers.controller import delay

APPROACH = math.radians(60.0)  # course towards the path from far away


class VectorField:
    """Desired course chi_path - chi_inf (2 / pi) atan(k e), and its rate (Nelson et al. 2007, eq. 6 and 8).

    The field's slope on the path, chi_inf (2 / pi) k, is that of a time constant of 5 delays; the course follows with
    a time constant of 2.5 delays, linear in place of the paper's sliding mode.
    """

    name = "vector-field"

    def reset(self, limits: Limits, dt: float) -> None:
        """Set both time constants [s]."""
        self._delay = delay(limits, dt)
        self._approach_time = 5.0 * self._delay
        self._course_time = 2.5 * self._delay

    def curvature(self, state: State, path: Path, at: Projection) -> float:
        """Curvature [1/m] that turns the course into the field."""
        v = state.ground_speed
        scale = APPROACH * 2.0 / math.pi
        k = 1.0 / (scale * self._approach_time * v)
        bend = path.mean_curvature(at.s, at.s + 2.0 * self._delay * v)
        error = wrap(state.course - at.heading)
        desired = -scale * math.atan(k * at.cross_track)
        rate = -scale * k * v * math.sin(error) / (1.0 + (k * at.cross_track) ** 2)
        return bend + (rate + (desired - error) / self._course_time) / v
