"""What a map shows of a view from near: where it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from reports.figures.extent import Extent
from reports.figures.style import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SMALLEST, _LARGEST = 0.03, 0.6  # of the map's width
_CORNER = 0.22  # of the smaller side


def draw_frame(axes: Axes, near: Extent, colour: str = INK) -> None:
    """Mark on the map what is shown from near, unless it is most of it: by its corners, as no edge of a map is."""
    low, high = axes.get_xlim()
    if near.width > _LARGEST * (high - low):
        return
    seen = near.grown(max(0.0, _SMALLEST * (high - low) - near.width) / 2)
    # What lies beyond the map is not shown from near only: its frame ends where the map does.
    x, y = np.clip((seen.x_min, seen.x_max), low, high), np.clip((seen.y_min, seen.y_max), *axes.get_ylim())
    reach = _CORNER * min(seen.width, seen.height)
    for i, across in ((0, reach), (1, -reach)):
        for j, up in ((0, reach), (1, -reach)):
            corner = (x[i] + across, x[i], x[i]), (y[j], y[j], y[j] + up)
            axes.plot(*corner, color=colour, linewidth=1.1, solid_capstyle="butt", zorder=6, label="_frame")
