"""The improved colony of paper 000: asynchronous ring, biased roulette, equivalent pheromone, pruning, smoothing."""

from __future__ import annotations

import math
from typing import ClassVar, Literal

import numpy as np
from scipy.ndimage import maximum_filter

from planners.aco.colony import Found, search
from planners.aco.finish import finished, without_path
from planners.aco.pheromone_kernels import evaporate_and_lay, lay_along, region
from planners.aco.roulette_kernels import dice
from planners.aco.settings import ColonySettings, Count, NotNegative, Positive, Share
from planners.aco.walk_kernels import prune, ring, walk
from planners.ground import Ground, cell_for_cover, ground_of
from planners.kernel import Floats
from planners.planner import Plan
from planners.scenario import Scenario


class AcoImproved(ColonySettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Improved ant colony (Li et al., paper 000). Settings beside those of every colony, with the values of Table 1;
    what is in brackets switches an improvement off.

    iterations: 10, as in the paper's Table 2.
    cell: l_m, side of a cell [map units] (Table 1: 1).
    cover: lambda, the least share that obstacles cover of their cells; then `cell` is the largest tried (eq. 5) [0].
    step: l_c, cells from an ant to the square ring it steps to (Table 1: 8) [1: the 8 neighbours].
    steps: N_c, how many steps the straight way would take; where given, it decides `step` (eq. 6).
    sampling: l_s, cells between candidates on the ring (eq. 7; Table 1: 2).
    alert_zone: check for collisions only where an obstacle is within a step [false: everywhere].
    bias: C of the biased roulette (eq. 8; Table 1: 0.5) [0].
    observation_radius: r, layers of cells in the equivalent pheromone (eq. 10; Table 1: 2) [0].
    equivalence: mu, the weight of each layer against the one inside it (eq. 10; Table 1: 0.5).
    pruning: leave out needless nodes before pheromone is laid (2.3) [false].
    pruning_longest, pruning_shortest, pruning_decay: l_c,max, l_c,min [nodes] and sigma (eq. 11; Table 1: 10, 4, 0.8).
    pheromone_on: "cells" of the pruned path, or its "nodes" only; the paper does not say which.
    taut: pull the shortest way of all taut, for the polyline; ours [false].
    smoothing: round the corners with cubic Hermite pieces [false].
    turn_radius: [m] that these have at least where there is room: a c172x at 55 m/s and 25 deg of bank.
    """

    name: ClassVar[str] = "aco-improved"
    summary: ClassVar[str] = "improved ant colony (paper 000): ring steps, biased roulette, pruning, Hermite smoothing"

    iterations: Count = 10
    cell: Positive = 1.0
    cover: Share = 0.0
    step: Count = 8
    steps: Count | None = None
    sampling: Count = 2
    alert_zone: bool = True
    bias: Share = 0.5
    observation_radius: int = 2
    equivalence: Share = 0.5
    pruning: bool = True
    pruning_longest: Count = 10
    pruning_shortest: Count = 4
    pruning_decay: Share = 0.8
    pheromone_on: Literal["cells", "nodes"] = "cells"
    taut: bool = True
    smoothing: bool = True
    turn_radius: NotNegative = 661.0

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
        """The colony's way through `ground`."""
        unit = scenario.unit / ground.cell  # cells
        step = self.step if self.steps is None else math.ceil(math.dist(ground.start, ground.goal) / self.steps)
        offsets, longest = ring(step, min(self.sampling, step)), self.max_range * unit
        alert = maximum_filter(ground.blocked, 2 * step + 1) if self.alert_zone else np.ones_like(ground.blocked)
        weights = region(self.observation_radius, self.equivalence)
        seen = np.full(ground.blocked.shape, self.initial_pheromone * weights.sum())
        laid, visited = np.zeros(ground.blocked.shape), np.zeros(ground.blocked.shape, np.int64)
        state, nodes, mark = dice(rng), np.empty((math.ceil(longest / step) + 3, 2)), 0

        def send() -> tuple[Floats, bool]:
            nonlocal mark
            mark += 1
            count, arrived = walk(
                ground.blocked, alert, seen, state, ground.start, ground.goal, offsets, self.pheromone_factor,
                self.heuristic_factor, self.bias, longest, visited, mark, nodes,
            )  # fmt: skip
            way = nodes[:count].copy()
            if not (arrived and self.pruning):
                return way, arrived
            return prune(ground.blocked, way, self.pruning_longest, self.pruning_shortest, self.pruning_decay), True

        def lay(way: Floats, length: float) -> None:
            lay_along(laid, self.pheromone * scenario.unit / length, way, self.pheromone_on == "nodes")

        def evaporate() -> None:
            evaporate_and_lay(seen, laid, self.evaporation, weights)

        return search(ground, self.ants, self.iterations, send, lay, evaporate)
