"""The vehicle's footprint, drawn to scale where it stood."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Polygon

from planners.footprint import Disc
from planners.kernel import Floats
from reports.figures.style import INK
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_body(axes: Axes, outcome: Outcome, index: int | None) -> None:
    """Outline the body at the track's sample `index`; nothing where there is none or its pose is not finite."""
    if index is None:
        return
    x, y, heading = (float(outcome.track[column][index]) for column in ("x", "y", "heading"))
    if math.isfinite(x + y + heading):
        corners = outline(outcome, x, y, heading)
        axes.add_patch(Polygon(corners, closed=True, facecolor="none", edgecolor=INK, linewidth=1.0, zorder=5))


def outline(outcome: Outcome, x: float, y: float, heading: float) -> Floats:
    """The footprint's outline (M, 2) [m] with the reference point at (`x`, `y`) and facing `heading` [rad]."""
    body = outcome.limits.footprint
    if isinstance(body, Disc):
        angles = np.linspace(0.0, 2.0 * math.pi, 48, endpoint=False)
        local = body.radius * np.column_stack([np.cos(angles), np.sin(angles)])
    else:
        half = np.array([body.length, body.width]) / 2
        local = half * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) + np.array([body.ahead, 0.0])
    along = np.array([[math.cos(heading), math.sin(heading)], [-math.sin(heading), math.cos(heading)]])
    turned: Floats = local @ along + np.array([x, y])
    return turned
