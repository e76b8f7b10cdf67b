"""The promise: an immutable planned polyline, and how a vehicle stands to it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import pairwise

import msgspec
import numpy as np
import shapely

from planners.errors import InputError
from planners.frame import Frame
from planners.kernel import Floats, Ints
from planners.polyline import headings_and_bends, interpolate, point_on_polyline, project_on_polyline, resampled

FARTHEST = 1e9  # [m] farther than any planet's surface allows; beyond it, distances lose their millimetres


class Projection(msgspec.Struct, frozen=True):
    """The point p* of a path nearest to a position, and the signed distance to it.

    `s` [m] is the arc length at p* (negative before the start, beyond the length past the end), `segment` its index,
    `x`, `y` [m] its place, `heading` [rad] the path's there, unwrapped, and `cross_track` [m] the distance of the
    position from p*, left of the path positive.
    """

    s: float
    segment: int
    x: float
    y: float
    heading: float
    cross_track: float


@dataclass(frozen=True, slots=True)
class Path:
    """A planned polyline of N points, (N, 2) or (N, 3) [m], at least two and no two neighbours in the same place.

    `frame` says where on a planet it lies, if that is known. `tolerance` [m] is how far a curve through the vertices
    may leave the polyline: it tells a sampled curve, whose heading changes gradually, from a corner, where it jumps.
    `s` (N,) is the arc length over the ground [m], `headings` (N - 1,) the unwrapped segment headings [rad], `turns`
    (N,) the turn angle at each vertex [rad], left positive, 0 at the ends.

    Raises `InputError` for fewer than two points, a coordinate that is not finite, or neighbours that coincide.
    """

    points: Floats
    frame: Frame | None = None
    name: str = "path"
    tolerance: float = 0.05
    s: Floats = field(init=False, repr=False)
    headings: Floats = field(init=False, repr=False)
    turns: Floats = field(init=False, repr=False)
    bend_s: Floats = field(init=False, repr=False)
    bend_heading: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        points = np.array(self.points, dtype=float, order="C")
        _check(points, self.name)
        steps = np.diff(points[:, :2], axis=0)
        s = np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])
        headings, turns, bend_s, bend_heading = headings_and_bends(steps, s, self.tolerance)
        derived = {
            "points": points, "s": s, "headings": headings, "turns": turns,
            "bend_s": bend_s, "bend_heading": bend_heading,
        }  # fmt: skip
        for name, value in derived.items():
            value.setflags(write=False)
            object.__setattr__(self, name, value)

    def __reduce__(self) -> tuple[type[Path], tuple[object, ...]]:
        return Path, (self.points, self.frame, self.name, self.tolerance)

    @property
    def xy(self) -> Floats:
        """The horizontal points (N, 2) [m]."""
        return self.points[:, :2]

    @property
    def z(self) -> Floats | None:
        """The heights (N,) [m], or None for a path without heights."""
        return self.points[:, 2] if self.points.shape[1] == 3 else None

    @property
    def length(self) -> float:
        """Length over the ground [m]."""
        return float(self.s[-1])

    def with_tolerance(self, tolerance: float) -> Path:
        """The same path, with curves told from corners at `tolerance` [m]."""
        return replace(self, tolerance=tolerance)

    def heading_at(self, s: float) -> float:
        """Heading [rad] at arc length `s`, unwrapped along the path and gradual through sampled curves."""
        return interpolate(s, self.bend_s, self.bend_heading)

    def mean_curvature(self, s_from: float, s_to: float) -> float:
        """Mean curvature [1/m] from `s_from` to `s_to` [m]: the turn between them over their distance."""
        return (self.heading_at(s_to) - self.heading_at(s_from)) / (s_to - s_from)

    def height_at(self, s: float) -> float:
        """Height [m] at arc length `s`; the path must have heights."""
        return float(np.interp(s, self.s, self.points[:, 2]))

    def point_at(self, s: float) -> tuple[float, float]:
        """x, y [m] at arc length `s`; before the start and past the end the outer segments go on."""
        return point_on_polyline(s, self.points, self.s)

    def project(self, x: float, y: float, s_from: float = -np.inf, s_to: float = np.inf) -> Projection:
        """Project (x, y) [m] on the segments between the arc lengths `s_from` and `s_to` [m].

        The nearest point wins, the earlier one of two equally near. Where the first or the last segment lies in the
        window's open end, it goes on beyond the path.
        """
        return Projection(
            *project_on_polyline(
                float(x), float(y), float(s_from), float(s_to),
                self.points, self.s, self.bend_s, self.bend_heading,
            )
        )  # fmt: skip

    def resample(self, spacing: float) -> Path:
        """The same line with points every `spacing` [m] or a little less; corners between them are cut."""
        return replace(self, points=resampled(self.points, self.s, spacing))

    def simplify(self, tolerance: float) -> Ints:
        """Indices of the vertices that remain when each may be left out that moves the line by at most `tolerance` [m].

        Douglas and Peucker 1973, by GEOS. A vertex at which the path turns back, by more than 90 deg, always remains:
        what is retraced lies on the line.
        """
        back = np.flatnonzero(np.abs(self.turns) > np.pi / 2)
        corners = [0, *back.tolist(), len(self.points) - 1]
        pieces = [_simplified(self.xy, a, b, tolerance) for a, b in pairwise(corners)]
        return np.array([*(index for piece in pieces for index in piece), corners[-1]], dtype=np.int64)


def _simplified(xy: Floats, first: int, last: int, tolerance: float) -> list[int]:
    """Indices that remain from `first` up to, but without, `last`."""
    line = shapely.LineString(xy[first : last + 1])
    kept = shapely.get_coordinates(shapely.simplify(line, tolerance, preserve_topology=False))
    indices, at = [first], first
    for x, y in kept[1:-1]:
        at += 1
        while xy[at, 0] != x or xy[at, 1] != y:
            at += 1
        indices.append(at)
    return indices


def _check(points: Floats, name: str) -> None:
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise InputError(name, f"a path needs rows of x, y or x, y, z, not an array of shape {points.shape}")
    if len(points) < 2:
        raise InputError(name, f"a path needs at least two points, this has {len(points)}")
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise InputError(name, f"point {bad[0] + 1} is {points[bad[0]].tolist()}", "every coordinate must be finite")
    if np.abs(points).max() > FARTHEST:
        raise InputError(name, f"it reaches beyond {FARTHEST:g} m", "give coordinates in metres")
    same = np.flatnonzero((np.diff(points[:, :2], axis=0) == 0.0).all(axis=1))
    if len(same):
        what = f"points {same[0] + 1} and {same[0] + 2} are in the same place, or above each other"
        raise InputError(name, what, "leave one out")
