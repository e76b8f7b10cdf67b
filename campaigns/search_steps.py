"""The border of what is trackworthy, by trying one scale or one speed after the other."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import msgspec

from campaigns.attempt import failed
from campaigns.bisection import border
from campaigns.prepare import assemble, seeded
from campaigns.search import ScaleSearch
from campaigns.search_ready import ReadySearch, planning
from planners.all_planners import plan_with
from planners.errors import InputError
from planners.path import Path
from planners.planner import Plan
from planners.scenario import Scenario, scaled
from tracking.outcome import Outcome
from tracking.trial import Trial, run_trial

Make = Callable[[float], Trial | str]  # the trial at one scale or speed, or the reason why there is none


class Step(msgspec.Struct, frozen=True, kw_only=True):
    """One scale [m a map unit] or speed [m/s], tried `at`, and where it is not trackworthy, why.

    That is a `reason` in words where nothing was followed; else the `metric` that decides, its `value` in `si_unit`,
    None where it could not be measured, the `limit` on the side of `comparison`, where along the path [m], and `who` of
    a fleet of vehicles of that `kind`.
    """

    at: float
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


class Found(msgspec.Struct, frozen=True, kw_only=True):
    """What a search found: it is trackworthy `at` the smallest scale or the top speed, None where at none of the range.

    `failing` is the nearest tried beyond it that is not trackworthy, None where all of the range is. Or an `error` of
    that `kind`.
    """

    at: float | None = None
    failing: Step | None = None
    steps: tuple[Step, ...] = ()
    error: str = ""
    kind: str = ""


def find(ready: ReadySearch) -> Found:
    """Search by bisection; what goes wrong is the result."""
    steps: dict[float, Step] = {}
    near, far = ready.search.ends
    try:
        make = _at_scales(ready, ready.search) if isinstance(ready.search, ScaleSearch) else _at_speeds(ready)

        def trackworthy(at: float) -> bool:
            steps[at] = _step(make, at)
            return steps[at].trackworthy

        at, beyond = border(trackworthy, near, far, ready.search.tolerance)
    except Exception as error:  # also a fault of ours, or of a library: it costs this search
        wrong = failed(error)
        return Found(error=wrong.error, kind=wrong.kind)
    return Found(at=at, failing=None if beyond is None else steps[beyond], steps=tuple(steps.values()))


def _at_scales(ready: ReadySearch, search: ScaleSearch) -> Make:
    """Along the route planned once and drawn to a scale, or what is planned anew at each."""
    planner, given = planning(ready.inputs)
    route = None if search.replan else plan_with(planner, given, ready.plan_seed)

    def make(unit: float) -> Trial | str:
        scenario = scaled(given, unit)
        plan = plan_with(planner, scenario, ready.plan_seed) if route is None else route
        paths = _paths(plan, scenario, 1.0 if route is None else unit / given.unit)
        if isinstance(paths, str):
            return paths
        trial = assemble(ready.case, replace(ready.inputs, scenario=scenario), paths)
        return seeded(trial, ready.case.conditions, ready.seed)

    return make


def _at_speeds(ready: ReadySearch) -> Make:
    """Along the path of a file, or the one planned once."""
    paths: tuple[Path, ...] | str = ()
    if not ready.inputs.files:
        planner, scenario = planning(ready.inputs)
        paths = _paths(plan_with(planner, scenario, ready.plan_seed), scenario)

    def make(speed: float) -> Trial | str:
        if isinstance(paths, str):
            return paths
        case = msgspec.structs.replace(ready.case, speed=speed)
        return seeded(assemble(case, ready.inputs, paths), case.conditions, ready.seed)

    return make


def _paths(plan: Plan, scenario: Scenario, factor: float = 1.0) -> tuple[Path, ...] | str:
    """Those of `plan`, drawn larger by `factor`, or why there are none."""
    if not plan.paths:
        return f"{plan.outcome}: {plan.reason}"
    frame = scenario.map.frame
    return tuple(Path(factor * path.points, name=scenario.name, frame=frame) for path in plan.paths)


def _step(make: Make, at: float) -> Step:
    """Try it: what cannot be planned or followed there is not trackworthy."""
    try:
        trial = make(at)
        if isinstance(trial, str):
            return Step(at=at, trackworthy=False, reason=trial)
        return _judged(at, run_trial(trial))
    except InputError as error:
        return Step(at=at, trackworthy=False, reason=str(error))


def _judged(at: float, outcome: Outcome) -> Step:
    decisive = outcome.verdict.decisive
    if decisive is None or outcome.verdict.trackworthy:
        return Step(at=at, trackworthy=outcome.verdict.trackworthy)
    requirement, metric = decisive.requirement, decisive.metric
    return Step(
        at=at, trackworthy=False, reason="" if metric.valid else metric.note, metric=metric.name,
        si_unit=metric.unit, comparison=requirement.comparison, value=_finite(metric.value),
        limit=_finite(requirement.limit), s=_finite(metric.s),
        who=metric.who, kind=outcome.limits.kind,
    )  # fmt: skip


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
