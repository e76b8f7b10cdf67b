"""The points whose Voronoi diagram is the roadmap."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from planners.kernel import Floats
from planners.map import Map

OUTLINE_POINTS = 400  # about as many stand for all outlines together
LARGEST_RATIO = 2.0  # of the radii of circles whose centres alone stand for them


def sites_of(area: Map, free: Any, box: tuple[float, float, float, float]) -> Floats:
    """Points (N, 2) that stand for all that is forbidden inside of `box` (x_min, y_min, x_max, y_max).

    They are the centres of the hazards, as in paper 001, section 1.1, where all are circles of about one size: halfway
    between two centres is then halfway between the circles. Otherwise they lie along the outlines of the `free` space.
    """
    radii = [circle.radius for circle in area.circles]
    only_circles = not (area.polygons or area.keep_in or area.keep_in_circles or area.raster is not None)
    if only_circles and max(radii, default=0.0) <= LARGEST_RATIO * min(radii, default=0.0):
        points = np.array([[circle.x, circle.y] for circle in area.circles]).reshape(-1, 2)
    else:
        border = shapely.boundary(free)
        apart = shapely.length(border) / OUTLINE_POINTS
        points = shapely.get_coordinates(shapely.segmentize(shapely.simplify(border, apart / 4.0), apart))
    x_min, y_min, x_max, y_max = box
    edge = 1e-6 * max(x_max - x_min, y_max - y_min)
    x, y = points.T
    inside = (x > x_min + edge) & (x < x_max - edge) & (y > y_min + edge) & (y < y_max - edge)
    return np.unique(points[inside], axis=0)


def mirrored(points: Floats, box: tuple[float, float, float, float]) -> Floats:
    """The points and their images in the four sides of `box` (5N, 2): so the cells of the points end at its sides."""
    x_min, y_min, x_max, y_max = box
    images = [points]
    for axis, side in ((0, x_min), (0, x_max), (1, y_min), (1, y_max)):
        image = points.copy()
        image[:, axis] = 2.0 * side - image[:, axis]
        images.append(image)
    return np.concatenate(images)
