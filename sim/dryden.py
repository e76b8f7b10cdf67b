"""Dryden turbulence of any strength and length, as a series of gusts: what JSBSim's own cannot give off the Earth."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from planners.errors import InputError
from sim.wind import Dryden

BLOCK = 4096  # steps whose random numbers are drawn at once


def dryden_gusts(
    turbulence: Dryden, airspeed: float, dt: float, rng: np.random.Generator
) -> Iterator[tuple[float, float, float]]:
    """Gusts (along, across, up) [m/s] every `dt` [s] of a flight at `airspeed` [m/s], from calm on, without end.

    MIL-F-8785C, 3.7.1.2, with one length L for all axes: white noise through sigma sqrt(2 L / (pi V)) / (1 + s L / V)
    along, sigma sqrt(L / (pi V)) (1 + sqrt(3) s L / V) / (1 + s L / V)^2 across and up. Discretised exactly, as
    stationary Gauss-Markov processes (Van Loan 1978): any `dt` gives the same statistics. They start at rest, so that
    a flight starts in equilibrium, and are at full strength after a few lengths. Raises `InputError` for what is none.
    """
    sigma, length = turbulence.sigmas, turbulence.length
    if not (all(0.0 <= s < math.inf for s in sigma) and 0.0 < length < math.inf):
        raise InputError(
            "dryden",
            f"{sigma} m/s over {length:g} m is no turbulence",
            "give finite numbers, sigma from 0 and a length above 0",
        )
    return _gusts(sigma, dt * airspeed / length, rng)


def _gusts(
    sigma: tuple[float, float, float], step: float, rng: np.random.Generator
) -> Iterator[tuple[float, float, float]]:
    """`step` is the time step over L / V.

    Across and up are x + sqrt(3) x' of x'' + 2 x' + x = white noise, whose stationary covariance is I / 4.
    """
    decay = math.exp(-step)
    kick = math.sqrt(-math.expm1(-2.0 * step))
    transition = decay * np.array([[1.0 + step, step], [-step, 1.0 - step]])
    (a, b), (c, d) = transition.tolist()
    (k, _), (m, n) = np.linalg.cholesky(0.25 * (np.eye(2) - transition @ transition.T)).tolist()
    root = math.sqrt(3.0)
    along = across = across_rate = up = up_rate = 0.0
    while True:
        for noise, p, q, r, s in rng.standard_normal((BLOCK, 5)).tolist():
            along = decay * along + kick * noise
            across, across_rate = a * across + b * across_rate + k * p, c * across + d * across_rate + m * p + n * q
            up, up_rate = a * up + b * up_rate + k * r, c * up + d * up_rate + m * r + n * s
            yield sigma[0] * along, sigma[1] * (across + root * across_rate), sigma[2] * (up + root * up_rate)
