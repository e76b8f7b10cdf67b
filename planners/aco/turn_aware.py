"""The future work of paper 000: ants that know the vehicle's turn radius while they search."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from planners.aco.colony import Found, search
from planners.aco.finish import not_found, path_of, without_path
from planners.aco.pheromone_kernels import evaporate_and_lay, lay_along, region
from planners.aco.roulette_kernels import dice
from planners.aco.settings import ColonySettings, Count, Positive, Share
from planners.aco.turn_kernels import prune_turning, walk_turning
from planners.aco.walk_kernels import ring
from planners.ground import Ground, ground_of
from planners.kernel import Floats
from planners.occupancy import Grid, clearance_field
from planners.planner import NOT_FOUND, Plan
from planners.rounding import RESERVE, Rounded, rounded
from planners.scenario import Scenario


class AcoTurnAware(ColonySettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Turn-aware ant colony: the improved colony, whose ants step only where a turn of `turn_radius` leads, and only
    where from there a turn leads on. Settings beside those of every colony:

    turn_radius: [m] that no curve of the path goes below: a c172x at 55 m/s and 25 deg of bank.
    iterations, cell, step, bias, observation_radius, equivalence, pruning_longest, pruning_shortest, pruning_decay: as
        of aco-improved, with the same values.
    sampling: cells between candidates on the ring; 1, for an ant sees but a narrow part of it ahead.
    """

    name: ClassVar[str] = "aco-turn-aware"
    summary: ClassVar[str] = "ant colony that keeps a turn radius while it searches (ours, after paper 000's outlook)"

    turn_radius: Positive = 661.0
    iterations: Count = 10
    cell: Positive = 1.0
    step: Count | None = None
    sampling: Count = 2
    bias: Share = 0.5
    observation_radius: int = 2
    equivalence: Share = 0.5
    pruning_longest: Count = 10
    pruning_shortest: Count = 4
    pruning_decay: Share = 0.8

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """Let the colony search; of the best ways of each iteration, the shortest that can be rounded counts."""
        ground = ground_of(scenario, self.name, self.cell * scenario.unit, self.clearance)
        if not ground.connected:
            return without_path(self.clearance)
        found = self.search(ground, scenario, rng)
        if found.way is None:
            return not_found(found)
        smooth = [rounded(ground, way, self.turn_radius, keep=True) for way in found.ways]
        kept = [one for one in smooth if not one.tight]
        if not kept:
            what = f"none of the ways found keeps a turn radius of {self.turn_radius:g} m"
            return Plan(outcome=NOT_FOUND, reason=f"{NOT_FOUND}: {what}", history=found.history)
        best = min(kept, key=_length)
        way = found.ways[smooth.index(best)]
        return Plan(
            paths=(path_of(best.points, scenario, self.name),),
            polylines=(path_of(ground.to_metres(way), scenario, self.name),),
            smallest_radius=best.smallest_radius,
            history=found.history,
        )

    def search(self, ground: Ground, scenario: Scenario, rng: np.random.Generator) -> Found:
        """The colony's ways through `ground`."""
        blocked, radius = ground.blocked, self.turn_radius / ground.cell
        step = self.step or math.ceil(radius)
        offsets, longest = ring(step, self.sampling), self.max_range * scenario.unit / ground.cell
        room = clearance_field(Grid(blocked, 1.0), beyond=True)
        weights = region(self.observation_radius, self.equivalence)
        seen = np.full(blocked.shape, self.initial_pheromone * weights.sum())
        laid, visited = np.zeros(blocked.shape), np.zeros(blocked.shape, np.int64)
        state, nodes, mark = dice(rng), np.empty((math.ceil(longest / step) + 3, 2)), 0

        def send() -> tuple[Floats, bool]:
            nonlocal mark
            mark += 1
            count, arrived = walk_turning(
                blocked, room, seen, state, ground.start, ground.goal, offsets, self.pheromone_factor,
                self.heuristic_factor, self.bias, longest, RESERVE * radius, visited, mark, nodes,
            )  # fmt: skip
            way = nodes[:count].copy()
            if not arrived:
                return way, False
            pruning = (self.pruning_longest, self.pruning_shortest, self.pruning_decay)
            return prune_turning(blocked, room, way, *pruning, RESERVE * radius), True

        def lay(way: Floats, length: float) -> None:
            lay_along(laid, self.pheromone * scenario.unit / length, way, False)

        def evaporate() -> None:
            evaporate_and_lay(seen, laid, self.evaporation, weights)

        return search(ground, self.ants, self.iterations, send, lay, evaporate)


def _length(line: Rounded) -> float:
    return float(np.hypot(*np.diff(line.points, axis=0).T).sum())
