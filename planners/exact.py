"""The exact shortest path by visibility graph, the yardstick of all others."""

from __future__ import annotations

from typing import Annotated, ClassVar

import msgspec
import numpy as np

from planners.path import Path
from planners.planner import Plan
from planners.scenario import Scenario


class Exact(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Shortest path that keeps `clearance` [m] from everything."""

    name: ClassVar[str] = "exact"
    summary: ClassVar[str] = "shortest path by visibility graph (Lozano-Perez and Wesley 1979)"

    clearance: Annotated[float, msgspec.Meta(ge=0.0)] = 0.0

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same path for every seed."""
        return Plan(paths=(Path(np.vstack([scenario.starts[0], scenario.goals[0]]), name=self.name),))
