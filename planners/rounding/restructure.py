"""Lines with a vertex less, where a corner lacks radius because its neighbours are too near."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from planners.kernel import Bools, Floats
from planners.rounding.corner_kernels import is_window_free, least_radius, turn_at
from planners.rounding.relax_kernels import GAIN, relax, total_cost


def restructured(
    blocked: Bools, nodes: Floats, radii: Floats, wanted: float, weight: float, step: float
) -> tuple[Floats, Floats]:
    """`nodes` (N, 2) and `radii` (N,) [cells] with fewer vertices where that costs less.

    Each corner that lacks radius, the one that lacks most first, is tried without a vertex beside it, or with two
    vertices merged to one; what is left is relaxed in steps from `step` [cells].
    """
    given_up = 0
    while True:
        lack = wanted - np.array([radii[i] * least_radius(turn_at(nodes, i)) for i in range(1, len(nodes) - 1)])
        order = np.argsort(-lack, kind="stable")
        if given_up >= len(lack) or lack[order[given_up]] <= 0.0:
            return nodes, radii
        best, found = total_cost(nodes, radii, wanted, weight) - GAIN, None
        for fewer, at in _fewer(nodes, int(order[given_up]) + 1):
            rounding = np.delete(radii, at)
            rounding[max(at - 1, 0) : at + 1] = 0.0
            if not is_window_free(blocked, fewer, rounding, min(at, len(fewer) - 2)):
                continue
            relax(blocked, fewer, rounding, wanted, weight, at - 2, at + 2, step, step / 8.0)
            cost = total_cost(fewer, rounding, wanted, weight)
            if cost < best:
                best, found = cost, (fewer, rounding)
        if found is None:
            given_up += 1
        else:
            nodes, radii = found


def _fewer(nodes: Floats, i: int) -> Iterator[tuple[Floats, int]]:
    """Lines with one vertex less about `i`, and which of them is new or gone."""
    last = len(nodes) - 1
    for at in (i - 1, i, i + 1):
        if 0 < at < last:
            yield np.delete(nodes, at, axis=0), at
    for at in (i - 1, i):
        if 0 < at < last - 1 and (merged := _merged(nodes, at)) is not None:
            yield merged, at


def _merged(nodes: Floats, i: int) -> Floats | None:
    """Vertices `i` and i + 1 as one, where the legs beside them meet; None where they do not."""
    before, between, after = nodes[i] - nodes[i - 1], nodes[i + 1] - nodes[i], nodes[i + 2] - nodes[i + 1]
    cross = before[0] * after[1] - before[1] * after[0]
    if cross == 0.0:
        return None
    ahead = (between[0] * after[1] - between[1] * after[0]) / cross
    back = (between[0] * before[1] - between[1] * before[0]) / cross
    if ahead < 0.0 or back > 0.0:
        return None
    fewer = np.delete(nodes, i, axis=0)
    fewer[i] = nodes[i] + ahead * before
    return fewer
