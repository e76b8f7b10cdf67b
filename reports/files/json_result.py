"""One run as plain values for machines: what `--json` prints."""

from __future__ import annotations

import math
from importlib.metadata import PackageNotFoundError, version

from planners.units import degrees
from reports.words.infeasible import turned
from reports.words.words import reason, sentence
from tracking.feasibility import Feasibility, Slope, Stretch
from tracking.metric import SCHEMA_VERSION, Margin, Metric
from tracking.outcome import Fleet, Outcome
from tracking.separation import STEP, Separation, nearest
from tracking.verdict import NOT_TRACKWORTHY, TRACKWORTHY

# Of what is told of a run, that which is a fleet member's own
_OF_MEMBER = ("verdict", "reason", "decided_by", "ended", "seed", "path", "requirements", "metrics", "feasibility")

Json = dict[str, "Json"] | list["Json"] | str | float | int | bool | None


def to_json(outcome: Outcome) -> dict[str, Json]:
    """`outcome` as JSON values: SI units, angles in degrees with unit "deg", null where there is no number."""
    verdict, limits, wind = outcome.verdict, outcome.limits, outcome.conditions.wind
    decided = verdict.decisive
    frame = outcome.track.frame or outcome.path.frame
    return {
        "name": outcome.name,
        "verdict": TRACKWORTHY if verdict.trackworthy else NOT_TRACKWORTHY,
        "trackworthy": verdict.trackworthy,
        "expected": verdict.expect,
        "passed": verdict.passed,
        "sentence": sentence(outcome),
        "reason": reason(outcome),
        "decided_by": decided.metric.name if decided else None,
        "ended": outcome.track.ended,
        "vehicle": {"name": outcome.vehicle, "kind": limits.kind},
        "controller": outcome.controller,
        "speed": outcome.speed,
        "corridor": outcome.corridor,
        "wind": {"speed": wind.speed, "from_deg": wind.from_deg if wind.speed > 0.0 else None},
        "seed": outcome.seed,
        "path": {
            "name": outcome.path.name,
            "points": len(outcome.path.points),
            "length": outcome.path.length,
            "origin": {"lat": frame.lat, "lon": frame.lon} if frame else None,
        },
        "requirements": [_requirement(margin) for margin in verdict.margins],
        "metrics": {name: _metric(metric) for name, metric in outcome.metrics.items()},
        "feasibility": {
            "turns": len(outcome.feasibility.turns),
            "infeasible": [_stretch(outcome.feasibility, stretch) for stretch in outcome.feasibility.stretches],
            "steep": [_slope(slope) for slope in outcome.feasibility.steep],
        },
        "fleet": _fleet(outcome.fleet) if outcome.fleet else None,
        "notes": list(outcome.notes),
        "versions": {"trackworthy": _version(), "schema": SCHEMA_VERSION},
    }


def _fleet(fleet: Fleet) -> Json:
    """Departures and remedy [s], separations [m], and what each member is alone; vehicles are numbered from 1."""
    members = [to_json(member) for member in fleet.members]
    return {
        "decided_by": fleet.member + 1,
        "departures": list(fleet.departures),
        "separation_required": fleet.required,
        "separation": [_pair(fleet.apart, column) for column in range(len(fleet.apart.pairs))],
        "remedy": list(fleet.remedy) or None,
        "members": [{key: told[key] for key in _OF_MEMBER} for told in members],
    }


def _pair(apart: Separation, column: int) -> Json:
    """Two vehicles, their smallest distance and when that was; null where they were never under way together."""
    least, step = nearest(apart.vectors[column])
    met = math.isfinite(least)
    pair = [number + 1 for number in apart.pairs[column]]
    return {"pair": [*pair], "min": least if met else None, "t": STEP * step if met else None}


def _requirement(margin: Margin) -> Json:
    metric, requirement = margin.metric, margin.requirement
    limit, unit = degrees(requirement.limit, metric.unit)
    return {
        "metric": requirement.metric,
        "comparison": requirement.comparison,
        "limit": _finite(limit),
        "value": _finite(degrees(metric.value, metric.unit)[0]),
        "margin": _finite(degrees(margin.value, metric.unit)[0]),
        "unit": unit,
        "met": margin.met,
        "s": _finite(metric.s),
        "t": _finite(metric.t),
        "source": requirement.source,
        "who": metric.who,
    }


def _metric(metric: Metric) -> Json:
    value, unit = degrees(metric.value, metric.unit)
    return {
        "value": _finite(value) if metric.valid else None,
        "unit": unit,
        "better": metric.better,
        "valid": metric.valid,
        "s": _finite(metric.s),
        "t": _finite(metric.t),
        "note": metric.note,
        "who": metric.who,
    }


def _stretch(feasibility: Feasibility, stretch: Stretch) -> Json:
    """A stretch too tight; `turn` is over all of it [deg, left positive], the rest at its worst place."""
    left, right = turned(feasibility, stretch)
    worst = stretch.worst
    return {
        "s": stretch.s,
        "s_end": stretch.s_end,
        "x": worst.x,
        "y": worst.y,
        "turn": math.degrees(left - right),
        "available": _finite(worst.available),
        "required": _finite(worst.required),
        "missing": _finite(-worst.margin),
    }


def _slope(slope: Slope) -> Json:
    missing = abs(slope.gradient) - abs(slope.limit)
    return {
        "s": slope.s,
        "s_end": slope.s_end,
        "gradient": slope.gradient,
        "limit": slope.limit,
        "missing": missing,
    }


def _finite(value: float) -> float | None:
    """JSON has no NaN and no infinity."""
    return float(value) if math.isfinite(value) else None


def _version() -> str:
    try:
        return version("trackworthy")
    except PackageNotFoundError:  # run from a checkout that is not installed
        return "unknown"
