"""LQR on cross-track and course error, with path-curvature feed-forward."""

from __future__ import annotations

import math

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from planners.path import Path, Projection
from planners.units import wrap
from sim.vehicle import Limits, State
from tracking.controllers.controller import delay

APPROACH = math.radians(60.0)  # course towards the path from far away


class Lqr:
    """Discrete LQR on (e / v, course error, turn-rate error), turn rate lagging its command by the response time.

    With time as the unit the model does not depend on speed: (e/v)' = chi, chi' = w, w' = (u - w) / tau; one gain,
    u = w_path - K x, serves all speeds. The weight on e makes the loop's natural frequency 1 / (3 delays) [rad/s].
    (Anderson and Moore 1990, ch. 2; feed-forward from one response ahead.)
    """

    name = "lqr"

    def reset(self, limits: Limits, dt: float) -> None:
        """Solve the Riccati equation for this vehicle's lag and guidance period."""
        tau = limits.response_time
        self._preview = delay(limits, dt)
        a = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0 / tau]])
        b = np.array([[0.0], [0.0], [1.0 / tau]])
        both = expm(np.block([[a, b], [np.zeros((1, 4))]]) * dt)
        phi, gamma = both[:3, :3], both[:3, 3:]
        weight = np.diag([(1.0 / (3.0 * self._preview)) ** 4, 0.0, 0.0])
        s = solve_discrete_are(phi, gamma, weight, np.eye(1))
        gain = np.linalg.solve(np.eye(1) + gamma.T @ s @ gamma, gamma.T @ s @ phi)[0]
        self._k_e, self._k_course, self._k_rate = (float(k) for k in gain)
        self._e_most = self._k_course * APPROACH / self._k_e

    def curvature(self, state: State, path: Path, at: Projection) -> float:
        """Curvature [1/m]."""
        v = state.ground_speed
        reach = self._preview * v
        near = path.heading_at(at.s + 0.5 * reach)
        here = (near - path.heading_at(at.s - 0.5 * reach)) / reach
        ahead = (path.heading_at(at.s + 1.5 * reach) - near) / reach
        offset = max(-self._e_most, min(self._e_most, at.cross_track / v))
        course = wrap(state.course - at.heading)
        rate = v * (state.curvature - here)
        return ahead - (self._k_e * offset + self._k_course * course + self._k_rate * rate) / v
