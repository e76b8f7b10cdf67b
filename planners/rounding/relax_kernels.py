"""Kernels that move the vertices of a rounded line and choose its radii; in units of cells.

A pattern search (Hooke and Jeeves 1961) that never leaves what is free: it starts from a free polyline without any
rounding, and takes a step only where all that depends on it is free.
"""

from __future__ import annotations

import math

from planners.kernel import Bools, Floats, kernel
from planners.rounding.corner_kernels import corner_cost, is_window_free, window_cost

GAIN = 1e-6  # cells that a step must gain
DIRECTIONS = 12
SWEEPS = 30  # at most, with one step


@kernel
def relax(
    blocked: Bools, nodes: Floats, radii: Floats, wanted: float, weight: float, first: int, last: int,
    coarsest: float, finest: float,
) -> None:  # fmt: skip
    """Improve the vertices from `first` to `last` of `nodes` (N, 2) and their `radii` (N,) in place, in steps from
    `coarsest` to `finest` cells.
    """
    step = coarsest
    while step >= finest:
        for _ in range(SWEEPS):
            gained = False
            for i in range(max(first, 1), min(last + 1, len(nodes) - 1)):
                if _improve(blocked, nodes, radii, wanted, weight, step, i):
                    gained = True
            if not gained:
                break
        step /= 2.0


@kernel
def _improve(blocked: Bools, nodes: Floats, radii: Floats, wanted: float, weight: float, step: float, i: int) -> bool:
    x, y, r = nodes[i, 0], nodes[i, 1], radii[i]
    best = window_cost(nodes, radii, wanted, weight, i) - GAIN
    best_x, best_y, best_r = x, y, r
    before = math.atan2(y - nodes[i - 1, 1], x - nodes[i - 1, 0])
    after = math.atan2(nodes[i + 1, 1] - y, nodes[i + 1, 0] - x)
    for k in range(DIRECTIONS + 1):
        # All around, and along the legs: two vertices that touch obstacles on either side cannot but slide
        angle = k * math.pi / 4.0 if k < 8 else (before if k < 10 else after) + k % 2 * math.pi
        reach = step if k < DIRECTIONS else 0.0
        nodes[i, 0], nodes[i, 1] = x + reach * math.cos(angle), y + reach * math.sin(angle)
        for choice in range(5 if wanted > 0.0 else 1):
            if choice == 0:
                radii[i] = r
            elif choice == 1:
                radii[i] = max(1.3 * r, 0.05 * wanted)
            elif choice == 2:
                radii[i] = 0.8 * r
            elif choice == 3:
                radii[i] = max(1.02 * r, 0.01 * wanted)
            else:
                radii[i] = 1.001 * wanted
            if k == DIRECTIONS and choice == 0:
                continue
            cost = window_cost(nodes, radii, wanted, weight, i)
            if cost < best and is_window_free(blocked, nodes, radii, i):
                best, best_x, best_y, best_r = cost, nodes[i, 0], nodes[i, 1], radii[i]
    nodes[i, 0], nodes[i, 1], radii[i] = best_x, best_y, best_r
    return bool(best_x != x or best_y != y or best_r != r)


@kernel
def total_cost(nodes: Floats, radii: Floats, wanted: float, weight: float) -> float:
    """Length of the rounded line, and `weight` times what its radii lack of `wanted`."""
    cost = 0.0
    for i in range(1, len(nodes)):
        cost += math.hypot(nodes[i, 0] - nodes[i - 1, 0], nodes[i, 1] - nodes[i - 1, 1])
    for i in range(1, len(nodes) - 1):
        cost += corner_cost(nodes, radii, wanted, weight, i)
    return cost
