"""The basic colony of paper 000: 8 neighbours, cells of 4 x 4, a tabu list, pheromone on the ways between cells."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from planners.aco.basic_kernels import lay_on_ways, walk_basic
from planners.aco.colony import search
from planners.aco.finish import finished
from planners.aco.roulette_kernels import dice
from planners.aco.settings import ColonySettings, Count, Positive, Share
from planners.ground import ground_of, without_path
from planners.kernel import Floats
from planners.planner import Plan
from planners.scenario import Scenario


class AcoBasic(ColonySettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Basic ant colony (paper 000, eq. 1 to 4). Its heuristic is 1 over the distance from the goal, normalised over
    the open neighbours, which does what the paper's figures show; settings beside those of every colony:

    iterations: 30, as in the paper's Table 2.
    cell: side of a cell [map units] (Table 1: 4).
    heuristic_floor: normalised heuristic of the neighbour farthest from the goal, 1 for the nearest; ours, as the paper
        prints none. With 0 an ant never steps back, and most die in the first dead end.
    """

    name: ClassVar[str] = "aco-basic"
    summary: ClassVar[str] = "basic ant colony (paper 000), its heuristic normalised over the neighbours"
    to_goal: ClassVar[bool] = True

    iterations: Count = 30
    cell: Positive = 4.0
    heuristic_floor: Share = 0.1

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """Let the colony search; the shortest way is the path, corners and all."""
        ground = ground_of(scenario, self.name, self.cell * scenario.unit, self.clearance)
        if not ground.connected:
            return without_path(self.clearance)
        start, goal = ground.start.astype(np.int64), ground.goal.astype(np.int64)
        shape, longest = ground.blocked.shape, self.longest(scenario) / ground.cell
        trail, laid = np.full((*shape, 8), self.initial_pheromone), np.zeros((*shape, 8))
        state, visited, mark = dice(rng), np.zeros(shape, np.int64), 0
        cells = np.empty((math.ceil(longest) + 2, 2), np.int64)

        def send() -> tuple[Floats, bool]:
            nonlocal mark
            mark += 1
            count, arrived = walk_basic(
                ground.blocked, trail, state, start, goal, self.pheromone_factor, self.heuristic_factor, self.to_goal,
                self.heuristic_floor, longest, visited, mark, cells,
            )  # fmt: skip
            inner = cells[1 : count - 1 if arrived else count] + 0.5
            return np.vstack([ground.start, inner, *([ground.goal] if arrived else [])]), arrived

        def lay(way: Floats, length: float) -> None:
            lay_on_ways(laid, self.pheromone * scenario.unit / length, way.astype(np.int64))

        def evaporate() -> None:
            trail[:] = (1.0 - self.evaporation) * trail + laid
            laid[:] = 0.0

        found = search(ground, self.ants, self.iterations, send, lay, evaporate)
        return finished(found, ground, scenario, self.name, False, 0.0)


class AcoBasicPrinted(AcoBasic, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Basic ant colony as eq. 1 of paper 000 is printed: the heuristic of a neighbour is 1 over its distance from the
    ant, which says nothing about the goal. No ant arrives within the range. Settings as those of `aco-basic`.
    """

    name: ClassVar[str] = "aco-basic-printed"
    summary: ClassVar[str] = "basic ant colony (paper 000, eq. 1 as printed): no ant arrives"
    to_goal: ClassVar[bool] = False
