"""What searches found, as `summary.json` tells it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from campaigns.search import ScaleSearch, SpeedSearch
from campaigns.search_steps import Step
from campaigns.searches import SearchResult
from planners.scenario import stem_of
from planners.units import degrees

Json = dict[str, "Json"] | list["Json"] | str | float | int | bool | None


def searches_json(results: Sequence[SearchResult]) -> dict[str, Json]:
    """The smallest scales [m a map unit] and the top speeds [m/s]."""
    return {
        "smallest_scales": [_scale(one, one.search) for one in results if isinstance(one.search, ScaleSearch)],
        "top_speeds": [_speed(one, one.search) for one in results if isinstance(one.search, SpeedSearch)],
    }


def _scale(result: SearchResult, search: ScaleSearch) -> Json:
    at, (width, height) = result.found.at, result.size or (0.0, 0.0)
    return {
        "name": search.name,
        "scenario": stem_of(search.scenario),
        "planner": search.planner,
        "vehicle": search.vehicle,
        "controller": search.controller,
        "speed": search.speed,
        "corridor": search.corridor,
        "smallest": at,
        "map_size": None if at is None else [at * width, at * height],
        **_steps(result, "unit"),
        "expect_at_most": search.expect_at_most,
        "passed": result.passed,
        "error": result.found.error,
    }


def _speed(result: SearchResult, search: SpeedSearch) -> Json:
    return {
        "name": search.name,
        "path": Path(search.path).name or None,
        "scenario": None if search.scenario is None else stem_of(search.scenario),
        "planner": search.planner,
        "vehicle": search.vehicle,
        "controller": search.controller,
        "planned_for": search.planned_for,
        "corridor": search.corridor,
        "top_speed": result.found.at,
        **_steps(result, "speed"),
        "expect_at_least": search.expect_at_least,
        "passed": result.passed,
        "error": result.found.error,
    }


def _steps(result: SearchResult, quantity: str) -> dict[str, Json]:
    """What was tried, each at its `quantity`."""
    failing = result.found.failing
    return {
        "failing": None if failing is None else _step(failing, quantity),
        "steps": [{quantity: step.at, "trackworthy": step.trackworthy} for step in result.found.steps],
        "between": [*sorted(result.search.ends)],
        "tolerance": result.search.tolerance,
    }


def _step(step: Step, quantity: str) -> Json:
    factor, unit = degrees(1.0, step.si_unit)
    return {
        quantity: step.at,
        "reason": step.reason,
        "metric": step.metric or None,
        "value": None if step.value is None else factor * step.value,
        "limit": None if step.limit is None else factor * step.limit,
        "metric_unit": unit or None,
        "s": step.s,
    }
