"""Fewer points that look the same: what a figure of a long track needs so that its file stays small."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from planners.kernel import Floats, Ints

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def bins_of(axes: Axes) -> int:
    """As many spans of samples as `axes` are wide, two pixels each."""
    return max(1, round(axes.bbox.width / 2))


def envelope(x: Floats, y: Floats, bins: int) -> Ints:
    """Indices that keep the smallest and the largest `y` (N,) in each of `bins` equal spans of the samples, and gaps.

    A line through them covers the same pixels as one through all samples where a bin is no wider than a
    pixel.
    """
    count = len(x)
    if count <= 2 * bins:
        return np.arange(count)
    edges = np.linspace(0, count, bins + 1).astype(np.int64)[:-1]
    bad = ~np.isfinite(x) | ~np.isfinite(y)
    owner = np.repeat(np.arange(bins), np.diff([*edges, count]))
    kept = [np.array([0, count - 1]), edges[np.logical_or.reduceat(bad, edges)]]
    for sign in (1.0, -1.0):
        order = np.lexsort((np.where(bad, np.inf, sign * y), owner))
        kept.append(order[edges])
    return np.unique(np.concatenate(kept))


def polyline(xy: Floats, tolerance: float, most: int) -> Ints:
    """Indices that keep a line (N, 2) of finite points within `tolerance`, and about `most` points along it besides."""
    if len(xy) <= 2:
        return np.arange(len(xy))
    line = np.column_stack([xy, np.arange(len(xy))])
    # The index rides along as z, which GEOS carries through and does not measure.
    bends = shapely.get_coordinates(shapely.simplify(shapely.LineString(line), tolerance), include_z=True)[:, 2]
    stride = max(1, len(xy) // most)
    return np.unique(np.concatenate([bends.astype(np.int64), np.arange(0, len(xy), stride), [len(xy) - 1]]))
