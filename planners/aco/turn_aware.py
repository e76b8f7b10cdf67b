"""The future work of paper 000: ants that know the vehicle's turn radius while they search."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from planners.aco.colony import Found, search
from planners.aco.finish import not_found
from planners.aco.pheromone import Pheromone
from planners.aco.roulette_kernels import dice
from planners.aco.settings import Count, RingSettings
from planners.aco.turn_kernels import prune_turning, walk_turning
from planners.aco.walk_kernels import ring
from planners.ground import Ground, ground_of, path_of, without_path
from planners.kernel import Floats
from planners.occupancy import Grid, clearance_field
from planners.planner import NOT_FOUND, Plan
from planners.rounding import RESERVE, rounded
from planners.scenario import Scenario
from planners.segments import polyline_length


class AcoTurnAware(RingSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Turn-aware ant colony: the improved colony, whose ants take only turns that a vehicle with `turn_radius` can make
    clear of obstacles, and step only where from there another such turn leads on. Settings beside those of every
    colony with rings:

    step: cells from an ant to the ring it steps to; by default as many as the turn radius takes.
    """

    name: ClassVar[str] = "aco-turn-aware"
    summary: ClassVar[str] = "ant colony that keeps a turn radius while it searches (ours, after paper 000's outlook)"

    step: Count | None = None

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """Let the colony search; the best way of each iteration is rounded, and the shortest of these counts."""
        ground = ground_of(scenario, self.name, self.cell * scenario.unit, self.clearance)
        if not ground.connected:
            return without_path(self.clearance)
        found = self.search(ground, scenario, rng)
        if found.way is None:
            return not_found(found, f" keeping a turn radius of {self.turn_radius:g} m")
        lines = [rounded(ground, way, self.turn_radius, keep=True) for way in found.ways]
        kept = [(polyline_length(line.points), i) for i, line in enumerate(lines) if not line.tight]
        if not kept:
            what = f"none of the ways found keeps a turn radius of {self.turn_radius:g} m"
            return Plan(outcome=NOT_FOUND, reason=what, history=found.history)
        best = min(kept)[1]
        return Plan(
            paths=(path_of(lines[best].points, scenario, self.name),),
            polylines=(path_of(ground.to_metres(found.ways[best]), scenario, self.name),),
            smallest_radius=lines[best].smallest_radius,
            history=found.history,
        )

    def search(self, ground: Ground, scenario: Scenario, rng: np.random.Generator) -> Found:
        """The colony's ways through `ground`."""
        blocked, radius = ground.blocked, RESERVE * self.turn_radius / ground.cell
        step = self.step or math.ceil(radius)
        offsets, longest = ring(step, min(self.sampling, step)), self.longest(scenario) / ground.cell
        room = clearance_field(Grid(blocked, 1.0), beyond=True)
        pheromone = Pheromone(self, ground, scenario)
        state, visited, mark = dice(rng), np.zeros(blocked.shape, np.int64), 0
        nodes = np.empty((math.ceil(longest / step) + 3, 2))

        def send() -> tuple[Floats, bool]:
            nonlocal mark
            mark += 1
            count, arrived = walk_turning(
                blocked, room, pheromone.seen, state, ground.start, ground.goal, offsets, self.pheromone_factor,
                self.heuristic_factor, self.bias, longest, radius, visited, mark, nodes,
            )  # fmt: skip
            way = nodes[:count].copy()
            if not arrived:
                return way, False
            pruning = (self.pruning_longest, self.pruning_shortest, self.pruning_decay)
            return prune_turning(blocked, room, way, *pruning, radius), True

        return search(ground, self.ants, self.iterations, send, pheromone.lay, pheromone.evaporate)
