"""Discrete Frechet distance of track and path: the shortest leash for two that walk along both."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Floats, kernel
from planners.polyline import resampled
from tracking.metric import Metric
from tracking.run import Run

FAR = 10.0  # corridors, beyond which a distance need not be known to a tenth of the corridor
MOST_POINTS = 500_000  # of a resampled curve
SHARE = 0.01  # of such a distance, to which it is known


def frechet(run: Run) -> list[Metric]:
    """Discrete Frechet distance [m] of both curves, resampled to a tenth of the corridor (Eiter and Mannila 1994).

    Where the curves part by more than ten corridors the spacing is a hundredth of their greedy distance: the recursion
    would take quadratic time for digits that tell nothing.
    """
    track = run.track
    flown, distance = np.column_stack([track["x"], track["y"]]), track.distance
    if distance[-1] == 0.0:
        return [Metric("frechet", math.nan, "m", valid=False, note="the vehicle did not move")]
    spacing = max(0.1 * run.corridor, max(distance[-1], run.path.length) / MOST_POINTS)
    for _ in range(2):
        a = resampled(flown, distance, spacing)
        b = resampled(run.path.xy, run.path.s, spacing)
        bound = _greedy(a, b)
        if SHARE * bound <= spacing or bound <= FAR * run.corridor:
            break
        spacing = SHARE * bound
    return [Metric("frechet", _within(a, b, bound), "m", note=f"both resampled to {spacing:.3g} m")]


def frechet_distance(a: Floats, b: Floats) -> float:
    """Discrete Frechet distance of the point sequences `a` (N, 2) and `b` (M, 2)."""
    return _within(a, b, _greedy(a, b))


@kernel
def _greedy(a: Floats, b: Floats) -> float:
    """The leash of one walk, always the step that stays closest: an upper bound."""
    i, j = 0, 0
    n, m = len(a), len(b)
    longest = math.hypot(a[0, 0] - b[0, 0], a[0, 1] - b[0, 1])
    while i < n - 1 or j < m - 1:
        best, i_best, j_best = math.inf, i, j
        for di, dj in ((1, 1), (1, 0), (0, 1)):
            p, q = i + di, j + dj
            if p < n and q < m:
                distance = math.hypot(a[p, 0] - b[q, 0], a[p, 1] - b[q, 1])
                if distance < best:
                    best, i_best, j_best = distance, p, q
        i, j = i_best, j_best
        longest = max(longest, best)
    return longest


@kernel
def _within(a: Floats, b: Floats, bound: float) -> float:
    """Eiter and Mannila's recursion over the cells that a leash of `bound`, an upper bound, can reach.

    An optimal walk never leaves those cells, so the result is exact, and curves that stay close cost little.
    """
    n, m = len(a), len(b)
    previous = np.full(m, math.inf)
    current = np.full(m, math.inf)
    low, high = 0, 0  # of the previous row's reachable cells
    for i in range(n):
        new_low, new_high = m, -1
        j = low
        while j < m:
            if i == 0 and j == 0:
                reach = 0.0
            else:
                reach = math.inf
                if i > 0 and j <= high:
                    reach = min(reach, previous[j])
                if i > 0 and j > 0 and low <= j - 1 <= high:
                    reach = min(reach, previous[j - 1])
                if j > low:
                    reach = min(reach, current[j - 1])
            if reach == math.inf and (i == 0 or j > high):
                break
            distance = math.hypot(a[i, 0] - b[j, 0], a[i, 1] - b[j, 1])
            current[j] = max(reach, distance) if distance <= bound else math.inf
            if current[j] < math.inf:
                new_low, new_high = min(new_low, j), j
            j += 1
        if j < m:
            current[j] = math.inf
        low, high = new_low, max(new_high, j - 1)
        previous, current = current, previous
    return float(previous[m - 1])
