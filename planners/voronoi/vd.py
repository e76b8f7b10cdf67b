"""The VD method of paper 001: Voronoi roadmap, Dijkstra, line of sight, and who flies where."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from planners.fleet import unserved, why_unserved
from planners.planner import Plan, Stage
from planners.scenario import Scenario
from planners.voronoi.planned import Planned, path_of, planned
from planners.voronoi.settings import RoadmapSettings

ROADMAP, SIGHT = "Voronoi roadmap", "line of sight"


class Vd(RoadmapSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Voronoi roadmap and Dijkstra (Ao et al., paper 001, section 2.1)."""

    name: ClassVar[str] = "vd"
    summary: ClassVar[str] = "Voronoi roadmap, Dijkstra, line of sight and assignment (paper 001), for fleets"

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """The same paths for every seed; range is kept, the turn limit where as many aircraft can be served so."""
        found = planned(scenario, self, self.name, keep_turns=True)
        if isinstance(found, Plan):
            return found
        stages = stages_of(found, scenario)
        sharpest = max(one.turn for one in found.chosen)
        notes: tuple[str, ...] = ()
        if sharpest > found.sharpest:
            limit, turn = math.degrees(found.sharpest), math.degrees(sharpest)
            notes = (f"the turn limit of {limit:.3g} deg is not kept: the sharpest turn has {turn:.3g} deg",)
        return Plan(paths=stages[-1].paths, stages=stages, notes=notes + left_out(found, scenario))


def stages_of(found: Planned, scenario: Scenario) -> tuple[Stage, ...]:
    """The paths along the roadmap, and shortened."""
    return (
        Stage(ROADMAP, tuple(path_of(one.along, one, scenario) for one in found.chosen)),
        Stage(SIGHT, tuple(path_of(one.short, one, scenario) for one in found.chosen)),
    )


def left_out(found: Planned, scenario: Scenario) -> tuple[str, ...]:
    """A note on aircraft without a path."""
    return unserved(scenario, {one.aircraft for one in found.chosen}, why_unserved(scenario))
