"""How a path among the centres of cells begins at the very start and ends at the very goal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planners.errors import InputError
from planners.fleet import fleet_ends
from planners.kernel import Floats
from planners.map import Map
from planners.occupancy import Grid, occupancy
from planners.scenario import Scenario
from planners.segments import is_free

FINE = 32  # parts of a cell's side, by which a way to the cell beside it is looked for
NEAR = 1e-9  # [cells] as good as in the same place


@dataclass(frozen=True, slots=True, eq=False)
class Access:
    """A start or goal: its `place` (2,) and the `centre` (2,) of the cell the path is bound to [cells].

    That is the cell it lies in, or a free one `beside` it.
    """

    place: Floats
    centre: Floats
    beside: bool


def accesses(scenario: Scenario, area: Map, grid: Grid, clearance: float, planner: str) -> tuple[Access, Access]:
    """Those of the start and the goal; `area` is the scenario's map inflated by `clearance` [m].

    Raises `InputError` for a place that is not free, or in a blocked cell with no free one beside it in reach.
    """
    places = [(ends[0] - (grid.x, grid.y)) / grid.cell for ends in (scenario.starts, scenario.goals)]
    rows, columns = grid.blocked.shape
    # A place on the map's upper edge belongs to the last cell
    cells = [np.minimum(np.floor(place), (columns - 1, rows - 1)) for place in places]
    if any(grid.blocked[int(row), int(column)] for column, row in cells):
        fleet_ends(scenario, clearance, planner)
    found = []
    for name, place, cell in zip(("start", "goal"), places, cells, strict=True):
        at = cell if not grid.blocked[int(cell[1]), int(cell[0])] else _beside(area, grid, place, cell)
        if at is None:
            what = f"its cell of {grid.cell:g} m is blocked, and no free one beside it can be reached straight"
            raise InputError(f"{scenario.name}: {name}", what, "move it, or give smaller cells or less clearance")
        found.append(Access(place, at + 0.5, at is not cell))
    return found[0], found[1]


def joined(way: Floats, start: Access, goal: Access) -> Floats:
    """The way (N, 2) through centres of cells, led from `start` to `goal` [cells]."""
    inner = np.vstack([_lead(start, way), way[1:-1], _lead(goal, way[::-1])])
    steps = np.diff(np.vstack([start.place, inner]), axis=0)
    new = (np.abs(steps).max(axis=1) > NEAR) & (np.abs(inner - goal.place).max(axis=1) > NEAR)
    return np.vstack([start.place, inner[new], goal.place])


def _lead(end: Access, way: Floats) -> Floats:
    """What joins `end` to the way that begins at its cell (N, 2): the foot of the perpendicular to the first leg.

    The foot is in the same cell, so that nothing is in between and the path never turns back on itself. From another
    cell it joins at the centre; where the way is but one cell, it takes none.
    """
    if end.beside:
        return way[:1]
    if len(way) == 1:
        return np.empty((0, 2))
    along = np.sign(way[1] - way[0])
    return np.atleast_2d(way[0] + (end.place - way[0]) @ along / (along @ along) * along)


def _beside(area: Map, grid: Grid, place: Floats, cell: Floats) -> Floats | None:
    """The free cell around `cell`, column and row, whose centre is nearest to `place` of those that it sees."""
    corner = np.array([grid.x, grid.y]) + (cell - 1.0) * grid.cell
    fine = occupancy(area, grid.cell / FINE, (*corner, *(corner + 3.0 * grid.cell)))
    around = cell + np.argwhere(np.ones((3, 3))) - 1.0
    x, y = (FINE * (place - cell + 1.0)).tolist()
    for near in around[np.argsort(np.hypot(*(around + 0.5 - place).T), kind="stable")]:
        column, row = near.astype(int)
        on_grid = 0 <= row < grid.blocked.shape[0] and 0 <= column < grid.blocked.shape[1]
        if on_grid and not grid.blocked[row, column]:
            to_x, to_y = (FINE * (near - cell + 1.5)).tolist()
            if is_free(fine.blocked, x, y, to_x, to_y):
                return np.asarray(near, dtype=float)
    return None
