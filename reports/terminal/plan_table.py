"""The terminal's answer to a plan: its facts in a table, or why there is none."""

from __future__ import annotations

import math

from rich import box
from rich.console import Console
from rich.markup import escape
from rich.table import Table
from rich.text import Text

from planners.facts import PlanFacts
from reports.words.quantity import number, text

_UNIT_DIGITS = 6  # significant digits in map units, as papers print them


def print_facts(facts: PlanFacts, console: Console | None = None) -> None:
    """Print the facts, and where no path was found why not, in one line; without a `console`, on standard output."""
    console = console or Console(highlight=False)
    if shown := rows(facts):
        console.print(_table(facts, shown))
    if facts.outcome:
        console.print(Text.assemble((facts.outcome, "bold red"), f": {facts.reason}"), soft_wrap=True)


def rows(facts: PlanFacts) -> list[tuple[str, str, str]]:
    """What is told, each with its value and that in map units, "" where it has none."""
    fleet = len(facts.lengths) > 1
    lengths = [
        ("sum of the paths" if fleet else "length", facts.length),
        ("exact shortest sum" if fleet else "exact shortest path", facts.exact_length),
        ("before smoothing", None if facts.polyline_length == facts.length else facts.polyline_length),
        ("smallest radius", facts.smallest_radius),
        ("clearance", facts.clearance_min),
    ]
    found = [
        (name, text(value, "m", 4), number(value / facts.map_unit, _UNIT_DIGITS))
        for name, value in lengths
        if value is not None and math.isfinite(value)  # a straight path has no smallest radius
    ]
    ratio = facts.length_ratio
    if ratio is not None:
        found.insert(2, ("length over it", number(ratio, 5), ""))
    found += _fleet(facts) if fleet else []
    turns = [
        ("largest turn as drawn", facts.turn_angle_max_deg),
        ("    every map unit", facts.turn_angle_1_unit_deg),
        ("    every 5 map units", facts.turn_angle_5_units_deg),
    ]
    found += [(name, f"{number(angle)}°", "") for name, angle in turns if angle is not None]
    return found + _search(facts)


def _fleet(facts: PlanFacts) -> list[tuple[str, str, str]]:
    """Each path, and the sum after each step."""
    lengths = [(f"path {i}", length) for i, length in enumerate(facts.lengths, start=1)]
    lengths += [(f"after {name}", length) for name, length in facts.stages]
    return [(name, text(length, "m", 4), number(length / facts.map_unit, _UNIT_DIGITS)) for name, length in lengths]


def _search(facts: PlanFacts) -> list[tuple[str, str, str]]:
    if not facts.survivors:
        return []
    converged = "never" if facts.converged is None else f"iteration {facts.converged}"
    arrived = "pigeons within all limits, last" if facts.evaluations else "arrived in the last"
    return [
        ("iterations", str(len(facts.survivors)), ""),
        (arrived, f"{facts.survivors[-1]} of {facts.population}", ""),
        ("within 1 % of the best", converged, ""),
    ]


def _table(facts: PlanFacts, shown: list[tuple[str, str, str]]) -> Table:
    made = Table(
        padding=(0, 2, 0, 0),
        show_edge=False,
        title=escape(f"{facts.planner} on {facts.scenario}, seed {facts.seed}"),
        title_justify="left",
        title_style="bold",
        box=box.SIMPLE_HEAD,
        pad_edge=False,
    )
    made.add_column("plan", no_wrap=True)
    made.add_column("value", justify="right", no_wrap=True)
    scaled = facts.map_unit != 1.0
    if scaled:
        made.add_column("map units", justify="right", no_wrap=True)
    for name, value, units in shown:
        made.add_row(name, value, *([units] if scaled else []))
    return made
