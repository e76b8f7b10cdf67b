"""One case of the PDF as data for its template: every number already words."""

from __future__ import annotations

import math
from dataclasses import asdict

from reports.deciding import deciding
from reports.json_result import Json
from reports.quantity import pair, reading_unit, text
from reports.rows import REQUIREMENTS, rows, unmeasured
from reports.words import reason, setting, speed_words, wind_words
from tracking.feasibility import Slope, Turn
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

_MOST_TURNS = 12  # in the table, the worst ones; the JSON result has all


def case_data(outcome: Outcome, figure: str, command: str) -> dict[str, Json]:
    """The case as the template `report.typ` reads it."""
    verdict, feasibility = outcome.verdict, outcome.feasibility
    table = [asdict(row) for row in rows(outcome)]
    worst = sorted(sorted(feasibility.tight, key=lambda turn: turn.margin)[:_MOST_TURNS], key=lambda turn: turn.s)
    return {
        "name": outcome.name,
        "vehicle": outcome.vehicle,
        "controller": outcome.controller,
        "speed": speed_words(outcome),
        "wind": wind_words(outcome.conditions.wind).removeprefix("wind "),
        "corridor": text(outcome.corridor, "m"),
        "length": text(outcome.path.length, "m"),
        "seed": outcome.seed,
        "setting": setting(outcome),
        "trackworthy": verdict.trackworthy,
        "passed": verdict.passed,
        "expected": verdict.expect == TRACKWORTHY,
        "deciding": _deciding(outcome),
        "reason": reason(outcome),
        "requirements": [row for row in table if row["group"] == REQUIREMENTS],
        "metrics": [row for row in table if row["group"] != REQUIREMENTS],
        "tight": [_turn(turn) for turn in worst],
        "tight_count": len(feasibility.tight),
        "turn_count": len(feasibility.turns),
        "steep": [_slope(slope) for slope in feasibility.steep[:_MOST_TURNS]],
        "steep_count": len(feasibility.steep),
        "notes": list(outcome.notes),
        "unmeasured": list(unmeasured(outcome)),
        "command": command,
        "figure": figure,
    }


def _deciding(outcome: Outcome) -> Json:
    margin = deciding(outcome.verdict)
    if margin is None:
        return None
    value, limit = pair(margin.metric.value, margin.requirement.limit, reading_unit(margin.metric), margin.met)
    comparison = "≤" if margin.requirement.comparison == "<=" else "≥"
    return {"metric": margin.metric.name, "value": value, "limit": f"{comparison} {limit}", "met": margin.met}


def _turn(turn: Turn) -> Json:
    return {
        "at": text(turn.s, "m"),
        "place": f"{text(turn.x, 'm')}, {text(turn.y, 'm')}",
        "turn": f"{text(abs(turn.angle), 'rad')} {'left' if turn.angle > 0.0 else 'right'}",
        "required": text(turn.required, "m"),
        "available": text(turn.available, "m"),
        "missing": text(-turn.margin, "m"),
    }


def _slope(slope: Slope) -> Json:
    return {
        "from": text(slope.s, "m"),
        "to": text(slope.s_end, "m"),
        "gradient": text(slope.gradient, "share"),
        "limit": text(math.copysign(slope.limit, slope.gradient), "share"),
        "missing": text(abs(slope.gradient) - abs(slope.limit), "share"),
    }
