"""The signed distance of a footprint to everything a map forbids."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from planners.distance import rectangle_to_disc, rectangle_to_outside, segment_depth
from planners.errors import InputError
from planners.footprint import Footprint, Rectangle
from planners.kernel import Floats
from planners.map import Map, Raster
from planners.outline import Border, Outline, outline

CHUNK = 1024  # poses at once: a rectangle among small cells meets hundreds of edges, and each pair takes memory


def clearance(area: Map, poses: Floats, footprint: Footprint) -> Floats:
    """Signed distance (N,) [m] of the footprint at `poses` (N, 3) to all that is forbidden.

    A pose is x, y [m] and heading [rad]. Positive: the distance to the nearest obstacle, keep-in border
    or closed edge, which the footprint clears. Negative: how deep the deepest forbidden point lies inside
    the footprint. That is at most its inradius (the radius, or half the smaller side), reached once the
    forbidden area covers its centre; from there the centre's own depth in the forbidden area is added. So
    for a disc it is the signed distance of the centre minus the radius. Each obstacle counts by itself,
    the blocked cells of the raster together as one, and the worst decides. An open edge counts as the
    signed distance of the reference point.

    Exact for polygons, circles and cells, but for rounding. Inf where nothing is forbidden, NaN for a
    pose that is not finite. Raises `InputError` for an array of another shape.
    """
    poses = np.asarray(poses, dtype=float)
    if poses.ndim != 2 or poses.shape[1] != 3:
        raise InputError("poses", f"rows of x, y, heading are needed, not an array of shape {poses.shape}")
    worst = np.full(len(poses), np.nan)
    finite = np.flatnonzero(np.isfinite(poses).all(axis=1))
    for start in range(0, len(finite), CHUNK):
        rows = finite[start : start + CHUNK]
        worst[rows] = _clearance(area, poses[rows], footprint)
    return worst


def _clearance(area: Map, poses: Floats, footprint: Footprint) -> Floats:
    lines = outline(area)
    forward = np.column_stack([np.cos(poses[:, 2]), np.sin(poses[:, 2])])
    # A disc is a rectangle without extent inside a rim.
    if isinstance(footprint, Rectangle):
        half, rim, ahead = (footprint.length / 2.0, footprint.width / 2.0), 0.0, footprint.ahead
    else:
        half, rim, ahead = (0.0, 0.0), footprint.radius, 0.0
    centre = poses[:, :2] + ahead * forward
    worst = np.full(len(poses), np.inf)
    for border in (lines.border, lines.raster_border):
        if border is not None:
            np.minimum(worst, _to_border(border, centre, forward, half), out=worst)
    for circle in area.circles:
        at = _into(np.array([circle.x, circle.y]) - centre, forward)
        np.minimum(worst, rectangle_to_disc(at, circle.radius, *half), out=worst)
    for circle in area.keep_in_circles:
        at = _into(np.array([circle.x, circle.y]) - centre, forward)
        np.minimum(worst, rectangle_to_outside(at, circle.radius, *half), out=worst)
    lost = _depth_of_points(area, lines, centre)
    worst = np.where(lost >= 0.0, -min(half) - lost, worst) - rim
    if area.bounds is not None and area.edge == "open":
        np.minimum(worst, _inside_box(poses[:, :2], area.bounds), out=worst)
    return worst


def _to_border(border: Border, centre: Floats, forward: Floats, half: tuple[float, float]) -> Floats:
    """Distance (N,) [m] to the nearest segment, or minus the depth of the deepest one."""
    bodies = _bodies(centre, forward, half)
    distance = np.asarray(border.tree.query_nearest(bodies, return_distance=True, all_matches=False)[1])
    met = np.flatnonzero(distance == 0.0)
    if min(half) == 0.0 or not len(met):
        return distance
    pose, segment = border.tree.query(bodies[met], predicate="intersects")
    pose = met[pose]
    start, end = (_into(border.ends[segment, i] - centre[pose], forward[pose]) for i in (0, 1))
    np.minimum.at(distance, pose, -segment_depth(start, end, *half))
    return distance


def _depth_of_points(area: Map, lines: Outline, points: Floats) -> Floats:
    """How deep (N,) [m] each point lies in what is forbidden; -1 where it is free.

    Of several obstacles that cover a point, the one it is deepest in counts.
    """
    depth = np.full(len(points), -1.0)
    at = shapely.points(points)
    point, polygon = lines.obstacles.query(at, predicate="within")
    np.maximum.at(depth, point, shapely.distance(at[point], shapely.boundary(lines.obstacles.geometries[polygon])))
    for polygon in lines.keep_in:
        out = np.flatnonzero(~shapely.intersects_xy(polygon, points))
        np.maximum.at(depth, out, shapely.distance(at[out], polygon))
    for circle in area.circles:
        inside = circle.radius - np.hypot(*(points - (circle.x, circle.y)).T)
        depth = np.where(inside > 0.0, np.maximum(depth, inside), depth)
    for circle in area.keep_in_circles:
        outside = np.hypot(*(points - (circle.x, circle.y)).T) - circle.radius
        depth = np.where(outside > 0.0, np.maximum(depth, outside), depth)
    if area.raster is not None and lines.raster_border is not None:
        covered = np.flatnonzero(_covered(area.raster, points))
        far = lines.raster_border.tree.query_nearest(at[covered], return_distance=True, all_matches=False)[1]
        depth[covered] = np.maximum(depth[covered], far)
    return depth


def _covered(raster: Raster, points: Floats) -> Any:
    """Whether each of `points` (N, 2) lies in a blocked cell."""
    column, row = np.floor((points - (raster.x, raster.y)) / raster.cell).T
    rows, columns = raster.blocked.shape
    on = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
    on[on] = raster.blocked[row[on].astype(int), column[on].astype(int)]
    return on


def _bodies(centre: Floats, forward: Floats, half: tuple[float, float]) -> Any:
    """The rectangles as polygons, or points where they have no extent."""
    if min(half) == 0.0:
        return shapely.points(centre)
    along, across = half[0] * forward, half[1] * np.column_stack([-forward[:, 1], forward[:, 0]])
    corners = [centre + i * along + j * across for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    return shapely.polygons(np.stack(corners, axis=1))


def _into(offset: Floats, forward: Floats) -> Floats:
    """`offset` (N, 2) from the rectangles' centres, turned into their frames, x along `forward` (N, 2)."""
    x = offset[:, 0] * forward[:, 0] + offset[:, 1] * forward[:, 1]
    y = offset[:, 1] * forward[:, 0] - offset[:, 0] * forward[:, 1]
    return np.column_stack([x, y])


def _inside_box(points: Floats, bounds: tuple[float, float, float, float]) -> Floats:
    """Distance (N,) [m] to the border of the box, negative outside."""
    over = np.maximum(np.array(bounds[:2]) - points, points - np.array(bounds[2:]))
    inside = np.minimum(over.max(axis=1), 0.0)
    return -np.asarray(np.hypot(*over.clip(0.0).T) + inside, dtype=float)
