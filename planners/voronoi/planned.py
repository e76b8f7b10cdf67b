"""From a scenario to a roadmap path for each aircraft: what `vd` flies, and pigeons start from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from planners.assignment import assigned
from planners.exact import free_space
from planners.fleet import fleet_ends, joined, pair_name
from planners.kernel import Bools, Floats
from planners.path import Path
from planners.planner import NO_PATH, NOT_FOUND, Plan
from planners.scenario import Scenario, scaled
from planners.voronoi.candidates import Candidate, candidates
from planners.voronoi.roadmap import roadmap_in
from planners.voronoi.settings import RoadmapSettings


@dataclass(frozen=True, slots=True, eq=False)
class Planned:
    """The `chosen` candidate of each aircraft that has one, in map units, and the `free` space that all keep to.

    `scenario` is in map units too. `longest` [map units] and `sharpest` [rad] are its limits (paper 001, eq. 3, 4).
    """

    scenario: Scenario
    free: Any
    chosen: tuple[Candidate, ...]
    longest: float
    sharpest: float


def planned(scenario: Scenario, settings: RoadmapSettings, planner: str, keep_turns: bool) -> Planned | Plan:
    """The candidates chosen, or the plan that says why there are none.

    Range is kept: what is to be optimised later must be within it before. With `keep_turns` the turn limit is kept
    too, where as many aircraft can be served so.
    """
    fleet_ends(scenario, settings.clearance, planner)
    small, keep = scaled(scenario, 1.0), settings.clearance / scenario.unit
    ends = np.vstack([small.starts, small.goals])
    free = free_space(small.map, keep, ends)
    pairs = joined(free, ends, len(small.starts))
    if not pairs.any():
        what = f"obstacles and edges leave no way from start to goal with {settings.clearance:g} m of clearance"
        return Plan(outcome=NO_PATH, reason=what)
    roadmap = roadmap_in(small.map, free)
    found = candidates(
        roadmap, free, ends, len(small.starts), pairs, settings.candidates, settings.links, settings.sight_spacing
    )
    if not found:
        return Plan(outcome=NOT_FOUND, reason="no way along the Voronoi roadmap is free, even shortened")
    longest, sharpest = small.max_range or math.inf, small.max_turn_angle or math.pi
    in_range = np.array([one.length <= longest for one in found])
    if not in_range.any():
        least = min(one.length for one in found) * scenario.unit
        what = f"every way along the Voronoi roadmap is beyond the range: the shortest has {least:g} m"
        return Plan(outcome=NOT_FOUND, reason=what)
    chosen = _chosen(found, in_range)
    if keep_turns:
        gentle = _chosen(found, in_range & np.array([one.turn <= sharpest for one in found]))
        chosen = gentle if len(gentle) == len(chosen) else chosen
    return Planned(small, free, chosen, longest, sharpest)


def _chosen(found: list[Candidate], allowed: Bools) -> tuple[Candidate, ...]:
    aircraft, targets = np.array([[one.aircraft, one.target] for one in found]).T
    return tuple(found[i] for i in assigned(aircraft, targets, np.array([one.length for one in found]), allowed))


def path_of(points: Floats, one: Candidate, scenario: Scenario) -> Path:
    """The path of `points` (N, 2) [map units], from just the scenario's start to just its goal."""
    apart = np.concatenate([[True], (np.diff(points, axis=0) != 0.0).any(axis=1)])
    metres = points[apart] * scenario.unit
    metres[0], metres[-1] = scenario.starts[one.aircraft], scenario.goals[one.target]
    return Path(metres, name=pair_name(scenario, one.aircraft, one.target), frame=scenario.map.frame)
