"""Two campaigns side by side, for a terminal."""

from __future__ import annotations

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from campaigns.side_by_side import CasePair, SideBySide
from reports.words.compare_words import case_lines, conclusion, footnote, heads, names, rest_words, rows, telling

_STYLES = {"better": "green", "worse": "bold red"}


def print_side_by_side(found: SideBySide, console: Console | None = None) -> None:
    """Print what was changed, a table for each pair of cases that differs, and what it comes to; without a `console`,
    on standard output.
    """
    console = console or Console(highlight=False)

    def say(words: str, style: str = "") -> None:
        console.print(Text(words, style=style), soft_wrap=True)

    for line in heads(found):
        say(line)
    differ, alike = telling(found)
    for pair in differ:
        say("")
        say(pair.name, "bold")
        for line in case_lines(pair, found):
            say(line)
        made = _table(pair)
        if made.row_count:
            console.print(made)
        if rest := rest_words(pair):
            say(rest, "dim")
    say("")
    if alike:
        say(f"the same: {names(tuple(pair.name for pair in alike))}")
    if note := footnote(found):
        console.print(Text(note, style="dim"))
    say(conclusion(found), "bold")


def _table(pair: CasePair) -> Table:
    made = Table(box=box.SIMPLE_HEAD, padding=0, pad_edge=False, show_edge=False)
    made.add_column("metric", overflow="fold")
    for column in ("A", "B", "B − A", "95 % interval"):
        made.add_column(column, justify="right", no_wrap=True)
    made.add_column("", no_wrap=True)  # the unit
    made.add_column("", no_wrap=True)
    for *cells, outcome in rows(pair):
        made.add_row(*map(Text, cells), Text(outcome, style=_STYLES.get(outcome, "")))
    return made
