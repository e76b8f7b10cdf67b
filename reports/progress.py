"""How far a campaign is: a bar on a terminal, plain lines elsewhere, on standard error."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from typing import TypeVar

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

T = TypeVar("T")


def watched(results: Iterable[T], total: int) -> Iterator[T]:
    """Pass `results` on, showing how many of the `total` cases are done."""
    console = Console(stderr=True)
    if not console.is_terminal:
        for done, result in enumerate(results, start=1):
            print(f"{done}/{total} cases done", file=sys.stderr)
            yield result
        return
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("cases", total=total)
        for result in results:
            progress.advance(task)
            yield result
