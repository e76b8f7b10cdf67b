"""What a path needs over its length: a line, or where it swings faster than a line can show, the area of that."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from planners.kernel import Bools, Floats
from reports.figures.style import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SPANS = 100  # along the path
_SWINGS = 3  # turns up or down in a span from which on they are an area


def draw_needed(axes: Axes, s: Floats, needed: Floats) -> None:
    """Draw `needed` (N,) at the arc lengths `s` (N,) [m]."""
    edges = np.linspace(s[0], s[-1], _SPANS + 1)
    swings = np.histogram(s[_turning(needed)], edges)[0] >= _SWINGS
    span = np.clip(np.searchsorted(edges, s, "right") - 1, 0, _SPANS - 1)
    line = np.where(swings[span], np.nan, needed)
    axes.plot(s, line, color=INK, alpha=0.6, linewidth=0.8, label="needed", zorder=3.2)
    for i in np.flatnonzero(swings):
        within = needed[span == i]
        x = [edges[i], edges[i + 1]]
        axes.fill_between(x, within.min(), within.max(), color=INK, alpha=0.3, linewidth=0, zorder=2.6)


def _turning(values: Floats) -> Bools:
    """Where (N,) `values` turn from up to down or back; a flat stretch counts at its end."""
    step = np.sign(np.diff(values))
    last = np.maximum.accumulate(np.where(step != 0.0, np.arange(len(step)), 0))
    way = step[last] if len(step) else step
    turns = np.zeros(len(values), dtype=bool)
    turns[1:-1] = way[1:] * way[:-1] < 0.0
    return turns
