"""What a pigeon is: the path of one aircraft as lateral offsets, or those of all of them together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely

from planners.kernel import Bools, Floats
from planners.pio.course_kernels import EVEN, equal_legs, judge, shape_of
from planners.pio.field import Field
from planners.voronoi.roadmap import lines_free

MARGIN = 0.03  # [cells of the field] more than the clearance while searching: so much may the field be wrong
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Limits:
    """What every path must keep: `clearance` and `longest` (paper 001, eq. 3) [map units], `sharpest` (eq. 4) [rad].

    Turns beyond `gentle` [rad] are allowed, but cost.
    """

    clearance: float
    longest: float
    sharpest: float
    gentle: float = math.inf


@dataclass(frozen=True, slots=True, eq=False)
class Judged:
    """Of N pigeons: `cost` (N,) with what breaks a limit, `length` (N,), and whether all limits are `kept` (N,)."""

    cost: Floats
    length: Floats
    kept: Bools


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """From `start` to `goal` (2,) in `segments` legs of equal length, within `limits`.

    A position (segments - 1,) holds lateral offsets from the straight line, to the left, at equal stations.
    """

    start: Floats
    goal: Floats
    segments: int
    limits: Limits
    field: Field

    @property
    def dimensions(self) -> int:
        """How many offsets a position has."""
        return self.segments - 1

    @property
    def paths(self) -> int:
        """How many paths a position stands for."""
        return 1

    def clipped(self, positions: Floats) -> Floats:
        """`positions` (N, D) no farther aside than the map is wide: beyond, all paths are as bad."""
        rows, columns = self.field.room.shape
        reach = self.field.cell * math.hypot(rows, columns)
        return np.asarray(np.clip(positions, -reach, reach))

    def judge(self, positions: Floats) -> Judged:
        """Cost, length and limits of `positions` (N, D)."""
        n, room = len(positions), self.field
        told = Judged(np.empty(n), np.empty(n), np.empty(n, dtype=np.bool_))
        judge(
            positions, self.start, self.goal, room.room, room.cell, room.x, room.y,
            self.limits.clearance + MARGIN * room.cell, self.limits.gentle, self.limits.sharpest - ROUNDING,
            self.limits.longest * (1.0 - ROUNDING), told.cost, told.length, told.kept,
        )  # fmt: skip
        return told

    def gradients(self, positions: Floats, step: float) -> Floats:
        """Forward differences (N, D) of the cost of `positions` (N, D) over `step`: D + 1 evaluations each."""
        n, d = positions.shape
        moved = positions[:, None, :] + step * np.eye(d)
        costs = self.judge(np.concatenate([positions, moved.reshape(n * d, d)])).cost
        return np.asarray((costs[n:].reshape(n, d) - costs[:n, None]) / step)

    def legs(self, position: Floats) -> Floats:
        """The path (segments + 1, 2) of a position (D,)."""
        raw, legs = np.empty((self.segments + 1, 2)), np.empty((self.segments + 1, 2))
        equal_legs(position, self.start, self.goal, raw, legs)
        return legs

    def offsets(self, path: Floats) -> Floats:
        """The position (D,) nearest to a `path` (N, 2) from start to goal; one that turns back is cut short."""
        line = shapely.LineString(path)
        dense = shapely.get_coordinates(shapely.segmentize(line, line.length / (20 * self.segments))) - self.start
        forward = (self.goal - self.start) / np.hypot(*(self.goal - self.start))
        along, left = dense @ forward, dense @ np.array([-forward[1], forward[0]])
        stations = np.hypot(*(self.goal - self.start)) * np.arange(1, self.segments) / self.segments
        return np.asarray(left[np.abs(along[None] - stations[:, None]).argmin(axis=1)])


@dataclass(frozen=True, slots=True, eq=False)
class Joint:
    """All courses as one: a position is theirs, one after the other, and its cost is the sum (paper 001, eq. 19)."""

    courses: Sequence[Course]

    @property
    def dimensions(self) -> int:
        """How many offsets a position has."""
        return sum(course.dimensions for course in self.courses)

    @property
    def paths(self) -> int:
        """How many paths a position stands for."""
        return len(self.courses)

    def split(self, positions: Floats) -> list[Floats]:
        """Those of each course, from positions (..., D)."""
        ends = np.cumsum([course.dimensions for course in self.courses])[:-1]
        return [np.ascontiguousarray(part) for part in np.split(positions, ends, axis=-1)]

    def clipped(self, positions: Floats) -> Floats:
        """As each course does it."""
        parts = zip(self.courses, self.split(positions), strict=True)
        return np.hstack([course.clipped(part) for course, part in parts])

    def judge(self, positions: Floats) -> Judged:
        """Cost, length and limits of `positions` (N, D)."""
        parts = zip(self.courses, self.split(positions), strict=True)
        told = [course.judge(part) for course, part in parts]
        return Judged(
            cost=np.sum([one.cost for one in told], axis=0),
            length=np.sum([one.length for one in told], axis=0),
            kept=np.all([one.kept for one in told], axis=0),
        )

    def gradients(self, positions: Floats, step: float) -> Floats:
        """As of each course by itself, since the cost is a sum."""
        parts = zip(self.courses, self.split(positions), strict=True)
        return np.hstack([course.gradients(part, step) for course, part in parts])


def keeps(path: Floats, free: Any, limits: Limits) -> bool:
    """Whether a path (N, 2) lies in the `free` space and keeps range and turn; exact, as the swarm's field is not."""
    length, turn, _, _ = shape_of(path)
    within = length <= limits.longest * (1.0 + ROUNDING) and turn <= limits.sharpest + ROUNDING
    return within and bool(lines_free(free, np.stack([path[:-1], path[1:]], axis=1)).all())


def is_even(path: Floats) -> bool:
    """Whether its legs are of equal length, within 10 %."""
    _, _, longest, shortest = shape_of(path)
    return longest <= 1.0 + EVEN and shortest >= 1.0 - EVEN
