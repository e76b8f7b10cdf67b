"""One case of the PDF as data for its template: every number already words."""

from __future__ import annotations

from dataclasses import asdict

from reports.fleet_words import vehicle_words
from reports.infeasible import steep_rows, tight_rows
from reports.json_result import Json
from reports.names import listed
from reports.quantity import text
from reports.rows import REQUIREMENTS, rows, unmeasured
from reports.words import conditions, reason, setting
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

_MOST_PLACES, _MOST_NOTES = 6, 6  # the worst ones and the first ones; the JSON result has all


def case_data(outcome: Outcome, figure: str, command: str) -> dict[str, Json]:
    """The case as the template `report.typ` reads it."""
    verdict, feasibility = outcome.verdict, outcome.feasibility
    table: list[dict[str, Json]] = [{**asdict(row), "words": listed(row.name)} for row in rows(outcome)]
    about, notes = _common_source(outcome.notes)
    return {
        "name": outcome.name,
        "vehicle": vehicle_words(outcome),
        "controller": outcome.controller,
        "conditions": list(conditions(outcome)),
        "corridor": text(outcome.corridor, "m"),
        "length": text(outcome.path.length, "m"),
        "seed": outcome.seed,
        "setting": setting(outcome),
        "trackworthy": verdict.trackworthy,
        "passed": verdict.passed,
        "expected": verdict.expect == TRACKWORTHY,
        "reason": reason(outcome),
        "requirements": [row for row in table if row["group"] == REQUIREMENTS],
        "metrics": [row for row in table if row["group"] != REQUIREMENTS],
        "tight": [asdict(row) for row in tight_rows(feasibility, _MOST_PLACES)],
        "tight_count": len(feasibility.stretches),
        "steep": [asdict(row) for row in steep_rows(feasibility, _MOST_PLACES)],
        "steep_count": len(feasibility.steep),
        "notes": list(notes[:_MOST_NOTES]),
        "notes_about": about,
        "notes_count": len(notes),
        "unmeasured": list(unmeasured(outcome, listed)),
        "command": command,
        "figure": figure,
    }


def _common_source(notes: tuple[str, ...]) -> tuple[str, tuple[str, ...]]:
    """The file that every note starts with, said once, and the notes without it; "" where they do not share one."""
    source = notes[0].partition(": ")[0] if notes else ""
    if not source or not all(note.startswith(f"{source}: ") for note in notes):
        return "", notes
    return source, tuple(note.removeprefix(f"{source}: ") for note in notes)
