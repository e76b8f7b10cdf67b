"""Kernels of a polyline whose corners are rounded by cubic Hermite pieces, over a grid; in units of cells.

Corner i has the turn d between its legs and a radius r. Its piece begins r tan(d / 2) before the vertex and ends as
far behind it; with tangents of 4 r tan(d / 4) a cubic Hermite is the usual approximation of the arc of radius r.
"""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, kernel
from planners.segments import is_free

SPACING = 0.5  # cells between the points of a piece
SHARPEST = math.radians(150.0)  # beyond it a piece is no arc any more


@kernel
def turn_at(nodes: Floats, i: int) -> float:
    """The turn [rad] at inner vertex `i`, left positive."""
    ax, ay = nodes[i, 0] - nodes[i - 1, 0], nodes[i, 1] - nodes[i - 1, 1]
    bx, by = nodes[i + 1, 0] - nodes[i, 0], nodes[i + 1, 1] - nodes[i, 1]
    return math.atan2(ax * by - ay * bx, ax * bx + ay * by)


@kernel
def tangent_length(nodes: Floats, radii: Floats, i: int) -> float:
    """How far before and behind vertex `i` its piece begins and ends; 0 at the ends."""
    if i <= 0 or i >= len(nodes) - 1 or radii[i] == 0.0:
        return 0.0
    turn = abs(turn_at(nodes, i))
    if turn > SHARPEST:
        return math.inf
    return float(radii[i] * math.tan(turn / 2.0))


def _least_radii() -> Floats:
    """The smallest radius of curvature of the piece with r = 1, for turns up to `SHARPEST` in equal steps."""
    turn = np.linspace(1e-4, SHARPEST, STEPS + 1)[:, None]
    u = np.linspace(0.0, 1.0, 101)
    t, m, c, s = np.tan(turn / 2.0), 4.0 * np.tan(turn / 4.0), np.cos(turn), np.sin(turn)
    # Derivatives of the Hermite basis, the start in the origin: h10, h01, h11
    first = 3.0 * u * u - 4.0 * u + 1.0, 6.0 * u - 6.0 * u * u, 3.0 * u * u - 2.0 * u
    second = 6.0 * u - 4.0, 6.0 - 12.0 * u, 6.0 * u - 2.0
    (dx, dy), (ddx, ddy) = (
        (h10 * m + h01 * t * (1.0 + c) + h11 * m * c, h01 * t * s + h11 * m * s) for h10, h01, h11 in (first, second)
    )
    return np.asarray(((dx * dx + dy * dy) ** 1.5 / np.abs(dx * ddy - dy * ddx)).min(axis=1))


STEPS = 600
LEAST_RADII = _least_radii()


@kernel
def least_radius(turn: float) -> float:
    """The smallest radius of curvature of the piece for `turn` [rad] with r = 1; it shrinks as the turn grows."""
    at = abs(turn) / SHARPEST * STEPS
    i = min(int(at), STEPS - 1)
    return float(LEAST_RADII[i] + (at - i) * (LEAST_RADII[i + 1] - LEAST_RADII[i]))


@kernel
def piece(nodes: Floats, radius: float, i: int) -> Floats:
    """Points (K, 2) of the piece around vertex `i`, both ends included, at most `SPACING` apart."""
    turn = turn_at(nodes, i)
    t, m = radius * math.tan(abs(turn) / 2.0), 4.0 * radius * math.tan(abs(turn) / 4.0)
    x, y = nodes[i, 0], nodes[i, 1]
    before = math.hypot(x - nodes[i - 1, 0], y - nodes[i - 1, 1])
    after = math.hypot(nodes[i + 1, 0] - x, nodes[i + 1, 1] - y)
    ux, uy = (x - nodes[i - 1, 0]) / before, (y - nodes[i - 1, 1]) / before
    vx, vy = (nodes[i + 1, 0] - x) / after, (nodes[i + 1, 1] - y) / after
    count = max(2, math.ceil(radius * abs(turn) / SPACING) + 1)
    points = np.empty((count, 2))
    for k in range(count):
        u = k / (count - 1)
        h00, h10 = (1.0 + 2.0 * u) * (1.0 - u) ** 2, u * (1.0 - u) ** 2
        h01, h11 = u * u * (3.0 - 2.0 * u), u * u * (u - 1.0)
        points[k, 0] = h00 * (x - t * ux) + h10 * m * ux + h01 * (x + t * vx) + h11 * m * vx
        points[k, 1] = h00 * (y - t * uy) + h10 * m * uy + h01 * (y + t * vy) + h11 * m * vy
    return points


@kernel
def is_corner_free(blocked: Bools, nodes: Floats, radius: float, i: int) -> bool:
    """Whether the piece around vertex `i` meets no blocked cell."""
    points = piece(nodes, radius, i)
    for k in range(1, len(points)):
        if not is_free(blocked, points[k - 1, 0], points[k - 1, 1], points[k, 0], points[k, 1]):
            return False
    return True


@kernel
def is_leg_free(blocked: Bools, nodes: Floats, radii: Floats, i: int) -> bool:
    """Whether leg `i`, from vertex i to i + 1, has room for the pieces at its ends and is free between them."""
    dx, dy = nodes[i + 1, 0] - nodes[i, 0], nodes[i + 1, 1] - nodes[i, 1]
    length = math.hypot(dx, dy)
    if length < 1e-9:
        return False
    a, b = tangent_length(nodes, radii, i) / length, tangent_length(nodes, radii, i + 1) / length
    if a + b > 1.0:
        return False
    x, y = nodes[i, 0], nodes[i, 1]
    return is_free(blocked, x + a * dx, y + a * dy, x + (1.0 - b) * dx, y + (1.0 - b) * dy)


@kernel
def is_window_free(blocked: Bools, nodes: Floats, radii: Floats, i: int) -> bool:
    """Whether all that depends on vertex `i` is free and fits."""
    n = len(nodes)
    for leg in range(max(i - 2, 0), min(i + 2, n - 1)):
        if not is_leg_free(blocked, nodes, radii, leg):
            return False
    for corner in range(max(i - 1, 1), min(i + 2, n - 1)):
        if radii[corner] > 0.0 and not is_corner_free(blocked, nodes, radii[corner], corner):
            return False
    return True


@kernel
def window_cost(nodes: Floats, radii: Floats, wanted: float, weight: float, i: int) -> float:
    """What depends on vertex `i` of the length of the rounded line, and `weight` times what radii lack of `wanted`."""
    n = len(nodes)
    cost = 0.0
    for leg in range(max(i - 1, 0), min(i + 1, n - 1)):
        cost += math.hypot(nodes[leg + 1, 0] - nodes[leg, 0], nodes[leg + 1, 1] - nodes[leg, 1])
    for corner in range(max(i - 1, 1), min(i + 2, n - 1)):
        cost += corner_cost(nodes, radii, wanted, weight, corner)
    return cost


@kernel
def corner_cost(nodes: Floats, radii: Floats, wanted: float, weight: float, i: int) -> float:
    """What rounding corner `i` adds to the length, a negative number, and `weight` times what it lacks of `wanted`."""
    turn, r = abs(turn_at(nodes, i)), radii[i]
    if turn > SHARPEST:
        return weight * wanted
    return float(weight * max(0.0, wanted - r * least_radius(turn)) - r * (2.0 * math.tan(turn / 2.0) - turn))
