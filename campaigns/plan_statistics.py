"""The plans of a campaign's own planners summed up: how many found a path, and what those are like."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import msgspec
import numpy as np

from campaigns.claims import Claim
from campaigns.plans import Plan
from campaigns.ready import ReadyCase
from planners.astar.settings import planned_speed
from planners.facts import PlanFacts
from planners.needed import lateral_acceleration_needed
from planners.outside import OutsidePlanner
from planners.path import Path as PlannedPath
from planners.planner import Planner
from planners.scenario import Scenario, stem_of
from planners.units import parse_speed

FAILED = "failed"  # of a plan whose planner did
GROUND = "ground"  # the kind of vehicle that drives


class Spread(msgspec.Struct, frozen=True):
    """A quantity over plans."""

    median: float
    worst: float


class PlanStatistics(msgspec.Struct, frozen=True, kw_only=True):
    """Plans of as many `seeds`: lengths in metres, angles in degrees; None for what they have not.

    `found` of them have a path, and `missing` counts the others by how they are called. `turn_1` and `turn_5` are the
    largest turns of paths sampled every 1 and 5 map units, `smallest_radius` is that of the tightest curve, and
    `cornered` counts paths with corners, which have no radius. Of searches, `survivors` is the median of those of
    `population` that arrived in the last of `iterations`, and `converged` that of the first within 1 % of the best.

    Of fleets of as many `paths`, `length` is the sum over these, `longest` that of the longest, `turn_max_deg` the
    largest turn where paths are drawn, and `stages` are the median sums after each step of planning.
    """

    seeds: int
    found: int
    missing: dict[str, int]
    exact_length: float | None = None
    length: Spread | None = None
    length_ratio: Spread | None = None
    turn_1_deg: float | None = None
    turn_5_deg: float | None = None
    smallest_radius: float | None = None
    cornered: int = 0
    population: int = 0
    iterations: int = 0
    survivors: float | None = None
    converged: float | None = None
    paths: int = 1
    longest: Spread | None = None
    turn_max_deg: float | None = None
    stages: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True, slots=True)
class PlannedBy:
    """A planner with its settings on a scenario: its `statistics`, and the `case` that is the first of the `cases` that
    fly its plans.

    `seed` is that of the first it answered, None where it always failed; `claims` are what others say of it. `searches`
    are the facts of those plans whose search counted its cost evaluations.

    `driven_at` is the speed [m/s] that it plans for, or else the slowest at which a ground vehicle follows its plans,
    and `needed` the most lateral acceleration [m/s^2] that these need then; None where there is no such speed, or path.
    """

    planner: Planner
    scenario: Scenario
    seed: int | None
    case: str
    statistics: PlanStatistics
    claims: tuple[Claim, ...] = ()
    searches: tuple[PlanFacts, ...] = ()
    cases: tuple[str, ...] = ()
    driven_at: float | None = None
    needed: float | None = None

    @property
    def planned_for(self) -> float | None:
        """The speed [m/s] that it plans for, None where it plans for none."""
        return planned_speed(self.planner)

    @property
    def straight(self) -> float | None:
        """How far its start and its goal are apart [m]; None for a fleet."""
        starts, goals = self.scenario.starts, self.scenario.goals
        return float(math.dist(starts[0], goals[0])) if len(starts) == len(goals) == 1 else None


def statistics_of(facts: Sequence[PlanFacts | None]) -> PlanStatistics:
    """Those of at least one plan, a seed each; None stands for one whose planner failed."""
    told = [one for one in facts if one is not None]
    paths = [one for one in told if one.length is not None]
    searches = [one for one in told if one.survivors]
    missing = Counter(FAILED if one is None else one.outcome for one in facts if one is None or one.length is None)
    return PlanStatistics(
        seeds=len(facts),
        found=len(paths),
        missing=dict(sorted(missing.items())),
        exact_length=max(_known(one.exact_length for one in paths), default=None),
        length=_spread(one.length for one in paths),
        length_ratio=_spread(one.length_ratio for one in paths),
        turn_1_deg=max(_known(one.turn_angle_1_unit_deg for one in paths), default=None),
        turn_5_deg=max(_known(one.turn_angle_5_units_deg for one in paths), default=None),
        smallest_radius=min(_known(one.smallest_radius for one in paths), default=None),
        cornered=sum(one.smallest_radius is None and bool(one.turn_angle_max_deg) for one in paths),
        population=max((one.population for one in searches), default=0),
        iterations=max((len(one.survivors) for one in searches), default=0),
        survivors=median(one.survivors[-1] for one in searches) if searches else None,
        converged=median(arrived) if (arrived := _known(one.converged for one in searches)) else None,
        paths=max((len(one.lengths) for one in paths), default=1),
        longest=_spread(one.longest for one in paths),
        turn_max_deg=max(_known(one.turn_angle_max_deg for one in paths), default=None),
        stages=_stages(paths),
    )


def planned_by(cases: Sequence[ReadyCase], claims: Sequence[Claim], folder: Path) -> list[PlannedBy]:
    """Every planner of ours with its settings on each scenario, in the order of the cases, its plans as they lie in the
    results `folder`. A claim stands by the first of its planner, or of those for its speed; one that names a scenario
    does at each scale of it.
    """
    plans: dict[tuple[Scenario, Planner], dict[str, Plan]] = {}
    flying: dict[tuple[Scenario, Planner], dict[str, ReadyCase]] = {}
    for ready in cases:
        for plan in ready.plans:
            if not isinstance(plan.planner, OutsidePlanner):
                plans.setdefault((plan.scenario, plan.planner), {})[plan.key] = plan
                flying.setdefault((plan.scenario, plan.planner), {})[ready.case.name] = ready
    found: list[PlannedBy] = []
    told: set[tuple[int, Scenario | None]] = set()
    for (scenario, planner), group in plans.items():
        facts = [plan.told(folder) for plan in group.values()]
        flown = flying[scenario, planner]
        case = next(iter(flown.values())).case
        here = ("", stem_of(case.scenario or ""))
        own = [
            (i, scenario if claim.scenario else None) for i, claim in enumerate(claims)
            if claim.planner == planner.name and claim.scenario in here and claim.holds_for(planned_speed(planner))
        ]  # fmt: skip
        own = [which for which in own if which not in told]
        told.update(own)
        answered = [one for one in facts if one is not None]
        seed = answered[0].seed if answered else None
        searches = tuple(one for one in answered if one.evaluations)
        stands = tuple(claims[i] for i, _ in own)
        told_of = statistics_of(facts)
        speed = _driven_at(planner, flown.values())
        with_path = [plan for plan, one in zip(group.values(), facts, strict=True) if one is not None and one.lengths]
        needed = None if speed is None else _needed(with_path, speed, folder)
        found.append(
            PlannedBy(planner, scenario, seed, case.name, told_of, stands, searches, tuple(flown), speed, needed)
        )
    return found


def _driven_at(planner: Planner, cases: Iterable[ReadyCase]) -> float | None:
    """The speed [m/s] that `planner` plans for, else the slowest of the ground vehicles of `cases`."""
    limits = [(ready.case.speed, ready.inputs.limits) for ready in cases if ready.inputs.limits.kind == GROUND]
    slowest = min((own.speed if speed is None else parse_speed(speed) for speed, own in limits), default=None)
    return planned_speed(planner) or slowest


def _needed(plans: Iterable[Plan], speed: float, folder: Path) -> float | None:
    """The most lateral acceleration [m/s^2] that the stored paths of `plans` need at `speed` [m/s]; None for none."""
    paths = [path for plan in plans for path in plan.load(folder) if isinstance(path, PlannedPath)]
    return max((float(np.abs(lateral_acceleration_needed(path, speed)[1]).max()) for path in paths), default=None)


def _stages(paths: Sequence[PlanFacts]) -> tuple[tuple[str, float], ...]:
    """The median length [m] after each step that all `paths` went through, in their order."""
    names = [name for name, _ in paths[0].stages] if paths else []
    steps = [dict(one.stages) for one in paths]
    shared = [name for name in names if all(name in step for step in steps)]
    return tuple((name, median(step[name] for step in steps)) for name in shared)


def _spread(values: Iterable[float | None]) -> Spread | None:
    known = _known(values)
    return Spread(median(known), max(known)) if known else None


def _known(values: Iterable[float | None]) -> list[float]:
    """Without what is missing or, as the radius of a straight path, not finite."""
    return [value for value in values if value is not None and math.isfinite(value)]
