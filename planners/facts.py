"""What is told of a plan: the numbers that papers print, and those they lack."""

from __future__ import annotations

import math

import msgspec
import numpy as np
from msgspec.structs import replace

from planners.clearance import clearance
from planners.errors import TrackworthyError
from planners.exact import exact_paths
from planners.footprint import Disc
from planners.kernel import Floats
from planners.path import Path
from planners.planner import History, Plan, Planner
from planners.scenario import Scenario
from planners.units import wrap_all

CHECKED = 0.25  # map units between the points at which a path's clearance is taken, besides its own
CLEARANCE_DIGITS = 4  # decimals of a metre: a path that touches is 0 clear, whatever rounding says


class PlanFacts(msgspec.Struct, frozen=True, kw_only=True):
    """A plan in numbers: lengths in metres, angles in degrees; None for what it has not.

    Of a fleet, `length`, `polyline_length` and `exact_length` are sums over its paths, `lengths` those of each, and
    `longest` the greatest of these; turn angles, radius and clearance are the worst of all. `stages` are the sums after
    each step of planning, none where there is no path. `exact_length` is that of the shortest paths that keep the
    planner's clearance, by visibility graph, under the best assignment. Turn angles are taken where a path is drawn,
    and when it is sampled every 1 and 5 map units. `best`, `mean` and `survivors` are by iteration, `converged` is the
    first whose best way is within 1 % of the best of all.
    """

    planner: str
    scenario: str
    seed: int
    map_unit: float
    outcome: str = ""
    reason: str = ""
    notes: tuple[str, ...] = ()
    length: float | None = None
    lengths: tuple[float, ...] = ()
    longest: float | None = None
    stages: tuple[tuple[str, float], ...] = ()
    polyline_length: float | None = None
    exact_length: float | None = None
    turn_angle_max_deg: float | None = None
    turn_angle_1_unit_deg: float | None = None
    turn_angle_5_units_deg: float | None = None
    smallest_radius: float | None = None
    clearance_min: float | None = None
    population: int = 0
    best: tuple[float | None, ...] = ()
    mean: tuple[float | None, ...] = ()
    survivors: tuple[int, ...] = ()
    converged: int | None = None
    evaluations: tuple[int, ...] = ()
    cost: tuple[float | None, ...] = ()

    @property
    def length_ratio(self) -> float | None:
        """Length over that of the exact shortest path."""
        return self.length / self.exact_length if self.length and self.exact_length else None


def facts_of(plan: Plan, planner: Planner, scenario: Scenario, seed: int) -> PlanFacts:
    """The facts of the paths of `plan`, or why there are none."""
    facts = PlanFacts(
        planner=planner.name, scenario=scenario.name, seed=seed, map_unit=scenario.unit,
        outcome=plan.outcome, reason=plan.reason, notes=plan.notes,
    )  # fmt: skip
    if plan.history is not None:
        facts = _with_search(facts, plan.history)
    return _with_paths(facts, plan, planner, scenario) if plan.paths else facts


def turn_angle(path: Path, spacing: float) -> float:
    """The largest turn angle [rad] of `path` when it is sampled every `spacing` [m]."""
    points = path.resample(spacing).xy
    steps = np.diff(points, axis=0)
    return float(np.abs(wrap_all(np.diff(np.arctan2(steps[:, 1], steps[:, 0])))).max(initial=0.0))


def _with_search(facts: PlanFacts, history: History) -> PlanFacts:
    return replace(
        facts,
        population=history.population,
        best=_known(history.best),
        mean=_known(history.mean),
        survivors=tuple(int(count) for count in history.survivors),
        converged=history.converged,
        evaluations=() if history.evaluations is None else tuple(int(count) for count in history.evaluations),
        cost=() if history.cost is None else _known(history.cost),
    )


def _with_paths(facts: PlanFacts, plan: Plan, planner: Planner, scenario: Scenario) -> PlanFacts:
    paths, lengths = plan.paths, tuple(path.length for path in plan.paths)
    points = np.vstack([xy for path in paths for xy in (path.xy, path.resample(CHECKED * scenario.unit).xy)])
    poses = np.column_stack([points, np.zeros(len(points))])
    room = float(clearance(scenario.map, poses, Disc(0.0)).min())
    return replace(
        facts,
        length=sum(lengths),
        lengths=lengths,
        longest=max(lengths),
        stages=tuple((stage.name, sum(path.length for path in stage.paths)) for stage in plan.stages),
        polyline_length=sum(path.length for path in plan.polylines or paths),
        exact_length=exact_length(scenario, planner.clearance, len(paths)),
        turn_angle_max_deg=math.degrees(max(float(np.abs(path.turns).max()) for path in paths)),
        turn_angle_1_unit_deg=math.degrees(max(turn_angle(path, scenario.unit) for path in paths)),
        turn_angle_5_units_deg=math.degrees(max(turn_angle(path, 5.0 * scenario.unit) for path in paths)),
        smallest_radius=None if plan.smallest_radius is None else float(plan.smallest_radius),
        clearance_min=round(room, CLEARANCE_DIGITS) if math.isfinite(room) else None,
    )


def exact_length(scenario: Scenario, clearance: float, count: int = 1) -> float | None:
    """Length [m] of the shortest path that keeps `clearance` [m], of a fleet the sum.

    None where there is none, GEOS fails, or it serves not just `count` aircraft: sums over others do not compare. None
    as well on a map that is too fine for it.
    """
    try:
        paths = exact_paths(scenario, clearance)
    except TrackworthyError:
        return None
    return sum(path.length for path in paths) if len(paths) == count else None


def _known(values: Floats) -> tuple[float | None, ...]:
    return tuple(float(value) if math.isfinite(value) else None for value in values)
