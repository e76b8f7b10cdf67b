"""Kernels on polylines: the nearest point, the point at an arc length, gradual headings."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Floats, kernel
from planners.units import wrap_all


def headings_and_bends(steps: Floats, s: Floats, tolerance: float) -> tuple[Floats, Floats, Floats, Floats]:
    """Segment headings, vertex turns, and the knots (s, heading) between which the heading is linear.

    The turn d at a vertex is spread equally before and after it, as by an arc with equal tangents. Neighbouring
    vertices share their leg in proportion to their turns; no turn is spread over more than 8 `tolerance` / d, since an
    arc of width w that turns by d leaves its vertex by about w d / 8.
    """
    raw = np.arctan2(steps[:, 1], steps[:, 0])
    inner = wrap_all(np.diff(raw))
    headings = raw[0] + np.concatenate([[0.0], np.cumsum(inner)])
    turns = np.concatenate([[0.0], inner, [0.0]])
    size = np.maximum(np.abs(turns), 1e-12)
    of_start = np.diff(s) * size[:-1] / (size[:-1] + size[1:])
    of_end = np.diff(s) - of_start
    reach = np.minimum(np.minimum(of_end[:-1], of_start[1:]), 4.0 * tolerance / size[1:-1])
    knots = np.column_stack([s[1:-1] - reach, s[1:-1] + reach])
    values = np.column_stack([headings[:-1], headings[1:]])
    bend_s = np.concatenate([[0.0], knots.ravel(), [s[-1]]])
    bend_heading = np.concatenate([headings[:1], values.ravel(), headings[-1:]])
    return headings, turns, bend_s, bend_heading


@kernel
def interpolate(x: float, knots: Floats, values: Floats) -> float:
    """Linear interpolation at `x`, constant beyond the ends; `knots` (N,) ascending."""
    n = len(knots)
    if x <= knots[0]:
        return float(values[0])
    if x >= knots[n - 1]:
        return float(values[n - 1])
    i = int(np.searchsorted(knots, x, side="right")) - 1
    share = (x - knots[i]) / (knots[i + 1] - knots[i])
    return float(values[i] + share * (values[i + 1] - values[i]))


@kernel
def project_on_polyline(
    x: float, y: float, s_from: float, s_to: float,
    points: Floats, arc: Floats, bend_s: Floats, bend_heading: Floats,
) -> tuple[float, int, float, float, float, float]:  # fmt: skip
    """The nearest point as `nearest_on_polyline` finds it: s, segment, x, y, heading there, signed distance."""
    s, segment, px, py, e = nearest_on_polyline(x, y, s_from, s_to, points, arc)
    return s, segment, px, py, interpolate(s, bend_s, bend_heading), e


@kernel
def point_on_polyline(s: float, points: Floats, arc: Floats) -> tuple[float, float]:
    """The point at arc length `s` of `points` (N, 2+); the outer segments go on beyond the ends."""
    n = len(arc)
    i = min(max(int(np.searchsorted(arc, s, side="right")) - 1, 0), n - 2)
    share = (s - arc[i]) / (arc[i + 1] - arc[i])
    x = points[i, 0] + share * (points[i + 1, 0] - points[i, 0])
    y = points[i, 1] + share * (points[i + 1, 1] - points[i, 1])
    return x, y


@kernel
def nearest_on_polyline(
    x: float, y: float, s_from: float, s_to: float, points: Floats, arc: Floats
) -> tuple[float, int, float, float, float]:
    """Arc length, segment, place and signed distance of the point nearest to (x, y) between `s_from` and `s_to`.

    The distance is positive left of the line; at a vertex the normal of the bisector decides the side. Where an end of
    the line is nearest, its outer segment goes on beyond it as far as the window does.
    """
    last = len(arc) - 2
    first = min(max(int(np.searchsorted(arc, s_from, side="right")) - 1, 0), last)
    best = math.inf
    i_best, share_best = first, 0.0
    for i in range(first, last + 1):
        if i > first and arc[i] > s_to:
            break
        leg = arc[i + 1] - arc[i]
        low = max(0.0, (s_from - arc[i]) / leg)
        high = min(1.0, (s_to - arc[i]) / leg)
        ax, ay = points[i + 1, 0] - points[i, 0], points[i + 1, 1] - points[i, 1]
        dx, dy = x - points[i, 0], y - points[i, 1]
        share = max(min((ax * dx + ay * dy) / (leg * leg), high), low)
        dx -= share * ax
        dy -= share * ay
        square = dx * dx + dy * dy
        if square < best:
            best, i_best, share_best = square, i, share
    if (i_best == 0 and share_best == 0.0) or (i_best == last and share_best == 1.0):
        ax, ay = points[i_best + 1, 0] - points[i_best, 0], points[i_best + 1, 1] - points[i_best, 1]
        leg = arc[i_best + 1] - arc[i_best]
        beyond = (ax * (x - points[i_best, 0]) + ay * (y - points[i_best, 1])) / (leg * leg)
        beyond = max(min(beyond, (s_to - arc[i_best]) / leg), (s_from - arc[i_best]) / leg)
        share_best = beyond if beyond < 0.0 or beyond > 1.0 else share_best
    x_best = points[i_best, 0] + share_best * (points[i_best + 1, 0] - points[i_best, 0])
    y_best = points[i_best, 1] + share_best * (points[i_best + 1, 1] - points[i_best, 1])
    s_best = arc[i_best] + share_best * (arc[i_best + 1] - arc[i_best])
    best = math.hypot(x - x_best, y - y_best)
    ax, ay = points[i_best + 1, 0] - points[i_best, 0], points[i_best + 1, 1] - points[i_best, 1]
    vertex = i_best + 1 if share_best == 1.0 else i_best
    if 0 < vertex <= last and (share_best == 0.0 or share_best == 1.0):
        a, b, c = points[vertex - 1], points[vertex], points[vertex + 1]
        leg_in, leg_out = arc[vertex] - arc[vertex - 1], arc[vertex + 1] - arc[vertex]
        bx = (b[0] - a[0]) / leg_in + (c[0] - b[0]) / leg_out
        by = (b[1] - a[1]) / leg_in + (c[1] - b[1]) / leg_out
        if bx * bx + by * by > 1e-18:
            ax, ay = bx, by
    side = ax * (y - y_best) - ay * (x - x_best)
    return s_best, i_best, x_best, y_best, math.copysign(best, side)


def resampled(points: Floats, s: Floats, spacing: float) -> Floats:
    """Points at most `spacing` apart on the line `points` (N, D) with arc length `s` (N,); both ends are kept."""
    count = max(1, int(np.ceil(s[-1] / spacing - 1e-9)))
    at = np.linspace(0.0, s[-1], count + 1)
    return np.column_stack([np.interp(at, s, column) for column in points.T])
