"""Pure pursuit: an arc from the body heading through a point ahead on the path."""

from __future__ import annotations

import math

from planners.path import Path, Projection
from sim.vehicle import Limits, State
from tracking.controllers.controller import delay


def point_ahead(state: State, path: Path, at: Projection, reach: float) -> tuple[float, float]:
    """Vector [m] to the path's point at a distance of about `reach` [m].

    The point's arc length is exact on a straight path: the leg of the triangle of `reach` and the cross-track
    error. Far off the path it lies 1.5 times the error ahead, an approach at 34 deg: a steeper one overshoots when
    the vehicle's turn radius is much longer than `reach`, and can swing from side to side for ever.
    """
    error = abs(at.cross_track)
    along = max(math.sqrt(max(reach**2 - error**2, 0.0)), 1.5 * error)
    x, y = path.point_at(at.s + along)
    return x - state.x, y - state.y


class PurePursuit:
    """Curvature 2 sin(eta) / Ld, with eta from the body heading to the point at Ld (Coulter 1992, eq. in sec. 3).

    Ld is 4 times the distance covered during the delay.
    """

    name = "pure-pursuit"

    def reset(self, limits: Limits, dt: float) -> None:
        """Set the look-ahead time [s]."""
        self._lookahead = 4.0 * delay(limits, dt)

    def curvature(self, state: State, path: Path, at: Projection) -> float:
        """Curvature [1/m] of the arc through the point ahead."""
        dx, dy = point_ahead(state, path, at, self._lookahead * state.ground_speed)
        distance = math.hypot(dx, dy)
        eta = math.atan2(dy, dx) - state.heading
        return 2.0 * math.sin(eta) / distance
