"""The bounds of a smooth path, linear in small shifts of its points along their normals, and the best such shifts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_matrix

from planners.astar.room import Body, Room
from planners.astar.smooth_kernels import bends, contacts, normals
from planners.kernel import Floats

WITHIN = 1e-3  # [1] relative, how far beyond a bound counts as kept
PRICES = (2e3, 1e3, 50.0)  # [m] of length for all of a bound on curvature, on its change, and for a metre of margin
BESIDE = 1e-3  # [legs] from an end, a point that gives its heading: the curvature there is of half a leg
ACCURACY = 1e-6  # of the quadratic programs, absolute and relative


@dataclass(frozen=True, slots=True)
class Bounds:
    """Bounds on `curvature` [1/m], its `change` [1/m^2] along the path, and the `margin` [m] wanted of the body.

    Headings [rad] at the `start` and at the `goal` are None where they are free. The path begins with straight wheels.
    """

    curvature: float
    change: float
    margin: float
    start: float | None = None
    goal: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Linear:
    """A path's `points` (N, 2) [m], how `left` (N, 2) of it is, and what it must keep to: `rows` x <= `right`.

    x are the shifts [m] of the points between its ends, and by how much each kind of bound gives way. `excess` (3,) is
    how far curvature and its change are beyond their bounds, relative to them, and how much margin [m] is missing.
    """

    points: Floats
    left: Floats
    rows: csc_matrix
    right: Floats
    excess: Floats
    length: float

    @property
    def merit(self) -> float:
        """Length [m], and the price of what is not kept."""
        return self.length + float(np.dot(PRICES, self.excess.clip(0.0)))

    @property
    def kept(self) -> bool:
        """Whether curvature and its change are within their bounds."""
        return bool((self.excess[:2] <= WITHIN).all())


def linearised(points: Floats, room: Room, body: Body, bounds: Bounds, near: float) -> Linear:
    """The bounds about the path through `points` (N, 2) [m]; only what is as `near` [m] to the body is one."""
    n, left = len(points), normals(points)
    length = float(np.hypot(*np.diff(points, axis=0).T).sum())
    leg = length / (n - 1)
    before, after = _beyond(points[0], bounds.start, -BESIDE * leg), _beyond(points[-1], bounds.goal, BESIDE * leg)
    bend, bend_by, change, change_by = bends(points, left, before, after)
    sharpest = np.full(n, bounds.curvature)
    # Wheels begin straight, and what counts at the start is a quarter of a leg on
    sharpest[0] = min(bounds.curvature, 0.25 * leg * bounds.change)
    if bounds.goal is None:  # the curvature at the end is free
        change, change_by = change[:-1], change_by[:-1]
    bend, bend_by, change, change_by = (
        bend / sharpest, bend_by / sharpest[:, None], change / bounds.change, change_by / bounds.change
    )  # fmt: skip
    radius = body.radius + bounds.margin
    at, spare, spare_by = contacts(points, left, room.field, room.cell, room.size, body.along, radius, near)
    points_at, changes_at = np.arange(n), np.arange(len(change))
    blocks = (
        (0, points_at, bend_by, 1.0 - bend), (0, points_at, -bend_by, 1.0 + bend),
        (1, changes_at, change_by, 1.0 - change), (1, changes_at, -change_by, 1.0 + change),
        (2, at, -spare_by, spare),
    )  # fmt: skip
    rows, columns, values, first = [], [], [], 0
    for kind, where, by, right in blocks:
        row = first + np.arange(len(right))
        # Shifts are of the points between the ends, and the ends have no normal
        own = (where[:, None] + np.arange(-2, by.shape[1] - 2)).clip(0, n - 3)
        rows += [np.repeat(row, by.shape[1]), row]
        columns += [own.ravel(), np.full(len(row), n - 2 + kind)]
        values += [by.ravel(), np.full(len(row), -1.0)]
        first += len(row)
    matrix = csc_matrix(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=(first, n - 2 + len(PRICES))
    )
    excess = np.array([np.abs(bend).max() - 1.0, np.abs(change).max() - 1.0, -spare.min(initial=1.0)])
    return Linear(points, left, matrix, np.concatenate([block[3] for block in blocks]), excess, length)


def best_shifts(path: Linear, trust: float) -> Floats:
    """Shifts (N,) [m] of the points, up to `trust` each, of the shortest path within the linear bounds.

    None of them moves where the solver finds no such shifts. What stands for length is the sum of the legs' squares
    over their mean.
    """
    import piqp  # here, for most of what imports planners solves none

    n = len(path.points) - 2
    leg = path.length / (n + 1)
    legs, inner = np.diff(path.points, axis=0), path.left[1:-1]
    gradient = 2.0 / leg * (inner * (legs[:-1] - legs[1:])).sum(axis=1)
    beside = -2.0 / leg * (inner[:-1] * inner[1:]).sum(axis=1)
    i, kinds = np.arange(n), len(PRICES)
    cost = csc_matrix(
        (
            np.concatenate([np.full(n, 4.0 / leg), beside, beside]),
            (np.concatenate([i, i[:-1], i[1:]]), np.concatenate([i, i[1:], i[:-1]])),
        ),
        shape=(n + kinds, n + kinds),
    )
    least = np.concatenate([np.full(n, -trust), np.zeros(kinds)])
    greatest = np.concatenate([np.full(n, trust), np.full(kinds, np.inf)])
    solver = piqp.SparseSolver()
    solver.settings.eps_abs = solver.settings.eps_rel = ACCURACY
    solver.setup(cost, np.concatenate([gradient, PRICES]), None, None, path.rows, None, path.right, least, greatest)
    if solver.solve() != piqp.PIQP_SOLVED:
        return np.zeros(n + 2)
    return np.concatenate([[0.0], np.asarray(solver.result.x)[:n], [0.0]])


def _beyond(point: Floats, heading: float | None, distance: float) -> Floats:
    """The point (1, 2) `distance` [m] from an end in the direction given for it; (0, 2) where none is."""
    if heading is None:
        return np.empty((0, 2))
    return np.array([point + distance * np.array([np.cos(heading), np.sin(heading)])])
