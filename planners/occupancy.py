"""A map as cells: which are blocked, and how far each is from the nearest that is."""

from __future__ import annotations

import math

import numpy as np
from scipy.ndimage import distance_transform_edt

from planners.errors import InputError
from planners.kernel import Bools, Floats
from planners.map import Circle, Map, Raster
from planners.occupancy_kernels import SNAP, block_edges, block_inside

Grid = Raster  # an occupancy grid is a raster; only what it was made from differs


def occupancy(area: Map, cell: float, bounds: tuple[float, float, float, float] | None = None) -> Grid:
    """The cells of side `cell` [m] over `bounds` (by default the map's, else those of all it holds).

    A cell is blocked if it shares an area with an obstacle or is not wholly inside every keep-in area and the
    map's bounds, whichever edge they have; merely to touch does not block. This is exact for polygons,
    circles and cells of another raster, but for overlaps thinner than 1e-9 cells. Raises `InputError` for a
    cell size that is not positive and for a map without extent.
    """
    if not (np.isfinite(cell) and cell > 0.0):
        raise InputError("cell size", f"{cell} m is not possible", "give a size above 0")
    x_min, y_min, x_max, y_max = bounds or area.bounds or extent(area)
    columns = max(1, int(np.ceil((x_max - x_min) / cell - SNAP)))
    rows = max(1, int(np.ceil((y_max - y_min) / cell - SNAP)))
    blocked = np.zeros((rows, columns), dtype=bool)
    origin = np.array([x_min, y_min])
    for ring in area.polygons:
        ring = (ring - origin) / cell
        block_inside(blocked, ring)
        block_edges(blocked, ring)
    for ring in area.keep_in:
        ring, inside = (ring - origin) / cell, np.zeros_like(blocked)
        block_inside(inside, ring)
        blocked |= ~inside
        block_edges(blocked, ring)
    for circle in area.circles:
        _block_circle(blocked, circle, origin, cell)
    for circle in area.keep_in_circles:
        blocked |= _farthest(circle, origin, cell, rows, columns) > circle.radius / cell + SNAP
    if area.raster is not None:
        blocked |= _resampled(area.raster, origin, cell, rows, columns)
    if area.bounds is not None:
        left, south, right, north = (np.array(area.bounds) - np.tile(origin, 2)) / cell
        column, row = np.arange(columns), np.arange(rows)
        blocked |= (column < left - SNAP) | (column + 1 > right + SNAP)
        blocked |= ((row < south - SNAP) | (row + 1 > north + SNAP))[:, None]
    return Grid(blocked, cell, float(x_min), float(y_min))


def clearance_field(grid: Grid, beyond: bool = False) -> Floats:
    """Distance (rows, cols) [m] from each cell's centre to that of the nearest blocked cell.

    It differs from the exact distance of the centre to the obstacles by at most cell / sqrt(2): an obstacle
    lies somewhere in its blocked cell, half a diagonal at most from the centre. Less that bound, it is safe.
    With `beyond`, all cells outside of the grid count as blocked. Inf where nothing is. (Felzenszwalb and
    Huttenlocher 2012's exact Euclidean transform, by scipy.)
    """
    free = ~np.pad(grid.blocked, 1, constant_values=beyond)
    if free.all():
        return np.full(grid.blocked.shape, np.inf)
    return np.asarray(distance_transform_edt(free)[1:-1, 1:-1] * grid.cell, dtype=float)


def cell_centres(grid: Grid) -> Floats:
    """x, y [m] of the cells' centres (rows, cols, 2)."""
    rows, columns = grid.blocked.shape
    x = grid.x + (np.arange(columns) + 0.5) * grid.cell
    y = grid.y + (np.arange(rows) + 0.5) * grid.cell
    return np.stack(np.meshgrid(x, y), axis=-1)


def extent(area: Map) -> tuple[float, float, float, float]:
    """x_min, y_min, x_max, y_max [m] around all that a map holds.

    Raises `InputError` for a map that holds nothing.
    """
    boxes = [(*ring.min(axis=0), *ring.max(axis=0)) for ring in (*area.polygons, *area.keep_in)]
    for circle in (*area.circles, *area.keep_in_circles):
        x, y, r = circle.x, circle.y, circle.radius
        boxes.append((x - r, y - r, x + r, y + r))
    if area.raster is not None:
        rows, columns = np.array(area.raster.blocked.shape) * area.raster.cell
        boxes.append((area.raster.x, area.raster.y, area.raster.x + columns, area.raster.y + rows))
    if area.bounds is not None:
        boxes.append(area.bounds)
    if not boxes:
        raise InputError("map", "it holds nothing, so it has no extent", "give it bounds")
    low, high = np.min(boxes, axis=0)[:2], np.max(boxes, axis=0)[2:]
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def _block_circle(blocked: Bools, circle: Circle, origin: Floats, cell: float) -> None:
    """Block the cells whose nearest point lies in the circle; only those about it are looked at."""
    rows, columns = blocked.shape
    (x, y), radius = (np.array([circle.x, circle.y]) - origin) / cell, circle.radius / cell
    left, right = np.clip([math.floor(x - radius), math.ceil(x + radius)], 0, columns)
    south, north = np.clip([math.floor(y - radius), math.ceil(y + radius)], 0, rows)
    dx = (np.abs(np.arange(left, right) + 0.5 - x) - 0.5).clip(0.0)
    dy = (np.abs(np.arange(south, north) + 0.5 - y) - 0.5).clip(0.0)[:, None]
    blocked[south:north, left:right] |= dx * dx + dy * dy < max(radius - SNAP, 0.0) ** 2


def _farthest(circle: Circle, origin: Floats, cell: float, rows: int, columns: int) -> Floats:
    """Distances (rows, cols) of the circle's centre from each cell's farthest point, in cells."""
    x, y = (np.array([circle.x, circle.y]) - origin) / cell
    dx, dy = np.abs(np.arange(columns) + 0.5 - x), np.abs(np.arange(rows) + 0.5 - y)[:, None]
    return np.asarray(np.hypot(dx + 0.5, dy + 0.5))


def _resampled(raster: Raster, origin: Floats, cell: float, rows: int, columns: int) -> Bools:
    """Which cells share an area with a blocked cell of `raster`: a sum over a block of those is not 0."""
    if raster.cell == cell and (raster.x, raster.y) == tuple(origin) and raster.blocked.shape == (rows, columns):
        return raster.blocked
    sums = np.pad(np.cumsum(np.cumsum(raster.blocked, axis=0, dtype=np.int64), axis=1), ((1, 0), (1, 0)))
    spans = []
    for axis, count in ((1, columns), (0, rows)):
        offset = origin[1 - axis] - (raster.y if axis == 0 else raster.x)
        lines = (offset + np.arange(count + 1) * cell) / raster.cell
        first, past = np.floor(lines[:-1] + SNAP), np.ceil(lines[1:] - SNAP)
        spans.append([edge.clip(0, raster.blocked.shape[axis]).astype(int) for edge in (first, past)])
    (left, right), (south, north) = spans
    inside = (
        sums[np.ix_(north, right)] - sums[np.ix_(south, right)] - sums[np.ix_(north, left)] + sums[np.ix_(south, left)]
    )
    return np.asarray(inside > 0)
