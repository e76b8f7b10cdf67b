"""The VDP method of paper 001: the paths of VD, optimised by pigeons; with the improved ones, and with the standard."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import ClassVar, Literal

import numpy as np

from planners.kernel import Floats
from planners.pio.course import Course, Joint, Limits, is_even, keeps
from planners.pio.field import field_of
from planners.pio.search import Search, search
from planners.pio.settings import Pigeons
from planners.planner import NOT_FOUND, History, Plan, Stage
from planners.scenario import Scenario
from planners.voronoi.planned import Planned, path_of, planned
from planners.voronoi.roadmap import box_of
from planners.voronoi.vd import left_out, stages_of


class VdpPio(Pigeons, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Voronoi roadmap, then standard pigeons (Duan and Qiao 2014; paper 001, eq. 5 to 11)."""

    name: ClassVar[str] = "vdp-pio"
    summary: ClassVar[str] = "vd, then standard pigeon-inspired optimisation (paper 001), for fleets"

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """Let the pigeons of each aircraft search about its roadmap path.

        Their best path that keeps hazards, range, turns and equal legs counts; where they find none, the roadmap path
        does if it keeps the first three.
        """
        found = planned(scenario, self, self.name, keep_turns=False)
        if isinstance(found, Plan):
            return found
        courses = self.courses(found, scenario.unit)
        swarms = self.swarms(courses, found, rng)
        history = history_of(swarms, self.pigeons, scenario.unit)
        paths, notes = [], []
        for one, course, legs in zip(found.chosen, courses, _best(swarms, courses, found), strict=True):
            number = one.aircraft + 1
            if legs is None and not keeps(one.short, found.free, course.limits):
                what = f"no pigeon of aircraft {number} keeps hazards, range and turns, nor does its roadmap path"
                return Plan(outcome=NOT_FOUND, reason=what, stages=stages_of(found, scenario), history=history)
            if legs is None:
                notes.append(f"aircraft {number} flies its roadmap path: none of its pigeons keeps all limits")
            paths.append(path_of(one.short if legs is None else legs, one, scenario))
        return Plan(
            paths=tuple(paths),
            stages=(*stages_of(found, scenario), Stage(self.stage, tuple(paths))),
            notes=(*notes, *left_out(found, scenario)),
            history=history,
        )

    @property
    def stage(self) -> str:
        """What the optimisation is called."""
        return "PIO"

    def courses(self, found: Planned, unit: float) -> list[Course]:
        """What each aircraft searches on, in map units."""
        sharpest = found.sharpest
        gentle = min(math.radians(self.gentle_turn_deg), sharpest)
        limits = Limits(self.clearance / unit, found.longest, sharpest, gentle)
        field = field_of(found.scenario.map, box_of(found.free))
        ends = [(found.scenario.starts[one.aircraft], found.scenario.goals[one.target]) for one in found.chosen]
        return [Course(start, goal, self.segments, limits, field) for start, goal in ends]

    def swarms(self, courses: list[Course], found: Planned, rng: np.random.Generator) -> list[Search]:
        """The searches of all aircraft, or the one that is joint."""
        first = [self.flock(course, one.short, rng) for course, one in zip(courses, found.chosen, strict=True)]
        if self.joint:
            positions, velocities = (np.hstack(parts) for parts in zip(*first, strict=True))
            return [search(Joint(courses), positions, velocities, rng, self)]
        return [search(course, *flock, rng, self) for course, flock in zip(courses, first, strict=True)]

    def flock(self, course: Course, path: Floats, rng: np.random.Generator) -> tuple[Floats, Floats]:
        """Positions and velocities (N, D) at first: between `path` and the straight line, and about.

        What is about is a random bend, a Brownian bridge, so that paths do not start ragged. The first pigeon starts
        on the path.
        """
        known, count = course.offsets(path), (self.pigeons, course.dimensions)
        reach = self.spread * float(np.hypot(*(course.goal - course.start)))
        positions = rng.random((self.pigeons, 1)) * known + reach * _bends(rng, count)
        positions[0] = known
        return positions, self.first_speed * reach * _bends(rng, count)


class Vdp(VdpPio, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Voronoi roadmap, then improved pigeons, GCCPIO (Ao et al., paper 001): mutated, communicating, with gradients."""

    name: ClassVar[str] = "vdp"
    summary: ClassVar[str] = "vd, then improved pigeon-inspired optimisation, GCCPIO (paper 001), for fleets"

    cauchy: bool = True
    communication: Literal["none", "printed", "rescaled"] = "rescaled"
    gradient: bool = True

    @property
    def stage(self) -> str:
        """What the optimisation is called."""
        return "GCCPIO"


def history_of(swarms: Sequence[Search], pigeons: int, unit: float) -> History:
    """The searches of all aircraft as one: sums over them."""
    return History(
        best=unit * np.sum([swarm.lengths for swarm in swarms], axis=0),
        mean=unit * np.sum([swarm.means for swarm in swarms], axis=0),
        survivors=np.sum([swarm.survivors for swarm in swarms], axis=0, dtype=np.int64),
        population=pigeons * len(swarms),
        evaluations=np.sum([swarm.evaluations for swarm in swarms], axis=0, dtype=np.int64),
        cost=unit * np.sum([swarm.costs for swarm in swarms], axis=0),
    )


def _best(swarms: Sequence[Search], courses: list[Course], found: Planned) -> list[Floats | None]:
    """The best path of each course that keeps all limits by exact geometry; None where there is none.

    Of a joint swarm they are the paths of one pigeon.
    """
    if len(swarms) < len(courses):
        return _best_together(swarms[0], courses, found) or [None] * len(courses)
    pairs = zip(swarms, courses, strict=True)
    best = [_best_together(swarm, [course], found) for swarm, course in pairs]
    return [legs[0] if legs else None for legs in best]


def _best_together(swarm: Search, courses: list[Course], found: Planned) -> list[Floats | None]:
    joint = Joint(courses)
    for position in reversed(swarm.found):
        paths = [course.legs(part) for course, part in zip(courses, joint.split(position), strict=True)]
        if all(is_even(legs) and keeps(legs, found.free, courses[0].limits) for legs in paths):
            return list(paths)
    return []


def _bends(rng: np.random.Generator, shape: tuple[int, int]) -> Floats:
    """Brownian bridges (N, D) from 0 to 0, with standard deviation 1/2 in the middle."""
    n, d = shape
    walk = np.cumsum(rng.standard_normal((n, d + 1)), axis=1) / math.sqrt(d + 1)
    return np.asarray(walk[:, :-1] - walk[:, -1:] * np.arange(1, d + 1) / (d + 1))
