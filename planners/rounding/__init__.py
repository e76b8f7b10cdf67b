"""Polylines made followable: safe cubic Hermite pieces around corners, of a radius that is stated."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planners.ground import Ground
from planners.kernel import Floats
from planners.rounding.corner_kernels import least_radius, rounded_line, turn_at
from planners.rounding.relax_kernels import relax, restructure

WEIGHT = 2.0  # cells of length that a cell of radius is worth, where radius is lacking
PRICELESS = 1e6
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
    """A rounded line `points` (N, 2) [m] about the `polyline` (M, 2) [m] of its vertices.

    `smallest_radius` [m] is that of its tightest curve, inf for a straight line; `tight` holds the corners below the
    radius wanted.
    """

    points: Floats
    polyline: Floats
    smallest_radius: float
    tight: tuple[Tight, ...]


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
        nodes, radii = restructure(blocked, nodes, radii, wanted, weight, COARSEST)
        relax(blocked, nodes, radii, wanted, weight, 0, len(nodes), MIDDLE, FINEST)
    curves = [radii[i] * least_radius(turn_at(nodes, i)) * ground.cell for i in range(1, len(nodes) - 1)]
    vertices = ground.to_metres(nodes)
    tight = tuple(
        Tight(float(x), float(y), float(curve))
        for (x, y), curve in zip(vertices[1:-1], curves, strict=True)
        if curve < radius
    )
    return Rounded(ground.to_metres(rounded_line(nodes, radii)), vertices, min(curves, default=np.inf), tight)
