"""A path as a driver would have it: bounded in curvature and in its change, and clear of the obstacles."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline

from planners.astar.linearised import Bounds, best_shifts, linearised
from planners.astar.room import Body, Room
from planners.astar.smooth_kernels import BAND
from planners.kernel import Floats

ROUNDS = 20  # of linearising and solving; 4 to 8 are common
CLOSE_ENOUGH = 0.01  # [m] a round that gains no more than this is the last
TRUST = 4.0  # [distances of points] no point moves farther in a round
UNEQUAL = 1.5  # longest over shortest leg
LAST_TRUST = 1e-3  # [m]


def smoothed(points: Floats, spacing: float, room: Room, body: Body, bounds: Bounds) -> Floats | None:
    """The shortest path near `points` (N, 2) [m] that keeps the `bounds`, as points (M, 2) about `spacing` [m] apart.

    None where a bound on curvature or its change cannot be kept. The margin gives way where there is less room, and
    the body's place with it if need be: who asks must look.

    Sequential quadratic programming with elastic bounds in a trust region (Nocedal and Wright 2006, ch. 18), the
    quadratic programs by PIQP (Schwan et al. 2023). Every point moves along its normal; where that leaves legs too
    unequal, they are spaced evenly on a cubic spline through them.
    """
    widest = TRUST * spacing
    now, trust = linearised(_even(points, spacing), room, body, bounds, widest), widest
    for _ in range(ROUNDS):
        shifts = best_shifts(now, trust)
        moved = float(np.abs(shifts).max())
        moved_points = now.points + shifts[:, None] * now.left
        legs = np.hypot(*np.diff(moved_points, axis=0).T)
        if legs.max() > UNEQUAL * legs.min():
            moved_points = _even(moved_points, spacing)
        then = linearised(moved_points, room, body, bounds, widest)
        gain = now.merit - then.merit
        if gain < 0.0:
            trust = 0.3 * min(trust, moved)
        else:
            now, trust = then, trust if moved < 0.9 * trust else min(2.0 * trust, widest)
        if min(trust, moved) < LAST_TRUST or (now.kept and abs(gain) < CLOSE_ENOUGH):
            break
    return now.points if now.kept else None


def _even(points: Floats, spacing: float) -> Floats:
    """As many points (M, 2) at equal distances on a cubic spline through `points`."""
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    return np.asarray(CubicSpline(s, points)(np.linspace(0.0, s[-1], max(round(s[-1] / spacing), BAND) + 1)))
