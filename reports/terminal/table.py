"""The terminal's answer: every metric in a table, then the verdict in one line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple

from rich import box
from rich.console import Console
from rich.markup import escape
from rich.table import Table
from rich.text import Text

from reports.words.fleet_words import GROUND
from reports.words.infeasible import SteepRow, TightRow, steep_rows, tight_rows
from reports.words.rows import REQUIREMENTS, Row, rows, unmeasured
from reports.words.words import reason, setting, verdict_words
from tracking.outcome import Outcome

_MOST_INFEASIBLE = 8  # in a table, the worst ones; the JSON result has all


def print_outcome(outcome: Outcome, console: Console | None = None) -> None:
    """Print table, what is infeasible, and verdict of one run; without a `console`, on standard output.

    Colour, and the width, are the terminal's; piped, rich leaves the colour out and takes COLUMNS or 80.
    """
    console = console or Console(highlight=False)
    console.print(table(outcome))
    console.print()
    for found in infeasible(outcome):
        console.print(found)
        console.print()
    for line in unmeasured(outcome):
        console.print(Text(f"n/a: {line}", style="dim"), soft_wrap=True)
    console.print(verdict_line(outcome), soft_wrap=True)


def verdict_line(outcome: Outcome) -> Text:
    """`words.sentence` with its verdict in bold and in colour."""
    style = "bold green" if outcome.verdict.trackworthy else "bold red"
    return Text.assemble((verdict_words(outcome), style), f"  {setting(outcome)}: {reason(outcome)}")


def table(outcome: Outcome) -> Table:
    """The metrics: requirements first with limit and margin, then the others group by group."""
    made = _empty(outcome.name, 0)
    made.add_column("metric", no_wrap=True)
    whose = [("vehicle" if outcome.limits.kind == GROUND else "aircraft")] if outcome.fleet else []
    for column in ("value", "limit", "margin", "at", "time", *whose):
        made.add_column(column, justify="right", overflow="fold")
    group = REQUIREMENTS
    for row in rows(outcome):
        if row.group != group:
            group = row.group
            made.add_section()
            made.add_row(Text(group, style="bold dim"))
        made.add_row(*_cells(row), *[Text(row.who, style="dim") for _ in whose])
    return made


def infeasible(outcome: Outcome) -> list[Table]:
    """The turns too tight and the legs too steep for the vehicle, each kind a table of the worst."""
    feasibility = outcome.feasibility
    kinds = (
        ("turns too tight for the vehicle", ("turn", "needs radius", "offers", "missing"), len(feasibility.stretches),
         tight_rows(feasibility, _MOST_INFEASIBLE)),
        ("legs too steep for the vehicle", ("gradient", "limit", "missing"), len(feasibility.steep),
         steep_rows(feasibility, _MOST_INFEASIBLE)),
    )  # fmt: skip
    return [_places(title, columns, count, rows) for title, columns, count, rows in kinds if rows]


def _places(title: str, columns: tuple[str, ...], count: int, rows: Sequence[TightRow | SteepRow]) -> Table:
    made = _empty(f"{title}: {count}", 2)
    made.add_column("where", no_wrap=True)
    for column in columns:
        made.add_column(column, justify="right")
    for row in rows:
        *cells, missing = astuple(row)
        made.add_row(*cells, Text(missing, style="bold red"))
    if count > len(rows):
        made.add_row(Text(f"and {count - len(rows)} more", style="dim"))
    return made


def _empty(title: str, gap: int) -> Table:
    return Table(
        padding=(0, gap, 0, 0),
        show_edge=False,
        title=escape(title),
        title_justify="left",
        title_style="bold",
        box=box.SIMPLE_HEAD,
        pad_edge=False,
    )


def _cells(row: Row) -> tuple[Text, ...]:
    mark, style = {True: ("✓ ", "green"), False: ("✗ ", "bold red"), None: ("", "")}[row.met]
    return (
        Text(mark + row.name, style=style if row.met is False else ""),
        Text(row.value),
        Text(row.limit),
        Text(row.margin, style=style),
        Text(row.at, style="dim"),
        Text(row.when, style="dim"),
    )
