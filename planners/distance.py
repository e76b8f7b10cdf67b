"""Exact signed distances of an oriented rectangle to segments and circles, in the rectangle's own frame.

The rectangle is |x| <= `half_length`, |y| <= `half_width`. Depth at a point inside is the distance to its
nearest side, min(half_length - |x|, half_width - |y|); it is concave, so on a segment it is greatest at an
end or where two of the four sides are equally near.
"""

from __future__ import annotations

import numpy as np

from planners.kernel import Floats


def segment_depth(start: Floats, end: Floats, half_length: float, half_width: float) -> Floats:
    """How deep (N,) [m] the deepest point of each segment lies inside; `start` and `end` are (N, 2) [m].

    A segment that misses the rectangle gives a value below 0 that is not its distance.
    """
    x, y = start[:, 0], start[:, 1]
    dx, dy = (end - start).T
    zero, excess = np.zeros_like(x), half_length - half_width
    numerators = [zero, dx, -x, -y]
    denominators = [np.ones_like(x), dx, dx, dy]
    for sign_x, sign_y in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        numerators.append(excess - sign_x * x + sign_y * y)
        denominators.append(sign_x * dx - sign_y * dy)
    top, below = np.stack(numerators), np.stack(denominators)
    share = np.divide(top, below, out=np.zeros_like(top), where=below != 0.0).clip(0.0, 1.0)
    depth = np.minimum(half_length - np.abs(x + share * dx), half_width - np.abs(y + share * dy))
    return np.asarray(depth.max(axis=0), dtype=float)


def rectangle_to_disc(centre: Floats, radius: float, half_length: float, half_width: float) -> Floats:
    """Distance (N,) [m] to discs about `centre` (N, 2) [m], or minus the depth of their deepest point inside.

    The depth t is where the rectangle, each side moved inwards by t, only just touches the disc; at most the
    smaller half side.
    """
    a, b = _sorted_pair(np.abs(centre[:, 0]) - half_length, np.abs(centre[:, 1]) - half_width)
    apart = np.hypot(a.clip(0.0), b.clip(0.0)) - radius
    side = radius - a
    corner = (np.sqrt((2.0 * radius**2 - (a - b) ** 2).clip(0.0)) - a - b) / 2.0
    depth = np.where(b + side <= 0.0, side, corner).clip(0.0, min(half_length, half_width))
    return np.where(apart >= 0.0, apart, -depth)


def rectangle_to_outside(centre: Floats, radius: float, half_length: float, half_width: float) -> Floats:
    """Distance (N,) [m] to all outside of discs about `centre` (N, 2) [m], or minus how deep it reaches in.

    Only the farthest corner counts; the depth t is where, each side moved inwards by t, it comes to lie on
    the circle.
    """
    a, b = np.abs(centre[:, 0]) + half_length, np.abs(centre[:, 1]) + half_width
    apart = radius - np.hypot(a, b)
    most = min(half_length, half_width)
    square = 2.0 * radius**2 - (a - b) ** 2
    depth = np.where(square >= 0.0, (a + b - np.sqrt(square.clip(0.0))) / 2.0, most).clip(0.0, most)
    return np.where(apart >= 0.0, apart, -depth)


def _sorted_pair(a: Floats, b: Floats) -> tuple[Floats, Floats]:
    return np.maximum(a, b), np.minimum(a, b)
