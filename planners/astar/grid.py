"""A* on a grid, in four or eight directions: the planners that paper 004 measures its own against."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import msgspec
import numpy as np

from planners.astar.ends import accesses, joined
from planners.astar.grid_kernels import DIAGONAL, SIDE, corners, search
from planners.ground import grid_of, pixel
from planners.inflate import inflated
from planners.kernel import Bools, Floats
from planners.path import Path
from planners.planner import NO_PATH, NOT_FOUND, Plan, only_pair
from planners.scenario import Scenario

Length = Annotated[float, msgspec.Meta(gt=0.0, le=1e9)]
Count = Annotated[int, msgspec.Meta(ge=1, le=100_000)]


class GridSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What A* on a grid is told.

    cell: side of a cell [map units]; by default the raster's, or a 512th of the map's longer side.
    cells: how many along the map's longer side instead, as paper 004's 30.
    clearance: [m] kept from obstacles; the paper's vehicle is a point.
    """

    cell: Length | None = None
    cells: Count | None = None
    clearance: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] = 0.0

    def __post_init__(self) -> None:
        if self.cell is not None and self.cells is not None:
            raise ValueError("cell and cells say the same thing: give one of them")

    def cell_on(self, scenario: Scenario) -> float:
        """The side of a cell [m] on that map."""
        if self.cells is not None:
            return max(scenario.size) / self.cells
        return pixel(scenario, self.cell)


class AstarFour(GridSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Shortest path along the rows and columns of a grid (paper 004, Figs. 9 and 11a)."""

    name: ClassVar[str] = "astar-four"
    summary: ClassVar[str] = "A* on a grid in four directions, the classic that paper 004 compares with"

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same path for every seed; see `grid_plan`."""
        return grid_plan(scenario, self, self.name, directions=4, diagonal=2 * SIDE, cutting=False)


class AstarEight(GridSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Shortest path along rows, columns and diagonals of a grid.

    cut_corners: whether a diagonal step may pass a blocked cell beside it, or even between two.
    """

    name: ClassVar[str] = "astar-eight"
    summary: ClassVar[str] = "A* on a grid in eight directions"

    cut_corners: bool = False

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same path for every seed; see `grid_plan`."""
        return grid_plan(scenario, self, self.name, directions=8, diagonal=DIAGONAL, cutting=self.cut_corners)


def grid_plan(
    scenario: Scenario, settings: GridSettings, name: str, *, directions: int, diagonal: int, cutting: bool
) -> Plan:
    """The shortest path through centres of free cells, with a vertex wherever it turns.

    Cells are blocked where they share an area with what is nearer than the clearance to anything forbidden. From the
    start the path goes square to the first step's line, and along that; to the goal as well, so that no leg leaves the
    grid's directions. A start or goal in one cell with the other is joined to it by a straight line; one in a blocked
    cell to the nearest free one beside it. Raises `InputError` where that cannot be, and for a start or goal that is
    not free.
    """
    only_pair(scenario, name)
    area = inflated(scenario.map, settings.clearance)
    grid = grid_of(scenario, area, settings.cell_on(scenario))
    start, goal = accesses(scenario, area, grid, settings.clearance, name)
    way = shortest_way(grid.blocked, start.centre, goal.centre, directions, diagonal, cutting)
    if way is None:
        return Plan(outcome=NO_PATH, reason=f"no free cells of {grid.cell:g} m lead from start to goal")
    points = (grid.x, grid.y) + grid.cell * joined(way, start, goal)
    points[0], points[-1] = scenario.starts[0], scenario.goals[0]
    path = Path(points, name=scenario.name, frame=scenario.map.frame)
    if path.length > (scenario.max_range or math.inf):
        reason = f"the shortest path on the grid has {path.length:.6g} m, the range is {scenario.max_range:.6g} m"
        return Plan(outcome=NOT_FOUND, reason=reason)
    beside = [which for which, end in (("start", start), ("goal", goal)) if end.beside]
    notes = tuple(f"the cell of the {which} is blocked: the path is bound to the one beside it" for which in beside)
    return Plan(paths=(path,), smallest_radius=math.inf if len(points) == 2 else None, notes=notes)


def shortest_way(
    blocked: Bools, start: Floats, goal: Floats, directions: int, diagonal: int, cutting: bool
) -> Floats | None:
    """The centres of cells (N, 2) where the shortest way turns, `start` and `goal` (2,) included, if there is one."""
    rows, columns = blocked.shape[0] + 2, blocked.shape[1] + 2
    cells = np.ones((rows, columns), dtype=np.uint8)
    cells[1:-1, 1:-1] = blocked
    cells = cells.ravel()
    first, last = (int(row + 1.0) * columns + int(column + 1.0) for column, row in (start, goal))
    if first != last:
        lengths, links = np.empty(len(cells), dtype=np.int64), np.empty((len(cells), 2), dtype=np.int32)
        if search(cells, lengths, links, columns, first, last, directions, diagonal, cutting) < 0:
            return None
    row, column = np.divmod(corners(cells, columns, first, last)[::-1], columns)
    return np.column_stack([column - 0.5, row - 0.5])
