"""The smallest scale of a map at which a planner's path is trackworthy, by bisection."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import msgspec

from campaigns.attempt import failed
from campaigns.prepare import assemble, seeded
from campaigns.scale_ready import ReadySearch
from planners.all_planners import plan_with
from planners.errors import InputError
from planners.path import Path
from planners.planner import Plan
from planners.scenario import scaled
from tracking.outcome import Outcome
from tracking.trial import run_trial


class Step(msgspec.Struct, frozen=True, kw_only=True):
    """One scale, tried: its `unit` [m a map unit] and, where it is not trackworthy, why.

    That is a `reason` in words where nothing was flown; else the `metric` that decides, its `value` in `si_unit`, None
    where it could not be measured, the `limit` on the side of `comparison`, where along the path [m], and `who` of a
    fleet of vehicles of that `kind`.
    """

    unit: float
    trackworthy: bool
    reason: str = ""
    metric: str = ""
    si_unit: str = ""
    comparison: str = ""
    value: float | None = None
    limit: float | None = None
    s: float | None = None
    who: str = ""
    kind: str = ""


class Scale(msgspec.Struct, frozen=True, kw_only=True):
    """What a search found: the smallest `unit` [m a map unit] that is trackworthy, None where the largest is not.

    `failing` is the largest scale tried that is not, None where even the smallest is trackworthy. Or an `error` of that
    `kind`.
    """

    unit: float | None = None
    failing: Step | None = None
    steps: tuple[Step, ...] = ()
    error: str = ""
    kind: str = ""


def find(ready: ReadySearch) -> Scale:
    """Search by bisection; what goes wrong is the result."""
    steps: dict[float, Step] = {}
    low, high = ready.search.between
    try:
        route = None if ready.search.replan else plan_with(ready.planner, ready.scenario, ready.plan_seed)

        def trackworthy(unit: float) -> bool:
            steps[unit] = _step(ready, unit, route)
            return steps[unit].trackworthy

        unit, below = smallest(trackworthy, low, high, ready.search.tolerance)
    except Exception as error:  # also a fault of ours, or of a library: it costs this search
        wrong = failed(error)
        return Scale(error=wrong.error, kind=wrong.kind)
    return Scale(unit=unit, failing=None if below is None else steps[below], steps=tuple(steps.values()))


def smallest(
    holds: Callable[[float], bool], low: float, high: float, tolerance: float
) -> tuple[float | None, float | None]:
    """The smallest value for which `holds`, and the largest tried below it for which not; by bisection of logarithms.

    This assumes that what holds at one value holds at every larger one. Where it does not, what is found is one of
    several borders: `holds` was true at the first and false at the second, which is smaller by at most `tolerance` of
    itself. None and `high` where it does not hold at `high`; `low` and None where it holds at `low`.
    """
    if not holds(high):
        return None, high
    if holds(low):
        return low, None
    while high > (1.0 + tolerance) * low:
        middle = math.sqrt(low * high)
        if holds(middle):
            high = middle
        else:
            low = middle
    return high, low


def _step(ready: ReadySearch, unit: float, route: Plan | None) -> Step:
    """Fly at that scale, along the `route` drawn to it or what is planned anew; a scenario that cannot be planned on or
    flown there is not trackworthy.
    """
    scenario = scaled(ready.scenario, unit)
    factor = 1.0 if route is None else unit / ready.scenario.unit
    try:
        plan = plan_with(ready.planner, scenario, ready.plan_seed) if route is None else route
        if not plan.paths:
            return Step(unit=unit, trackworthy=False, reason=f"{plan.outcome}: {plan.reason}")
        frame = scenario.map.frame
        paths = tuple(Path(factor * path.points, name=scenario.name, frame=frame) for path in plan.paths)
        trial = assemble(ready.case, replace(ready.inputs, scenario=scenario), paths)
        outcome = run_trial(seeded(trial, ready.case.conditions, ready.seed))
    except InputError as error:
        return Step(unit=unit, trackworthy=False, reason=str(error))
    return _judged(unit, outcome)


def _judged(unit: float, outcome: Outcome) -> Step:
    decisive = outcome.verdict.decisive
    if decisive is None or outcome.verdict.trackworthy:
        return Step(unit=unit, trackworthy=outcome.verdict.trackworthy)
    requirement, metric = decisive.requirement, decisive.metric
    return Step(
        unit=unit, trackworthy=False, reason="" if metric.valid else metric.note, metric=metric.name,
        si_unit=metric.unit, comparison=requirement.comparison, value=_finite(metric.value),
        limit=_finite(requirement.limit), s=_finite(metric.s),
        who=metric.who, kind=outcome.limits.kind,
    )  # fmt: skip


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
