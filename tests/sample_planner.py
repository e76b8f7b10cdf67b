"""A planner for tests that plans for a speed: a wide arc, whose radius a vehicle needs at that speed."""

import math
from typing import ClassVar

import numpy as np

from planners.astar.settings import SpeedSettings
from planners.path import Path
from planners.planner import NO_PATH, Plan

SCENARIO = 'name = "bend"\nsize = [80.0, 80.0]\nstart = [10.0, 10.0]\ngoal = [60.0, 60.0]\n'
LATERAL = 4.0  # [m/s^2]


class SpeedArc(SpeedSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A right angle from start to goal with a radius of v^2 / `LATERAL`; no path above `most` [m/s]."""

    name: ClassVar[str] = "speed-arc"
    summary: ClassVar[str] = "for tests"

    most: float = 20.0
    clearance: float = 0.0

    def plan(self, scenario, rng):
        if self.planned_speed > self.most:
            return Plan(outcome=NO_PATH, reason="the bend is too narrow")
        (x, y), (to_x, to_y) = scenario.starts[0], scenario.goals[0]
        radius = self.planned_speed**2 / LATERAL
        turn = np.linspace(0.0, math.pi / 2, 200)
        arc = np.column_stack([to_x - radius * (1 - np.sin(turn)), y + radius * (1 - np.cos(turn))])
        return Plan(paths=(Path(np.vstack([[[x, y]], arc, [[to_x, to_y]]])),), smallest_radius=radius)
