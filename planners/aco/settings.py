"""What basic and improved colonies have in common of Table 1 in paper 000."""

from __future__ import annotations

from typing import Annotated

import msgspec

Positive = Annotated[float, msgspec.Meta(gt=0.0, le=1e9)]
NotNegative = Annotated[float, msgspec.Meta(ge=0.0, le=1e9)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Count = Annotated[int, msgspec.Meta(ge=1, le=100_000)]


class ColonySettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Settings of every colony, with the values of Table 1.

    ants: how many set out in each iteration (Table 1: 100).
    pheromone: Q [map units], what an ant lays over the length of its way (eq. 2; Table 1: 2000).
    initial_pheromone: tau before the first iteration (Table 1: 2).
    pheromone_factor: alpha, how strongly pheromone attracts (eq. 1; Table 1: 6).
    heuristic_factor: beta, how strongly the goal attracts (eq. 1; Table 1: 3).
    evaporation: rho, the share that is gone by the next iteration (eq. 4; Table 1: 0.6).
    max_range: [map units] beyond which an ant dies (Table 1: 5000).
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
