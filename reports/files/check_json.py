"""What a check found, as JSON for machines."""

from __future__ import annotations

import dataclasses
import json

from campaigns.gate import Check, Finding
from reports.terminal.check_text import told


def check_json(check: Check) -> str:
    """The findings with old, new and limit, and every comparison; angles in degrees."""
    told = {
        "campaign": check.campaign,
        "passed": not check.findings,
        "findings": [_finding(finding) for finding in check.findings],
        "comparisons": [dataclasses.asdict(one) for one in check.comparisons],
    }
    return json.dumps(told, indent=2)


def _finding(finding: Finding) -> dict[str, object]:
    content = {**dataclasses.asdict(finding), "message": told(finding)}
    comparison = content.pop("comparison") or {}
    keys = ("metric", "unit", "old", "new", "worse", "limit")
    return {**content, **{key: comparison.get(key) for key in keys}}
