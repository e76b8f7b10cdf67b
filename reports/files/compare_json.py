"""Two campaigns side by side as JSON, for machines."""

from __future__ import annotations

import json
from typing import Any

from campaigns.difference import BETTER, MIXED, SAME, WORSE, Difference
from campaigns.side_by_side import CasePair, Change, Side, SideBySide
from campaigns.summary import CaseResult
from planners.units import degrees


def side_by_side_json(found: SideBySide) -> str:
    """Everything that was compared, in SI units but angles in degrees; null for what there is not."""
    told = {
        "a": _side(found.a),
        "b": _side(found.b),
        "made": [_change(change) for change in found.made],
        "summary": {
            **{outcome: found.count(outcome) for outcome in (BETTER, WORSE, MIXED, SAME)},
            "verdicts_changed": found.verdicts_changed,
        },
        "pairs": [_pair(pair) for pair in found.pairs],
        "only_a": found.only_a,
        "only_b": found.only_b,
    }
    return json.dumps(told, indent=2, allow_nan=False)


def _side(side: Side) -> dict[str, Any]:
    return {
        "folder": str(side.folder),
        "campaign": side.campaign.name,
        "seed": side.campaign.seed,
        "git_revision": side.manifest.git_revision,
        "cases": len(side.results),
        "trials": side.campaign.trials,
    }


def _change(change: Change) -> dict[str, Any]:
    return {"key": change.key, "a": change.old, "b": change.new}


def _pair(pair: CasePair) -> dict[str, Any]:
    return {
        "a": _case(pair.a),
        "b": _case(pair.b),
        "outcome": pair.outcome,
        "verdict_changed": pair.verdict_changed,
        "changes": [_change(change) for change in pair.changes],
        "differences": [_difference(one) for one in pair.differences],
    }


def _case(result: CaseResult) -> dict[str, Any]:
    found = result.statistics
    return {
        "name": result.case.name,
        "verdict": result.verdict,
        "tried": found.tried,
        "errors": found.errors,
        "trackworthy": found.trackworthy,
        "share_interval": found.interval,
    }


def _difference(one: Difference) -> dict[str, Any]:
    factor, unit = degrees(1.0, one.unit)
    return {
        "metric": one.metric,
        "unit": unit,
        "better": one.direction,
        "a": factor * one.before,
        "b": factor * one.after,
        "change": factor * one.change,
        "interval": None if one.interval is None else [factor * end for end in one.interval],
        "pairs": one.pairs,
        "limit": factor * one.limit,
        "outcome": one.outcome,
    }
