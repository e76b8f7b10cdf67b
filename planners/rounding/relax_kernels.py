"""Kernels that move the vertices of a rounded line and choose its radii; in units of cells.

A pattern search (Hooke and Jeeves 1961) that never leaves what is free: it starts from a free polyline without any
rounding, and takes a step only where all that depends on it is free.
"""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Bools, Floats, kernel
from planners.rounding.corner_kernels import corner_cost, is_window_free, least_radius, turn_at, window_cost

GAIN = 1e-6  # cells that a step must gain
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
    for k in range(9):
        angle = k * math.pi / 4.0
        nodes[i, 0] = x + (step * math.cos(angle) if k < 8 else 0.0)
        nodes[i, 1] = y + (step * math.sin(angle) if k < 8 else 0.0)
        for choice in range(5):
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
            if k == 8 and choice == 0:
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


@kernel
def restructure(
    blocked: Bools, nodes: Floats, radii: Floats, wanted: float, weight: float, step: float
) -> tuple[Floats, Floats]:
    """Where a corner lacks radius, try the line with one vertex less; keep what costs least."""
    given_up = 0
    while True:
        lacking = _lacking(nodes, radii, wanted, given_up)
        if lacking < 0:
            return nodes, radii
        best = total_cost(nodes, radii, wanted, weight) - GAIN
        best_nodes, best_radii = nodes, radii
        for choice in range(5):
            at = lacking - 1 + choice % 3 if choice < 3 else lacking - 4 + choice
            if at < 1 or at > len(nodes) - 2 or (choice >= 3 and at > len(nodes) - 3):
                continue
            fewer = _without(nodes, at) if choice < 3 else _merged(nodes, at)
            if len(fewer) == len(nodes):
                continue
            rounded = np.empty(len(fewer))
            rounded[:at] = radii[:at]
            rounded[at:] = radii[at + 1 :]
            for k in range(max(at - 1, 0), min(at + 2, len(fewer))):
                rounded[k] = 0.0
            if not is_window_free(blocked, fewer, rounded, min(at, len(fewer) - 2)):
                continue
            relax(blocked, fewer, rounded, wanted, weight, at - 2, at + 2, step, step / 8.0)
            cost = total_cost(fewer, rounded, wanted, weight)
            if cost < best:
                best, best_nodes, best_radii = cost, fewer, rounded
        if len(best_nodes) == len(nodes):
            given_up += 1
        nodes, radii = best_nodes, best_radii


@kernel
def _lacking(nodes: Floats, radii: Floats, wanted: float, skipped: int) -> int:
    """The corner that lacks most radius but for `skipped` others; -1 where none does."""
    n = len(nodes)
    lack = np.zeros(n)
    for i in range(1, n - 1):
        lack[i] = wanted - radii[i] * least_radius(turn_at(nodes, i))
    order = np.argsort(-lack)
    if skipped >= n or lack[order[skipped]] <= 0.0:
        return -1
    return int(order[skipped])


@kernel
def _without(nodes: Floats, i: int) -> Floats:
    fewer = np.empty((len(nodes) - 1, 2))
    fewer[:i] = nodes[:i]
    fewer[i:] = nodes[i + 1 :]
    return fewer


@kernel
def _merged(nodes: Floats, i: int) -> Floats:
    """Vertices `i` and i + 1 as one, where the legs beside them meet; as they are where they do not."""
    ax, ay = nodes[i, 0] - nodes[i - 1, 0], nodes[i, 1] - nodes[i - 1, 1]
    bx, by = nodes[i + 2, 0] - nodes[i + 1, 0], nodes[i + 2, 1] - nodes[i + 1, 1]
    dx, dy = nodes[i + 1, 0] - nodes[i, 0], nodes[i + 1, 1] - nodes[i, 1]
    cross = ax * by - ay * bx
    if cross == 0.0:
        return nodes
    on_a, on_b = (dx * by - dy * bx) / cross, (dx * ay - dy * ax) / cross
    if on_a < 0.0 or on_b > 0.0:
        return nodes
    fewer = _without(nodes, i)
    fewer[i, 0], fewer[i, 1] = nodes[i, 0] + on_a * ax, nodes[i, 1] + on_a * ay
    return fewer
