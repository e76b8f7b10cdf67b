"""How much room there is: a field of distances on a map's cells, and the discs that cover a vehicle's body."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from planners.astar.truck_settings import TruckSettings
from planners.ground import grid_of
from planners.kernel import Floats
from planners.occupancy import clearance_field
from planners.scenario import Scenario

HALF_DIAGONAL = math.sqrt(0.5)
DISCS = 7  # along the body: of the truck, their rims stand out by 8 % of its half-width


@dataclass(frozen=True, slots=True)
class Room:
    """`field` (rows, cols) [m]: how far each cell's centre is from all that is forbidden, less what that may err by.

    Cells have the side `cell` [m], the south-west corner of all is at `origin` (2,) [m]; `size` (2,) [m] is how far the
    reference point may go.
    """

    field: Floats
    cell: float
    origin: Floats
    size: Floats


@dataclass(frozen=True, slots=True)
class Body:
    """Discs of one `radius` [m], `along` (D,) [m] ahead of the reference point, that cover a rectangle.

    A disc of `around` [m] at `middle` [m] holds all of it.
    """

    along: Floats
    radius: float
    middle: float
    around: float


def room_of(scenario: Scenario, cell: float) -> Room:
    """The room on cells of `cell` [m]; raises `InputError` for a grid beyond all memory.

    An obstacle lies somewhere in its blocked cell, half a diagonal at most from the centre: less that, it is safe.
    """
    grid = grid_of(scenario, scenario.map, cell)
    field = clearance_field(grid, beyond=scenario.map.edge == "closed")
    field = np.minimum(field, math.hypot(*scenario.size)) - HALF_DIAGONAL * cell
    return Room(field, cell, np.array([grid.x, grid.y]), np.array(scenario.size))


def body_of(settings: TruckSettings) -> Body:
    """The discs that cover the vehicle's rectangle, each as long a piece of it."""
    piece, half = settings.length / DISCS, settings.width / 2.0
    along = np.array([(i + 0.5) * piece - settings.overhang for i in range(DISCS)])
    middle = settings.length / 2.0 - settings.overhang
    return Body(along, math.hypot(piece / 2.0, half), middle, math.hypot(settings.length / 2.0, half))
