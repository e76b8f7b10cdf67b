"""Polylines made followable: safe cubic Hermite pieces around corners, of a radius that is stated."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from planners.ground import Ground
from planners.kernel import Floats
from planners.rounding.corner_kernels import least_radius, piece, turn_at
from planners.rounding.relax_kernels import relax
from planners.rounding.restructure import restructured
from planners.segments import without_needless

WEIGHT = 2.0  # cells of length that a cell of radius is worth, where radius is lacking
PRICELESS = 1e6
TAUT_ROUNDS = 3
COARSEST, MIDDLE, FINEST = 8.0, 1.0, 0.1  # steps of the search, in cells
RESERVE = 1.001  # of the radius, since the search ends in steps


@dataclass(frozen=True, slots=True, eq=False)
class Tight:
    """A corner at (`x`, `y`) [m] whose `radius` [m] is below the one wanted, since obstacles or legs leave no more."""

    x: float
    y: float
    radius: float


@dataclass(frozen=True, slots=True, eq=False)
class Rounded:
    """A line `points` (N, 2) [m] with rounded corners.

    `smallest_radius` [m] is that of its tightest curve, inf for a straight line; `tight` holds the corners below the
    radius wanted.
    """

    points: Floats
    smallest_radius: float
    tight: tuple[Tight, ...]


def taut(ground: Ground, polyline: Floats) -> Floats:
    """A free `polyline` (N, 2) [cells] pulled taut: its vertices moved until no step of the search shortens it.

    Each round adds vertices on the legs, so that the line can bend where it only passed by, and leaves out those that
    are not needed.
    """
    nodes = polyline
    for _ in range(TAUT_ROUNDS):
        nodes = _divided(nodes)
        relax(ground.blocked, nodes, np.zeros(len(nodes)), 0.0, 0.0, 0, len(nodes), COARSEST, FINEST)
        for _ in range(2):
            nodes = without_needless(ground.blocked, nodes, 2)
    return nodes


def _divided(nodes: Floats) -> Floats:
    """With two more vertices on each leg that is longer than the coarsest step."""
    pieces = [nodes[:1]]
    for a, b in pairwise(nodes):
        if np.hypot(*(b - a)) > COARSEST:
            pieces += [(a + (b - a) / 3.0)[None], (a + (b - a) / 1.5)[None]]
        pieces.append(b[None])
    return np.concatenate(pieces)


def rounded(ground: Ground, polyline: Floats, radius: float, keep: bool = False) -> Rounded:
    """Round the corners of a free `polyline` (N, 2) [cells] with at least `radius` [m] wherever that is possible.

    Vertices move, merge and vanish so that the line becomes short and its curves wide; it never leaves the free cells.
    A corner keeps less than `radius` only where no step of the search finds room for more. With `keep`, all corners of
    `polyline` have room for it as they are, and none gives it up.
    """
    blocked, wanted = ground.blocked, RESERVE * radius / ground.cell
    nodes, radii = polyline.copy(), np.zeros(len(polyline))
    weight = PRICELESS if keep else WEIGHT
    if keep:
        for i in range(1, len(nodes) - 1):
            radii[i] = wanted / least_radius(turn_at(nodes, i))
    if len(nodes) > 2:
        relax(blocked, nodes, radii, wanted, weight, 0, len(nodes), COARSEST, MIDDLE / 2.0)
        nodes, radii = restructured(blocked, nodes, radii, wanted, weight, COARSEST)
        relax(blocked, nodes, radii, wanted, weight, 0, len(nodes), MIDDLE, FINEST)
    curves = [radii[i] * least_radius(turn_at(nodes, i)) * ground.cell for i in range(1, len(nodes) - 1)]
    vertices = ground.to_metres(nodes)
    tight = tuple(
        Tight(float(x), float(y), float(curve))
        for (x, y), curve in zip(vertices[1:-1], curves, strict=True)
        if curve < radius
    )
    return Rounded(ground.to_metres(_line(nodes, radii)), float(min(curves, default=np.inf)), tight)


def _line(nodes: Floats, radii: Floats) -> Floats:
    """Points (K, 2) of the line, its corners rounded."""
    inner = range(1, len(nodes) - 1)
    pieces = [piece(nodes, radii[i], i) if radii[i] > 0.0 else nodes[i : i + 1] for i in inner]
    return np.concatenate([nodes[:1], *pieces, nodes[-1:]])
