"""A plan as one JSON object, for other programs."""

from __future__ import annotations

import msgspec

from planners.facts import PlanFacts
from planners.planner import Plan


def plan_json(facts: PlanFacts, plan: Plan) -> str:
    """The facts with `length_ratio`, and `path`: its points as rows of x, y[, z] [m], null where there is none.

    What is not finite, as the radius of a straight path, is null too."""
    points = plan.paths[0].points.tolist() if plan.paths else None
    told = {**msgspec.to_builtins(facts), "length_ratio": facts.length_ratio, "path": points}
    return msgspec.json.format(msgspec.json.encode(told), indent=2).decode()
