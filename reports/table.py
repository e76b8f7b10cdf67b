"""The terminal's answer: every metric in a table, then the verdict in one line."""

from __future__ import annotations

from rich import box
from rich.console import Console
from rich.markup import escape
from rich.table import Table
from rich.text import Text

from reports.rows import REQUIREMENTS, Row, rows, unmeasured
from reports.words import reason, setting, verdict_words
from tracking.outcome import Outcome


def print_outcome(outcome: Outcome, console: Console | None = None) -> None:
    """Print table, notes and verdict of one run; without a `console`, on standard output.

    Colour, and the width, are the terminal's; piped, rich leaves the colour out and takes COLUMNS or 80.
    """
    console = console or Console(highlight=False)
    console.print(table(outcome))
    console.print()
    for line in unmeasured(outcome):
        console.print(Text(f"n/a: {line}", style="dim"), soft_wrap=True)
    for note in outcome.notes:
        console.print(Text(f"note: {note}", style="dim"), soft_wrap=True)
    console.print(verdict_line(outcome), soft_wrap=True)


def verdict_line(outcome: Outcome) -> Text:
    """`words.sentence` with its verdict in bold and in colour."""
    style = "bold green" if outcome.verdict.trackworthy else "bold red"
    return Text.assemble((verdict_words(outcome), style), f"  {setting(outcome)}: {reason(outcome)}")


def table(outcome: Outcome) -> Table:
    """The metrics: requirements first with limit and margin, then the others group by group."""
    made = Table(
        padding=0,
        show_edge=False,
        title=escape(outcome.name),
        title_justify="left",
        title_style="bold",
        box=box.SIMPLE_HEAD,
        pad_edge=False,
    )
    made.add_column("metric", no_wrap=True)
    for column in ("value", "limit", "margin", "at", "time"):
        made.add_column(column, justify="right", overflow="fold")
    group = REQUIREMENTS
    for row in rows(outcome):
        if row.group != group:
            group = row.group
            made.add_section()
            made.add_row(Text(group, style="bold dim"))
        made.add_row(*_cells(row))
    return made


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
