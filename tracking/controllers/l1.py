"""L1 guidance: an arc from the course through a point ahead on the path."""

from __future__ import annotations

import math

from planners.path import Path, Projection
from planners.units import wrap
from sim.vehicle import Limits, State
from tracking.controllers.controller import delay
from tracking.controllers.pure_pursuit import point_ahead

DAMPING = 0.75


class L1:
    """Curvature 2 sin(eta) / L1, with eta from the course (Park, Deyst and How 2004, eq. 1).

    L1 = damping x period / pi x ground speed; the period is 16 times the delay.
    """

    name = "l1"

    def reset(self, limits: Limits, dt: float) -> None:
        """Set the look-ahead time [s] from period and damping."""
        self._lookahead = DAMPING * 16.0 * delay(limits, dt) / math.pi

    def curvature(self, state: State, path: Path, at: Projection) -> float:
        """Curvature [1/m]; beyond 90 deg off the point ahead, the full turn towards it."""
        reach = self._lookahead * state.ground_speed
        dx, dy = point_ahead(state, path, at, reach)
        eta = wrap(math.atan2(dy, dx) - state.course)
        return 2.0 * math.sin(max(-math.pi / 2, min(math.pi / 2, eta))) / reach
