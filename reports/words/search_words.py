"""What the searches for the smallest scale and the top speed found, as lines of text and as tables."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from campaigns.search import ScaleSearch, SpeedSearch
from campaigns.search_steps import Step
from campaigns.searches import SearchResult
from reports.files.json_result import Json
from reports.words.quantity import KILO, number, text
from reports.words.words import missed, place, speed_text
from tracking.metric import Margin, Metric, Requirement


def search_line(result: SearchResult) -> str:
    """What a search found, in one line."""
    search, name = result.search, result.search.name
    if result.found.error:
        return f"error {name}: {result.found.error}"
    scale = isinstance(search, ScaleSearch)
    mark = {None: "scale" if scale else "speed", True: "pass ", False: "FAIL "}[result.passed]
    what = f"smallest scale: {found_words(result)} a map unit" if scale else f"top speed: {found_words(result)}"
    beside = beside_words(result)
    if beside:
        what += f" ({beside})" if scale else f", {beside}"
    return f"{mark} {name}: {'; '.join(filter(None, (what, failing_words(result))))}"


def found_words(result: SearchResult) -> str:
    """ "3.42 m", "13.1 m/s (47.3 km/h)"; the range's end where all of it is trackworthy, or none."""
    near, far = result.search.ends
    scale = isinstance(result.search, ScaleSearch)
    if result.found.at is None:
        end = _quantity(result, near)
        return f"none up to {end}" if scale else f"none from {end} up"
    if result.found.failing is None:
        return f"at {'most' if scale else 'least'} {_quantity(result, far)}"
    return _quantity(result, result.found.at)


def beside_words(result: SearchResult) -> str:
    """Width and height of the map at the smallest scale, "3.42 × 2.26 km"; the speed that a path was planned for."""
    search, at = result.search, result.found.at
    if isinstance(search, SpeedSearch):
        return f"planned for {_quantity(result, search.planned_for)}" if search.planned_for else ""
    if at is None or result.size is None:
        return ""
    factor, unit = (1.0, "m") if max(result.size) * at < KILO else (1.0 / KILO, "km")
    width, height = (side * at * factor for side in result.size)
    return f"{number(width)} × {number(height)} {unit}"


def failing_words(result: SearchResult) -> str:
    """What is missed at the next that fails: "at 3.36 m: cross-track error 31 m > 30 m at 1.2 km"."""
    step = result.found.failing
    return f"at {_quantity(result, step.at)}: {_reason(step)}" if step else ""


def search_tables(results: Sequence[SearchResult]) -> list[Json]:
    """The searches as the report's template reads them: a table for scales, one for speeds."""
    scales = [one for one in results if isinstance(one.search, ScaleSearch)]
    speeds = [one for one in results if isinstance(one.search, SpeedSearch)]
    tables: list[tuple[str, list[str], list[SearchResult]]] = [
        (
            "Smallest scale at which the plan is trackworthy",
            ["planner, vehicle", "metres a map unit", "map", "what is missed just below"],
            scales,
        ),
        (
            "Top speed at which the path is trackworthy",
            ["path, vehicle", "top speed", "planned for", "what is missed just above"],
            speeds,
        ),
    ]
    return [
        {"title": title, "head": ["search", *head], "rows": [_row(one) for one in found]}
        for title, head, found in tables
        if found
    ]


def _row(result: SearchResult) -> Json:
    search, error = result.search, result.found.error
    return {
        "name": search.name,
        "path": search.planner or Path(search.path).name if isinstance(search, SpeedSearch) else search.planner,
        "vehicle": Path(search.vehicle).stem,
        "controller": search.controller,
        "found": "failed to run" if error else found_words(result),
        "beside": beside_words(result).removeprefix("planned for "),
        "missed": error or failing_words(result),
        "passed": False if error else result.passed,
        "expected": _expected(result),
    }


def _expected(result: SearchResult) -> str:
    search = result.search
    if isinstance(search, ScaleSearch):
        limit, bound = search.expect_at_most, "most"
    else:
        limit, bound = (None if search.expect_at_least is None else float(search.expect_at_least)), "least"
    return "" if limit is None else f"expected: at {bound} {_quantity(result, limit)}"


def _quantity(result: SearchResult, value: float) -> str:
    """A scale or a speed."""
    return text(value, "m") if isinstance(result.search, ScaleSearch) else speed_text(value, result.kind)


def _reason(step: Step) -> str:
    if not step.metric:
        return step.reason
    value, limit, s = (math.nan if one is None else one for one in (step.value, step.limit, step.s))
    requirement = Requirement(step.metric, step.comparison, limit)
    metric = Metric(step.metric, value, step.si_unit, s=s, valid=step.value is not None, note=step.reason, who=step.who)
    sign = 1.0 if step.comparison == "<=" else -1.0
    margin = Margin(requirement, metric, sign * (limit - value))
    return missed(margin) + place(margin, step.kind)
