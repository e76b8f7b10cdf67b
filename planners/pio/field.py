"""Distances to all that is forbidden, on a grid: what a swarm asks millions of times."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from planners.clearance import clearance
from planners.footprint import Disc
from planners.kernel import Floats
from planners.map import Map

NODES = 25_000  # of the grid; on a map of 300 units they are 1.9 units apart, and a hazard's edge is within 0.05 units


@dataclass(frozen=True, slots=True, eq=False)
class Field:
    """Signed distances `room` (rows, cols) at nodes `cell` apart, the first at (`x`, `y`)."""

    room: Floats
    cell: float
    x: float
    y: float


def field_of(area: Map, box: tuple[float, float, float, float]) -> Field:
    """The distance field over `box` (x_min, y_min, x_max, y_max)."""
    x_min, y_min, x_max, y_max = box
    cell = math.sqrt((x_max - x_min) * (y_max - y_min) / NODES)
    x = x_min + cell * np.arange(math.ceil((x_max - x_min) / cell) + 1)
    y = y_min + cell * np.arange(math.ceil((y_max - y_min) / cell) + 1)
    at = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    room = clearance(area, np.column_stack([at, np.zeros(len(at))]), Disc(0.0))
    farthest = math.hypot(x_max - x_min, y_max - y_min)
    return Field(np.minimum(room, farthest).reshape(len(y), len(x)), cell, x_min, y_min)
