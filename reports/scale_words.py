"""What the searches for the smallest scale found, as lines of text and as rows of a table."""

from __future__ import annotations

import math
from pathlib import Path

from campaigns.scale_steps import Step
from campaigns.scales import ScaleResult
from reports.quantity import number, text
from reports.words import missed, place
from tracking.metric import Margin, Metric, Requirement


def scale_line(result: ScaleResult) -> str:
    """What a search found, in one line."""
    name = result.search.name
    if result.found.error:
        return f"error {name}: {result.found.error}"
    mark = {None: "scale", True: "pass ", False: "FAIL "}[result.passed]
    size = f" ({size_words(result)})" if result.found.unit else ""
    told = [f"smallest scale: {scale_words(result)}{size}", failing_words(result)]
    return f"{mark} {name}: {'; '.join(filter(None, told))}"


def scale_words(result: ScaleResult) -> str:
    """ "3.42 m a map unit"; the range's end where all of it is trackworthy, or none."""
    low, high = result.search.between
    if result.found.unit is None:
        return f"none up to {text(high, 'm')} a map unit"
    at_most = "" if result.found.failing else "at most "
    return f"{at_most}{text(result.found.unit if result.found.failing else low, 'm')} a map unit"


def size_words(result: ScaleResult) -> str:
    """Width and height of the map at the smallest scale: "3.42 x 2.26 km"; "" where there is none."""
    if result.found.unit is None:
        return ""
    width, height = (side * result.found.unit / 1000.0 for side in result.size)
    return f"{number(width)} × {number(height)} km"


def failing_words(result: ScaleResult) -> str:
    """What is missed at the largest scale that fails: "at 3.36 m: cross-track error 31 m > 30 m at 1.2 km"."""
    step = result.found.failing
    return f"at {text(step.unit, 'm')}: {_reason(step)}" if step else ""


def scale_row(result: ScaleResult) -> dict[str, str | bool | None]:
    """The search as the report's template reads it."""
    search, error = result.search, result.found.error
    limit = search.expect_at_most
    return {
        "name": search.name,
        "planner": search.planner,
        "vehicle": Path(search.vehicle).stem,
        "controller": search.controller,
        "scale": "failed to run" if error else scale_words(result).removesuffix(" a map unit"),
        "size": size_words(result),
        "missed": error or failing_words(result),
        "passed": False if error else result.passed,
        "expected": "" if limit is None else f"expected: at most {text(limit, 'm')}",
    }


def _reason(step: Step) -> str:
    if not step.metric:
        return step.reason
    value, limit, s = (math.nan if one is None else one for one in (step.value, step.limit, step.s))
    requirement = Requirement(step.metric, step.comparison, limit)
    metric = Metric(step.metric, value, step.si_unit, s=s, valid=step.value is not None, note=step.reason, who=step.who)
    sign = 1.0 if step.comparison == "<=" else -1.0
    margin = Margin(requirement, metric, sign * (limit - value))
    return missed(margin) + place(margin, step.kind)
