"""Shapely's shapes on matplotlib's axes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline
from shapely import LineString, Polygon, get_parts
from shapely.geometry.base import BaseGeometry

from reports.figures.style import Look

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def fill(axes: Axes, shape: BaseGeometry, look: Look) -> None:
    """Fill every polygon of `shape`, holes left open."""
    for part in get_parts(shape):
        if isinstance(part, Polygon) and not part.is_empty:
            rings = [Outline(np.asarray(ring.coords), closed=True) for ring in (part.exterior, *part.interiors)]
            axes.add_patch(PathPatch(Outline.make_compound_path(*rings), **look))


def stroke(axes: Axes, line: BaseGeometry, look: Look) -> None:
    """Draw every line of `line`."""
    for part in get_parts(line):
        if isinstance(part, LineString) and not part.is_empty:
            x, y = np.asarray(part.coords)[:, :2].T
            axes.plot(x, y, **look)
