"""Obstacles, fences and the edge of a map, as the map panels draw them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import ListedColormap
from shapely import Point, Polygon, box, make_valid

from planners.map import Circle, Map
from reports.figures.shapes import fill, stroke
from reports.figures.style import FENCE, FENCE_DASHES, MUTED, OBSTACLE, OBSTACLE_EDGE, Look

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ROUND = 48  # segments in a quarter of a circle


def draw_obstacles(axes: Axes, area: Map, window: Polygon, colour: str = OBSTACLE) -> None:
    """Draw the part of `area` in `window` [m], what is forbidden in that `colour`."""
    _raster(axes, area, colour)
    solid: Look = {"facecolor": colour, "edgecolor": OBSTACLE_EDGE, "linewidth": 0.8, "zorder": 2.0}
    for shape in (*map(Polygon, area.polygons), *map(_disc, area.circles)):
        fill(axes, make_valid(shape).intersection(window), solid)
    fence: Look = {"color": FENCE, "linewidth": 1.4, "linestyle": FENCE_DASHES, "zorder": 2.2}
    for shape in (*map(Polygon, area.keep_in), *map(_disc, area.keep_in_circles)):
        stroke(axes, shape.exterior.intersection(window), fence)
    if area.bounds is not None:
        edge = box(*area.bounds).exterior.intersection(window)
        stroke(axes, edge, {"color": MUTED, "linewidth": 1.2, "zorder": 2.1})


def _raster(axes: Axes, area: Map, colour: str) -> None:
    raster = area.raster
    if raster is None:
        return
    rows, columns = raster.blocked.shape
    limits = axes.get_xlim(), axes.get_ylim()  # imshow would widen them
    axes.imshow(
        np.ma.masked_equal(raster.blocked, False),
        extent=(raster.x, raster.x + columns * raster.cell, raster.y, raster.y + rows * raster.cell),
        origin="lower",
        cmap=ListedColormap([colour]),
        interpolation="nearest",
        zorder=1.9,
    )
    axes.set(xlim=limits[0], ylim=limits[1])


def _disc(circle: Circle) -> Polygon:
    return Point(circle.x, circle.y).buffer(circle.radius, quad_segs=_ROUND)
