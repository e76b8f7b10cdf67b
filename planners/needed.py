"""What a path itself needs of a ground vehicle, whoever steers: curvature and lateral acceleration along it."""

from __future__ import annotations

import numpy as np

from planners.astar.heading_limits import STEP_TIME
from planners.kernel import Floats
from planners.path import Path


def curvature_needed(path: Path, distance: float) -> tuple[Floats, Floats]:
    """Arc lengths (N,) [m], and the mean curvature (N,) [1/m, left positive] of `path` over `distance` [m] about each.

    A polyline has no curvature: its corners' are infinite, its legs' zero. So the turn at a vertex is spread over the
    adjoining halves of its legs, as by the arc through them, but over no more than `distance`; and what remains is the
    change of this heading from half of `distance` before to half of it after, over `distance`. On chords of a circle
    that is the circle's curvature, at a corner d alone between long legs at most d / `distance`. Uneven steps shorter
    than `distance` tell of no more than even ones, as the change of the bare headings would. Before the start and past
    the end the outer legs go on. The curvature is linear between the arc lengths, so its extremes are among them.
    """
    half = distance / 2
    reach = np.minimum(np.diff(path.s) / 2, half)
    after, before = path.s[:-1] + reach, path.s[1:] - reach
    knots = np.column_stack([after, np.maximum(after, before)]).ravel()
    headings = np.repeat(path.headings, 2)
    places = np.clip(np.concatenate([knots - half, knots + half]), 0.0, path.length)
    s = np.unique(np.concatenate([[0.0, path.length], places]))
    return s, (np.interp(s + half, knots, headings) - np.interp(s - half, knots, headings)) / distance


def lateral_acceleration_needed(path: Path, speed: float) -> tuple[Floats, Floats]:
    """Arc lengths (N,) [m], and the lateral acceleration (N,) [m/s^2, left positive] needed there at `speed` [m/s].

    v^2 times the mean curvature over one steering action, the way of `STEP_TIME` (paper 004, section 2.2: 0.5 s). A
    path that turns by d at every step of v * `STEP_TIME` needs v d / `STEP_TIME` all along.
    """
    s, curvature = curvature_needed(path, speed * STEP_TIME)
    return s, speed**2 * curvature
