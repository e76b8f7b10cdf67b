"""A plan as one JSON object, for other programs."""

from __future__ import annotations

import msgspec

from planners.facts import PlanFacts
from planners.planner import Plan


def plan_json(facts: PlanFacts, plan: Plan) -> str:
    """The facts with `length_ratio`, and `path`: its points as rows of x, y[, z] [m], null where there is none.

    `paths` has that of each vehicle, with its name. What is not finite, as the radius of a straight path, is null too.
    """
    paths = [{"name": path.name, "points": path.points.tolist()} for path in plan.paths]
    first = paths[0]["points"] if paths else None
    told = {**msgspec.to_builtins(facts), "length_ratio": facts.length_ratio, "path": first, "paths": paths}
    return msgspec.json.format(msgspec.json.encode(told), indent=2).decode()
