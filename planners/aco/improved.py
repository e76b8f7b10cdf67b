"""The improved colony of paper 000: asynchronous ring, biased roulette, equivalent pheromone, pruning, smoothing."""

from __future__ import annotations

import math
from typing import ClassVar, Literal

import numpy as np
from scipy.ndimage import maximum_filter

from planners.aco.colony import Found, search
from planners.aco.finish import finished
from planners.aco.pheromone import Pheromone
from planners.aco.roulette_kernels import dice
from planners.aco.settings import Count, RingSettings, Share
from planners.aco.walk_kernels import prune, ring, walk
from planners.ground import Ground, cell_for_cover, ground_of, without_path
from planners.kernel import Floats
from planners.planner import Plan
from planners.scenario import Scenario


class AcoImproved(RingSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Improved ant colony (Li et al., paper 000). Settings beside those of every colony with rings:

    cover: lambda, least share of their cells that obstacles cover; `cell` is then the largest tried (eq. 5); 0 is off.
    step: l_c, cells from an ant to the square ring it steps to (Table 1: 8); 1, with a sampling of 1, is off.
    steps: N_c, how many steps the straight way would take; where given, it decides `step` (eq. 6).
    alert_zone: check for collisions only where an obstacle is within a step; false checks everywhere.
    pruning: leave out needless nodes before pheromone is laid (2.3).
    pheromone_on: "cells" of the pruned path, or its "nodes" only; the paper does not say which.
    taut: pull the shortest way of all taut, for the polyline (ours).
    smoothing: round the corners with cubic Hermite pieces.
    """

    name: ClassVar[str] = "aco-improved"
    summary: ClassVar[str] = "improved ant colony (paper 000): ring steps, biased roulette, pruning, Hermite smoothing"

    cover: Share = 0.0
    step: Count = 8
    steps: Count | None = None
    alert_zone: bool = True
    pruning: bool = True
    pheromone_on: Literal["cells", "nodes"] = "cells"
    taut: bool = True
    smoothing: bool = True

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """Let the colony search; the shortest pruned way is rounded."""
        ground = self.ground(scenario)
        if not ground.connected:
            return without_path(self.clearance)
        found = self.search(ground, scenario, rng)
        radius = self.turn_radius if self.smoothing else 0.0
        return finished(found, ground, scenario, self.name, self.taut, radius)

    def ground(self, scenario: Scenario) -> Ground:
        """The scenario in cells, of the size that eq. 5 asks for."""
        cell = self.cell * scenario.unit
        if self.cover > 0.0:
            cell = cell_for_cover(scenario.map, self.cover, cell)
        return ground_of(scenario, self.name, cell, self.clearance)

    def search(self, ground: Ground, scenario: Scenario, rng: np.random.Generator) -> Found:
        """The colony's ways through `ground`."""
        step = self.step if self.steps is None else math.ceil(math.dist(ground.start, ground.goal) / self.steps)
        offsets, longest = ring(step, min(self.sampling, step)), self.longest(scenario) / ground.cell
        alert = maximum_filter(ground.blocked, 2 * step + 1) if self.alert_zone else np.ones_like(ground.blocked)
        pheromone = Pheromone(self, ground, scenario, self.pheromone_on == "nodes")
        state, visited, mark = dice(rng), np.zeros(ground.blocked.shape, np.int64), 0
        nodes = np.empty((math.ceil(longest / step) + 3, 2))

        def send() -> tuple[Floats, bool]:
            nonlocal mark
            mark += 1
            count, arrived = walk(
                ground.blocked, alert, pheromone.seen, state, ground.start, ground.goal, offsets,
                self.pheromone_factor, self.heuristic_factor, self.bias, longest, visited, mark, nodes,
            )  # fmt: skip
            way = nodes[:count].copy()
            if not (arrived and self.pruning):
                return way, arrived
            return prune(ground.blocked, way, self.pruning_longest, self.pruning_shortest, self.pruning_decay), True

        return search(ground, self.ants, self.iterations, send, pheromone.lay, pheromone.evaporate)
