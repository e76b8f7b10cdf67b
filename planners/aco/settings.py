"""The settings of colonies: Table 1 of paper 000, under names of their own."""

from __future__ import annotations

import math
from typing import Annotated

import msgspec

from planners.scenario import Scenario

Positive = Annotated[float, msgspec.Meta(gt=0.0, le=1e9)]
NotNegative = Annotated[float, msgspec.Meta(ge=0.0, le=1e9)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Count = Annotated[int, msgspec.Meta(ge=1, le=100_000)]
Layers = Annotated[int, msgspec.Meta(ge=0, le=100)]


class ColonySettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Settings of every colony, with the values of Table 1.

    ants: how many set out in each iteration (Table 1: 100).
    pheromone: Q [map units], what an ant lays over the length of its way (eq. 2; Table 1: 2000).
    initial_pheromone: tau before the first iteration (Table 1: 2).
    pheromone_factor: alpha, how strongly pheromone attracts (eq. 1; Table 1: 6).
    heuristic_factor: beta, how strongly the goal attracts (eq. 1; Table 1: 3).
    evaporation: rho, the share that is gone by the next iteration (eq. 4; Table 1: 0.6).
    max_range: [map units] beyond which an ant dies, if the scenario's own range is not less (Table 1: 5000).
    clearance: [m] kept from obstacles: half a span, and what tracking errors take.
    """

    ants: Count = 100
    pheromone: Positive = 2000.0
    initial_pheromone: Positive = 2.0
    pheromone_factor: NotNegative = 6.0
    heuristic_factor: NotNegative = 3.0
    evaporation: Share = 0.6
    max_range: Positive = 5000.0
    clearance: NotNegative = 20.0

    def longest(self, scenario: Scenario) -> float:
        """How long [m] a way may be: the colony's range, or the scenario's where that is less."""
        return min(self.max_range * scenario.unit, scenario.max_range or math.inf)


class RingSettings(ColonySettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Settings of colonies whose ants step to a ring around them and prune their ways, with the values of Table 1.

    iterations: how often the ants set out (Table 2: 10).
    cell: l_m, side of a cell [map units] (Table 1: 1).
    sampling: l_s, cells between candidates on the ring (eq. 7; Table 1: 2).
    bias: C of the biased roulette (eq. 8; Table 1: 0.5); 0 is off.
    observation_radius: r, layers of cells in the equivalent pheromone (eq. 10; Table 1: 2); 0 is off.
    equivalence: mu, the weight of each layer against the one inside it (eq. 10; Table 1: 0.5).
    pruning_longest: l_c,max, nodes left out at once in the first round of pruning (eq. 11; Table 1: 10).
    pruning_shortest: l_c,min, nodes left out at once in the last round (eq. 11; Table 1: 4).
    pruning_decay: sigma, by which that shrinks from round to round (eq. 11; Table 1: 0.8).
    turn_radius: [m] that curves have at least: a c172x at 55 m/s and 25 deg of bank.
    """

    iterations: Count = 10
    cell: Positive = 1.0
    sampling: Count = 2
    bias: Share = 0.5
    observation_radius: Layers = 2
    equivalence: Share = 0.5
    pruning_longest: Count = 10
    pruning_shortest: Count = 4
    pruning_decay: Annotated[float, msgspec.Meta(ge=0.0, le=0.99)] = 0.8
    turn_radius: Positive = 661.0
