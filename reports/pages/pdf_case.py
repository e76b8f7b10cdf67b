"""One case of the PDF as data for its template: every number already words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict

from reports.files.json_result import Json
from reports.words.fleet_words import called, member_name, vehicle_words
from reports.words.infeasible import steep_rows, tight_rows
from reports.words.names import listed
from reports.words.quantity import text
from reports.words.rows import REQUIREMENTS, Row, rows, unmeasured
from reports.words.words import conditions, planet_words, reason, setting
from tracking.metric import Metric
from tracking.outcome import Fleet, Outcome
from tracking.verdict import NOT_TRACKWORTHY

# The worst ones and the first ones, and characters of a note; the JSON result has all
_MOST_PLACES, _MOST_NOTES, _MOST_FLEET_NOTES, _LONGEST_NOTE = 6, 6, 3, 240


def case_data(outcome: Outcome, figure: str, fleet_figure: str, command: str) -> dict[str, Json]:
    """The case as the template `report.typ` reads it; `fleet_figure` is "" for a vehicle that is alone."""
    verdict, feasibility = outcome.verdict, outcome.feasibility
    table: list[dict[str, Json]] = [_row(row, outcome.limits.kind) for row in rows(outcome)]
    about, notes = _common_source(outcome.notes)
    return {
        "name": outcome.name,
        "vehicle": vehicle_words(outcome),
        "controller": outcome.controller,
        "conditions": list(conditions(outcome)),
        "corridor": text(outcome.corridor, "m"),
        "path": _paths(outcome),
        "seed": outcome.seed,
        "setting": " · ".join([setting(outcome), *planet_words(outcome)]),
        "trackworthy": verdict.trackworthy,
        "passed": verdict.passed,
        "expected": verdict.expect != NOT_TRACKWORTHY,
        "reason": reason(outcome),
        "requirements": [row for row in table if row["group"] == REQUIREMENTS],
        "metrics": [row for row in table if row["group"] != REQUIREMENTS],
        "tight": [asdict(row) for row in tight_rows(feasibility, _MOST_PLACES)],
        "tight_count": len(feasibility.stretches),
        "steep": [asdict(row) for row in steep_rows(feasibility, _MOST_PLACES)],
        "steep_count": len(feasibility.steep),
        "notes": [_cut(note) for note in notes[: _MOST_FLEET_NOTES if outcome.fleet else _MOST_NOTES]],
        "notes_about": about,
        "notes_count": len(notes),
        "unmeasured": list(unmeasured(outcome, listed)),
        "command": command,
        "figure": figure,
        "fleet": fleet_figure,
        "shown": member_name(outcome),
        "members": _members(outcome.fleet) if outcome.fleet else [],
    }


def _paths(outcome: Outcome) -> str:
    """ "path 12.3 km", or the lengths of all of a fleet: "paths 12.3 km, 8 km and 9.1 km"."""
    if not outcome.fleet:
        return f"path {text(outcome.path.length, 'm')}"
    *first, last = (text(member.path.length, "m") for member in outcome.fleet.members)
    return f"paths {', '.join(first)} and {last}"


def _row(row: Row, kind: str) -> dict[str, Json]:
    """A row whose places say whose they are: "64.7 km, aircraft 1"."""
    who = called(row.who, kind)
    places = {name: f"{place}, {who}" for name, place in (("at", row.at), ("when", row.when)) if place}
    whose = places if who else {}
    if who and not places:
        whose = {"when": who}
    return {**asdict(row), "words": listed(row.name), **whose}


def _members(fleet: Fleet) -> list[Json]:
    """What each member of a fleet is alone, separations aside."""
    pairs = enumerate(zip(fleet.members, fleet.departures, strict=True), start=1)
    return [_member(member, number, departure) for number, (member, departure) in pairs]


def _member(member: Outcome, number: int, departure: float) -> dict[str, Json]:
    metrics = member.metrics
    return {
        "name": called(str(number), member.limits.kind),
        "length": text(member.path.length, "m"),
        "departure": text(departure, "s"),
        "trackworthy": member.verdict.trackworthy,
        "p95": _told(metrics, "cross_track_p95"),
        "largest": _told(metrics, "cross_track_max"),
        "clearance": _told(metrics, "clearance_min"),
        "fuel": _told(metrics, "fuel_used"),
        "fuel_range": _told(metrics, "fuel_range"),
        "why": reason(member),
    }


def _told(metrics: Mapping[str, Metric], name: str) -> str:
    return text(metrics[name].value, metrics[name].unit) if name in metrics else ""


def _cut(note: str) -> str:
    return note if len(note) <= _LONGEST_NOTE else f"{note[: _LONGEST_NOTE - 1]}…"


def _common_source(notes: tuple[str, ...]) -> tuple[str, tuple[str, ...]]:
    """The file that every note starts with, said once, and the notes without it; "" where they do not share one."""
    source = notes[0].partition(": ")[0] if notes else ""
    if not source or not all(note.startswith(f"{source}: ") for note in notes):
        return "", notes
    return source, tuple(note.removeprefix(f"{source}: ") for note in notes)
