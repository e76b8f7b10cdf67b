"""What grid planners search on: a scenario as cells, seen from its start and its goal."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from scipy.ndimage import label

from planners.errors import InputError
from planners.inflate import inflated
from planners.kernel import Bools, Floats
from planners.map import Map
from planners.occupancy import Grid, extent, occupancy
from planners.path import Path
from planners.planner import NO_PATH, Plan, only_pair
from planners.scenario import Scenario

MOST_CELLS = 50_000_000
PIXELS = 512  # on the larger side of a map that is no picture: as many as paper 004's maps have
HALVINGS = 6  # of a cell, at most, until obstacles cover enough of their cells


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Blocked cells (rows, cols) of side `cell` [m]; `start` and `goal` (2,) are column and row, with fractions.

    The corner of all cells is at `origin` (2,) [m].
    """

    blocked: Bools
    cell: float
    origin: Floats
    start: Floats
    goal: Floats

    def to_metres(self, points: Floats) -> Floats:
        """Points (N, 2) in cells as x, y [m]."""
        return self.origin + points * self.cell

    @property
    def connected(self) -> bool:
        """Whether start and goal lie in one area of free cells that share sides: a flood fill."""
        areas, _ = label(~self.blocked)
        start, goal = (areas[int(y), int(x)] for x, y in (self.start, self.goal))
        return bool(start == goal)


def ground_of(scenario: Scenario, planner: str, cell: float, clearance: float) -> Ground:
    """The scenario in cells of `cell` [m], blocked where they share an area with what is nearer than `clearance` [m]
    to anything forbidden.

    Raises `InputError` for a start or goal in a blocked cell, and for a grid beyond all memory.
    """
    start, goal = only_pair(scenario, planner)
    grid = grid_of(scenario, inflated(scenario.map, clearance), cell)
    origin = np.array([grid.x, grid.y])
    rows, columns = grid.blocked.shape
    places = []
    for name, place in (("start", start), ("goal", goal)):
        # A place on the map's upper edge belongs to the last cell
        at = np.minimum((place - origin) / cell, np.nextafter([columns, rows], 0.0))
        if grid.blocked[int(at[1]), int(at[0])]:
            what = f"({place[0]:g}, {place[1]:g}) m lies in a cell of {cell:g} m that is not {clearance:g} m clear"
            raise InputError(f"{scenario.name}: {name}", what, "move it, or give smaller cells or less clearance")
        places.append(at)
    return Ground(grid.blocked, cell, origin, *places)


def grid_of(scenario: Scenario, area: Map, cell: float) -> Grid:
    """The cells of `cell` [m] over the whole of the scenario; `area` is its map, or that map inflated.

    Raises `InputError` for a grid beyond all memory.
    """
    width, height = scenario.size
    if width * height > MOST_CELLS * cell**2:
        what = f"cells of {cell:g} m make a grid of more than {MOST_CELLS / 1e6:g} million"
        raise InputError(scenario.name, what, "give larger cells")
    return occupancy(area, cell, (0.0, 0.0, width, height))


def without_path(clearance: float) -> Plan:
    """The answer where a flood fill does not reach the goal."""
    what = f"no free cells lead from the start to the goal with {clearance:g} m of clearance"
    return Plan(outcome=NO_PATH, reason=what)


def path_of(points: Floats, scenario: Scenario, name: str) -> Path:
    """The line (N, 2) [m] as a path from the very start to the very goal of the scenario."""
    apart = np.concatenate([[True], (np.diff(points, axis=0) != 0.0).any(axis=1)])
    points = points[apart]
    points[0], points[-1] = scenario.starts[0], scenario.goals[0]
    return Path(points, name=name, frame=scenario.map.frame)


def pixel(scenario: Scenario, cell: float | None) -> float:
    """The side [m] of `cell` [map units]; None for that of the map's picture, or 1/`PIXELS` of its larger side."""
    if cell is not None:
        return cell * scenario.unit
    raster = scenario.map.raster
    return max(scenario.size) / PIXELS if raster is None else raster.cell


def cover_ratio(area: Map, cell: float) -> float:
    """The least share of the cells that an obstacle blocks which it covers (paper 000, eq. 5), over all obstacles.

    Eq. 5 takes the minimum over cells, which tends to 0 for any obstacle that is not made of cells, whatever their
    size: a corner may cut off next to nothing. So here each obstacle counts as a whole.
    """
    ratios = []
    for ring in area.polygons:
        one = Map(polygons=(ring,))
        ratios.append(shapely.Polygon(ring).area / _blocked_area(one, cell))
    for circle in area.circles:
        ratios.append(math.pi * circle.radius**2 / _blocked_area(Map(circles=(circle,)), cell))
    return min(ratios, default=1.0)


def _blocked_area(one: Map, cell: float) -> float:
    x_min, y_min, x_max, y_max = extent(one)
    # Cells lie on a grid through the map's corner, wherever the obstacle is
    bounds = (math.floor(x_min / cell) * cell, math.floor(y_min / cell) * cell, x_max, y_max)
    return float(occupancy(one, cell, bounds).blocked.sum()) * cell**2


def cell_for_cover(area: Map, least: float, largest: float) -> float:
    """The largest cell [m], from `largest` down by halves, whose `cover_ratio` exceeds `least` (paper 000, eq. 5)."""
    cell = largest
    for _ in range(HALVINGS):
        if cover_ratio(area, cell) > least:
            return cell
        cell /= 2.0
    what = f"even in cells of {2.0 * cell:g} m an obstacle covers no more than that of those it blocks"
    raise InputError(f"cover: {least:g}", what, "give a smaller ratio")
