"""Departure delays that keep vehicles apart: the least waiting in all that does, found exactly.

A vehicle that starts later flies the same track later, as long as the wind is steady. So two tracks tell which relative
delays bring their vehicles too close, and what is left is a linear programme over the gaps between those delays.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations

import numpy as np
from scipy.optimize import LinearConstraint, milp
from scipy.sparse import coo_array

from planners.errors import TrackworthyError
from planners.kernel import Floats
from tracking.separation import PLACE, nearest
from tracking.track import Track

Run = tuple[int, int]  # whole seconds, first and last
EARLIER = 1e-4  # by how much a second of waiting weighs more for each later number: it settles ties


def delays(tracks: Sequence[Track], least: float) -> tuple[float, ...]:
    """Departures in whole seconds from 0 on that keep all `tracks` `least` [m] apart, with the least waiting in all."""
    places, off = zip(*(_each_second(track) for track in tracks), strict=True)
    pairs = combinations(range(len(tracks)), 2)
    conflicts = {(i, j): too_close(places[i], places[j], least + off[i] + off[j]) for i, j in pairs}
    return tuple(float(delay) for delay in least_waiting(len(tracks), conflicts))


def too_close(first: Floats, second: Floats, least: float) -> list[Run]:
    """The delays of the `second` after the `first` [s], in runs, that bring them nearer than `least` [m].

    Both are places (N, 3) [m] a second apart, between which they move straight.
    """
    reach = range(1 - len(second), len(first))
    return in_runs(delay for delay in reach if _nearest(first, second, delay) < least)


def in_runs(seconds: Iterable[int]) -> list[Run]:
    """Ascending `seconds` as runs of neighbours."""
    runs: list[Run] = []
    for second in seconds:
        if runs and second == runs[-1][1] + 1:
            runs[-1] = (runs[-1][0], second)
        else:
            runs.append((second, second))
    return runs


def least_waiting(count: int, conflicts: Mapping[tuple[int, int], Sequence[Run]]) -> list[int]:
    """The delays [s] of `count` vehicles with the smallest sum, no pair's relative delay being in its `conflicts`.

    A mixed-integer programme: a binary for each gap between a pair's conflicts, exactly one of which is chosen.
    """
    horizon = 1 + sum(max(abs(low), abs(high)) + 1 for runs in conflicts.values() for low, high in runs)
    rows: list[tuple[list[tuple[int, float]], float, float]] = []  # terms (column, factor), and what bounds their sum
    width = count
    for (i, j), runs in conflicts.items():
        if not runs:
            continue
        lows = [-horizon, *(high + 1 for _, high in runs)]
        highs = [*(low - 1 for low, _ in runs), horizon]
        gaps = range(width, width + len(lows))
        width += len(lows)
        difference = [(j, 1.0), (i, -1.0)]
        rows.append(([(gap, 1.0) for gap in gaps], 1.0, 1.0))
        rows.append(([*difference, *((gap, -float(low)) for gap, low in zip(gaps, lows, strict=True))], 0.0, np.inf))
        rows.append(
            ([*difference, *((gap, -float(high)) for gap, high in zip(gaps, highs, strict=True))], -np.inf, 0.0)
        )
    if not rows:
        return [0] * count
    weights = np.concatenate([1.0 + EARLIER * np.arange(count), np.zeros(width - count)])
    entries = [(row, column, factor) for row, (terms, _, _) in enumerate(rows) for column, factor in terms]
    at_row, at_column, factors = zip(*entries, strict=True)
    matrix = coo_array((factors, (at_row, at_column)), shape=(len(rows), width)).tocsr()
    _, lower, upper = zip(*rows, strict=True)
    bounds = (np.zeros(width), np.concatenate([np.full(count, horizon), np.ones(width - count)]))
    found = milp(
        weights,
        constraints=LinearConstraint(matrix, lower, upper),
        integrality=np.ones(width),
        bounds=bounds,
        options={"mip_rel_gap": 0.0},
    )
    if found.x is None:
        raise TrackworthyError(f"departure delays: {found.message}; this is a fault of trackworthy")
    return [round(delay) for delay in found.x[:count]]


def _each_second(track: Track) -> tuple[Floats, float]:
    """Where the vehicle was (N, 3) [m] each second, and how far it ever was from the straight line between [m]."""
    t, own = np.arange(np.ceil(track["t"][-1]) + 1.0), track["t"]
    places = np.column_stack([np.interp(t, own, track[axis]) for axis in PLACE])
    between = np.column_stack([np.interp(own, t, places[:, i]) for i in range(len(PLACE))])
    true = np.column_stack([track[axis] for axis in PLACE])
    return places, float(np.linalg.norm(true - between, axis=1).max())


def _nearest(first: Floats, second: Floats, delay: int) -> float:
    """The smallest distance [m] where the second starts `delay` [s] after the first; infinite if it is gone by then."""
    start, end = max(0, delay), min(len(first), len(second) + delay)
    return nearest(first[start:end] - second[start - delay : end - delay])[0]
