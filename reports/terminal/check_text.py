"""What a check found, for a terminal: a table a case, and the commands that show it."""

from __future__ import annotations

from itertools import groupby

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from campaigns.comparison import Comparison
from campaigns.gate import WORSE, Check, Finding
from reports.words.quantity import counted, number

_MOST_IMPROVED, _DIGITS = 3, 4


def print_check(check: Check, console: Console | None = None) -> None:
    """Print what was found, how to see it, and what it comes to; without a `console`, on standard output."""
    console = console or Console(highlight=False)
    for finding in check.findings:
        if finding.comparison is None:
            words = Text.assemble((finding.kind, "bold red"), f"  {finding.case}: {finding.message}")
            console.print(words, soft_wrap=True)
    worse = [finding for finding in check.findings if finding.kind == WORSE]
    for _, of_case in groupby(worse, lambda finding: finding.case):
        console.print(_table(list(of_case)))
    if commands := {finding.command: shown_by(finding) for finding in check.findings if finding.command}:
        console.print()
        for command, what in commands.items():
            console.print(f"{what}:\n  {command}", soft_wrap=True, markup=False, emoji=False)
    if check.improved:
        console.print(f"improved: {improved_words(check)}", soft_wrap=True, markup=False, emoji=False)
    style = "bold red" if check.findings else "bold green"
    console.print(Text(conclusion(check), style=style), soft_wrap=True)


def told(finding: Finding) -> str:
    """What was found, in a sentence."""
    one = finding.comparison
    if one is None:
        return finding.message
    old, new, worse, allowed = (with_unit(value, one) for value in (one.old, one.new, one.worse, one.limit))
    return f"{one.metric} was {old}, is {new}: worse by {worse}, allowed {allowed}"


def shown_by(finding: Finding) -> str:
    """Which trial shows it most."""
    return f"worst in trial {finding.trial} (seed {finding.seed})"


def with_unit(value: float, one: Comparison) -> str:
    """A value of the comparison with its unit."""
    amount, unit = _amount(value, one)
    space = "" if unit.startswith("°") else " "
    return f"{amount}{space}{unit}" if unit else amount


def _amount(value: float, one: Comparison) -> tuple[str, str]:
    """The number and the unit as shown."""
    if one.unit == "share":
        return number(100.0 * value, _DIGITS), "%"
    return number(value, _DIGITS), "" if one.unit == "1" else one.unit.replace("^2", "²").replace("deg", "°")


def improved_words(check: Check) -> str:
    """What got better, and that the baseline could follow."""
    words = [
        f"{one.case}: {one.metric} {with_unit(one.old, one)} to {with_unit(one.new, one)}" for one in check.improved
    ]
    more = f" and {len(words) - _MOST_IMPROVED} more" if len(words) > _MOST_IMPROVED else ""
    return f"{'; '.join(words[:_MOST_IMPROVED])}{more}; --update makes that the baseline"


def conclusion(check: Check) -> str:
    """The answer in one line."""
    cases = counted(len({one.case for one in check.comparisons}), "case")
    compared = f"{counted(len(check.comparisons), 'metric')} of {cases} compared"
    if not check.findings:
        return f"AS GOOD AS THE BASELINE  {compared}"
    worse = sum(finding.kind == WORSE for finding in check.findings)
    others = len(check.findings) - worse
    parts = [f"{worse} worse"] if worse else []
    parts += [counted(others, "other change")] if others else []
    return f"NOT AS THE BASELINE  {', '.join(parts)}; {compared}"


def _table(findings: list[Finding]) -> Table:
    title = Text(findings[0].case, style="bold")
    made = Table(box=box.SIMPLE_HEAD, title=title, title_justify="left", padding=0, pad_edge=False, show_edge=False)
    made.add_column("metric", no_wrap=True)
    for column in ("was", "is", "worse by", "allowed"):
        made.add_column(column, justify="right", no_wrap=True)
    made.add_column("", no_wrap=True)
    made.add_column("trial", justify="right", no_wrap=True, min_width=5)
    for finding in findings:
        one = finding.comparison
        if one is not None:
            shown = [_amount(value, one) for value in (one.old, one.new, one.worse, one.limit)]
            made.add_row(one.metric, *(amount for amount, _ in shown), shown[0][1], str(one.trial))
    return made
