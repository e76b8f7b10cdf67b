"""The settings of pigeons: section 3 of paper 001, under names of their own."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from planners.voronoi.settings import RoadmapSettings

Count = Annotated[int, msgspec.Meta(ge=1, le=100_000)]
Iterations = Annotated[int, msgspec.Meta(ge=0, le=100_000)]
Factor = Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Positive = Annotated[float, msgspec.Meta(gt=0.0, le=1e9)]


class Pigeons(RoadmapSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Settings of pigeons, beside those of the roadmap, with the values of section 3 of paper 001.

    pigeons: how many there are for each aircraft (300).
    compass_iterations: N_C1max, with the map and compass operator (80).
    landmark_iterations: N_C2max, with the landmark operator (20); eq. 9 leaves one pigeon of 300 after 9 of them.
    segments: legs of a path, of equal length within 10 % (20).
    compass_factor: R, by which velocities fade (eq. 7); also in eq. 15 (0.5).
    cauchy: mutate the best pigeon (eq. 12, 13).
    communication: "rescaled" lets the factor run from 0 to 1, as the text says, "printed" as a, b and c make it (eq. 14
        to 16); "none" is off.
    a, b, c: of the communication factor (eq. 15; 1.2, 0.5, -1).
    gradient: let some pigeons go down the gradient (eq. 17, 18).
    gradient_share: P_1, how many of them do (5 %).
    gradient_step: of the finite differences, in map units (ours).
    joint: one swarm for all aircraft, as printed; otherwise each has its own, since the cost, eq. 19, is a sum.
    spread: how much pigeons bend at first the paths between roadmap path and straight way, as a share of the latter
        (ours).
    first_speed: of the pigeons, as a share of that spread (ours).
    gentle_turn_deg: a turn beyond it costs, even where the scenario allows it (ours).
    """

    pigeons: Count = 300
    compass_iterations: Count = 80
    landmark_iterations: Iterations = 20
    segments: Annotated[int, msgspec.Meta(ge=2, le=1000)] = 20
    compass_factor: Annotated[float, msgspec.Meta(gt=0.0, le=100.0)] = 0.5
    cauchy: bool = False
    communication: Literal["none", "printed", "rescaled"] = "none"
    a: Factor = 1.2
    b: Factor = 0.5
    c: Factor = -1.0
    gradient: bool = False
    gradient_share: Share = 0.05
    gradient_step: Positive = 0.01
    joint: bool = False
    spread: Share = 0.03
    first_speed: Share = 0.1
    gentle_turn_deg: Annotated[float, msgspec.Meta(gt=0.0, le=180.0)] = 15.0
