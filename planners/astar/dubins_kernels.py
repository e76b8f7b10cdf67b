"""Shortest paths between two poses that turn no tighter than a radius (Dubins 1957).

The words are those of Shkel and Lumelsky 2001, of unit radius: from (0, 0) at the angle `alpha` to (d, 0) at the angle
`beta`. Those that begin to the right are those that begin to the left, in the mirror.
"""

from __future__ import annotations

import math

from planners.kernel import kernel

FULL_TURN = 2.0 * math.pi
LSL, LSR, LRL = range(3)  # left, straight, left; left, straight, right; left, right, left
ROUNDING = 1e-9  # [rad] less than a whole turn by that is none


@kernel
def from_0(angle: float) -> float:
    """The angle from 0 to a whole turn; 0 where rounding has left it just below."""
    return max((angle + ROUNDING) % FULL_TURN - ROUNDING, 0.0)


@kernel
def word(kind: int, alpha: float, beta: float, d: float) -> tuple[float, float, float]:
    """Lengths of the three pieces of a word that begins to the left; the middle one is inf where it does not lead."""
    sa, ca, sb, cb = math.sin(alpha), math.cos(alpha), math.sin(beta), math.cos(beta)
    if kind == LSL:
        across, along = cb - ca, d + sa - sb
        to = math.atan2(across, along)
        return from_0(to - alpha), math.hypot(across, along), from_0(beta - to)
    if kind == LSR:
        across, along = -ca - cb, d + sa + sb
        square = across * across + along * along - 4.0
        if square < 0.0:
            return 0.0, math.inf, 0.0
        straight = math.sqrt(square)
        to = math.atan2(across, along) + math.atan2(2.0, straight)
        return from_0(to - alpha), straight, from_0(to - beta)
    across, along = cb - ca, d + sa - sb
    apart = math.hypot(across, along)
    if apart > 4.0:
        return 0.0, math.inf, 0.0
    middle = FULL_TURN - 2.0 * math.asin(0.25 * apart)
    first = from_0(math.atan2(across, along) - alpha + 0.5 * middle)
    return first, middle, from_0(beta - alpha - first + middle)


@kernel
def way_to_pose(ahead: float, left: float, turn: float, radius: float) -> float:
    """Length [m] of the shortest path to a point `ahead` and `left` [m] where the heading has turned by `turn` [rad].

    No tighter than `radius` [m], without obstacles.
    """
    d, bearing = math.hypot(ahead, left) / radius, math.atan2(left, ahead)
    best = math.inf
    for side in (-1.0, 1.0):
        for kind in (LSL, LSR, LRL):
            first, middle, last = word(kind, -side * bearing, side * (turn - bearing), d)
            best = min(best, first + middle + last)
    return radius * best
