"""Fly-by corners: what a navigator does to the corners of a mission before a vehicle sees them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from planners.kernel import Floats
from planners.path import Path

FLY_BY_MOST = math.radians(120.0)  # ICAO Doc 8168, I-2-2: sharper turns are not fly-by


@dataclass(frozen=True, slots=True)
class Rounded:
    """A corner at `s` [m] of the original path, rounded with `radius` [m] of a `wanted` one and `cut` by that much [m].

    A `radius` of 0 is a corner left as drawn because it is too sharp to fly by.
    """

    s: float
    angle: float
    radius: float
    wanted: float
    cut: float


def fly_by(path: Path, radius: Callable[[float, float], float], deviation: float) -> tuple[Path, tuple[Rounded, ...]]:
    """Replace every corner by an arc, and tell what each cost.

    `radius(course, angle)` [m] is what the vehicle needs for a turn by `angle` from `course` [rad]. An arc of radius R
    through a turn d starts R tan(d / 2) before the corner and cuts it by R (1 / cos(d / 2) - 1) (ICAO Doc 8168, fly-by
    waypoint). Where neighbouring arcs do not fit on a leg, both give way in proportion. Corners so flat that their arc
    would stay within `deviation` [m] are left alone; arcs are drawn within it too. Corners beyond 120 deg stay as
    drawn.
    """
    turns = path.turns[1:-1]
    half = np.abs(turns) / 2
    wanted = np.array([radius(float(h), float(d)) for h, d in zip(path.headings, turns, strict=False)])
    sharp = np.abs(turns) > FLY_BY_MOST
    flat = wanted * (1.0 / np.cos(np.where(sharp, 0.0, half)) - 1.0) <= deviation
    tangent = np.where(sharp | flat, 0.0, wanted * np.tan(half))
    reach = _fitted(tangent, np.diff(path.s))
    pieces: list[Floats] = [path.points[:1]]
    report = []
    for i, (turn, t) in enumerate(zip(turns.tolist(), reach.tolist(), strict=True), start=1):
        if t == 0.0:
            pieces.append(path.points[i : i + 1])
            if sharp[i - 1]:
                report.append(Rounded(float(path.s[i]), turn, 0.0, float(wanted[i - 1]), 0.0))
            continue
        r = t / math.tan(abs(turn) / 2)
        pieces.append(_arc(path, i, turn, t, r, deviation))
        cut = r * (1.0 / math.cos(turn / 2) - 1.0)
        report.append(Rounded(float(path.s[i]), turn, r, float(wanted[i - 1]), cut))
    pieces.append(path.points[-1:])
    points = np.concatenate(pieces)
    apart = np.concatenate([[True], np.hypot(*np.diff(points[:, :2], axis=0).T) > 1e-6])
    return replace(path, points=points[apart]), tuple(report)


def _fitted(tangent: Floats, legs: Floats) -> Floats:
    """Tangent lengths (K,) shortened so that those at both ends of each of the `legs` (K + 1,) fit on it."""
    ends = np.concatenate([[0.0], tangent, [0.0]])
    with np.errstate(divide="ignore"):
        share = np.minimum(legs / (ends[:-1] + ends[1:]), 1.0)
    fitted: Floats = tangent * np.minimum(share[:-1], share[1:])
    return fitted


def _arc(path: Path, vertex: int, turn: float, tangent: float, radius: float, deviation: float) -> Floats:
    """Points of the arc around `vertex`; heights go on along the original path."""
    side = math.copysign(1.0, turn)
    heading, s = float(path.headings[vertex - 1]), float(path.s[vertex])
    start = np.array(path.point_at(s - tangent))
    centre = start + radius * side * np.array([-math.sin(heading), math.cos(heading)])
    step = 2.0 * math.acos(max(1.0 - deviation / radius, 0.0))
    share = np.linspace(0.0, 1.0, max(2, math.ceil(abs(turn) / step) + 1))
    bearing = heading + turn * share
    xy = centre + radius * side * np.column_stack([np.sin(bearing), -np.cos(bearing)])
    if path.z is None:
        return xy
    return np.column_stack([xy, np.interp(s - tangent + 2.0 * tangent * share, path.s, path.z)])
