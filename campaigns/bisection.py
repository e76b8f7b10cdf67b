"""Where along a quantity something stops to hold, by bisection."""

from __future__ import annotations

import math
from collections.abc import Callable


def border(
    holds: Callable[[float], bool], near: float, far: float, tolerance: float
) -> tuple[float | None, float | None]:
    """The value farthest from `near` for which `holds`, and the nearest tried beyond it for which not; by logarithms.

    This assumes that what holds at one value holds at every one nearer to `near`, which may be the larger or the
    smaller end of the range above 0. Where it does not, what is found is one of several borders: `holds` was true at
    the first and false at the second, and the larger of them is at most `tolerance` times the smaller above it. None
    and `near` where it does not hold there; `far` and None where it holds there.
    """
    if not holds(near):
        return None, near
    if holds(far):
        return far, None
    while max(near, far) > (1.0 + tolerance) * min(near, far):
        middle = math.sqrt(near * far)
        if holds(middle):
            near = middle
        else:
            far = middle
    return near, far
