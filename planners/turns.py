"""The turn radius a path leaves to whoever follows it within a corridor."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from planners.kernel import Bools, Floats, Ints
from planners.path import Path
from planners.units import wrap_all


def available_radii(path: Path, corridor: float) -> tuple[Ints, Floats, Floats]:
    """Vertices (K,) of the path simplified to a tenth of `corridor` [m], their turns [rad] and available radii [m].

    Fly-by geometry: at a vertex with turn d and shorter adjoining leg l a vehicle may turn with at most
    min((l / 2) / tan(d / 2), corridor / (1 / cos(d / 2) - 1)): the arc's tangents fit into half a leg, and it cuts the
    corner by no more than the corridor. On a curve, where the path turns gradually at a vertex and the same way at a
    neighbouring one, l is the mean leg: simplifying a curve leaves legs of uneven length that no turn depends on.
    """
    kept = path.simplify(0.1 * corridor)
    xy = path.xy[kept]
    steps = np.diff(xy, axis=0)
    legs = np.hypot(steps[:, 0], steps[:, 1])
    headings = np.arctan2(steps[:, 1], steps[:, 0])
    turns = wrap_all(np.diff(headings))
    half = np.maximum(np.abs(turns), 1e-9) / 2
    before, after = legs[:-1], legs[1:]
    leg = np.where(_on_curve(path, kept, turns), (before + after) / 2, np.minimum(before, after))
    with np.errstate(divide="ignore"):
        # tan and 1 / cos grow without bound as the turn approaches a reversal, which leaves no radius at all
        by_legs = (leg / 2) / np.tan(half)
        by_corridor = corridor / (1.0 / np.cos(half) - 1.0)
    return kept[1:-1], turns, np.maximum(np.minimum(by_legs, by_corridor), 0.0)


def _on_curve(path: Path, kept: Ints, turns: Floats) -> Bools:
    """Whether each vertex is part of a curve, not a corner with its point cut off.

    It is when no single point between the middles of the adjoining legs takes 0.9 of its turn, and a neighbouring
    vertex is like it and turns to the same side.
    """
    middles = (path.s[kept[:-1]] + path.s[kept[1:]]) / 2
    bounds = np.searchsorted(path.s, middles)
    sharpest = np.array([np.abs(path.turns[a:b]).max(initial=0.0) for a, b in pairwise(bounds)])
    gradual = sharpest < 0.9 * np.abs(turns)
    alike = gradual[1:] & gradual[:-1] & (turns[1:] * turns[:-1] > 0.0)
    return np.asarray(np.concatenate([alike, [False]]) | np.concatenate([[False], alike]))
