"""How far a campaign is: a bar on a terminal, plain lines elsewhere, on standard error."""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from campaigns.attempt import Attempt
from campaigns.runner import Task
from reports.words.quantity import counted, number

EVERY = 10.0  # [s] between plain lines

Results = Iterable[tuple[Task, Attempt]]


def watched(results: Results, tasks: Sequence[Task], total: int) -> Iterator[Attempt]:
    """Pass the results of `tasks` on, showing how many of `total` trials are done, those of earlier runs included."""
    tally = _Tally(tasks, total)
    if total and not tasks:
        print(f"all {total} trials are done; the report follows", file=sys.stderr)
    on_terminal = sys.stderr.isatty()  # not what FORCE_COLOR makes rich believe
    yield from _bar(results, tally, Console(stderr=True)) if on_terminal else _lines(results, tally)


def _bar(results: Results, tally: _Tally, console: Console) -> Iterator[Attempt]:
    news = TextColumn("{task.fields[news]}")
    columns = (TextColumn("trials"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), news)
    with Progress(*columns, console=console, transient=True) as progress:
        bar = progress.add_task("trials", total=tally.total, completed=tally.done, news="")
        for task, result in results:
            tally.count(task, result)
            progress.update(bar, advance=1, news=tally.news())
            yield result


def _lines(results: Results, tally: _Tally) -> Iterator[Attempt]:
    last = time.monotonic()
    for task, result in results:
        tally.count(task, result)
        if time.monotonic() - last >= EVERY or tally.done == tally.total:
            last = time.monotonic()
            left = f"{tally.seconds_left():.0f} s left, " if tally.done < tally.total else ""
            print(f"{tally.done}/{tally.total} trials, {left}{tally.news()}", file=sys.stderr)
        yield result


class _Tally:
    """Counts trials, cases and what went wrong."""

    def __init__(self, tasks: Sequence[Task], total: int) -> None:
        self.total, self.done = total, total - len(tasks)
        self._start, self._first = time.monotonic(), self.done
        self._open = Counter(task.ready.number for task in tasks)
        self._cases = len(self._open)
        self._unexpected = self._errors = 0

    def count(self, task: Task, result: Attempt) -> None:
        self.done += 1
        self._open[task.ready.number] -= 1
        self._errors += bool(result.error)
        self._unexpected += not result.error and not result.passed

    def news(self) -> str:
        finished = sum(left == 0 for left in self._open.values())
        parts = [f"{finished}/{self._cases} cases", f"{number(self._rate())} trials/s"]
        parts += [f"{counted(self._unexpected, 'trial')} not as expected"] if self._unexpected else []
        parts += [counted(self._errors, "error")] if self._errors else []
        return ", ".join(parts)

    def seconds_left(self) -> float:
        return (self.total - self.done) / self._rate()

    def _rate(self) -> float:
        return (self.done - self._first) / max(time.monotonic() - self._start, 1e-3)
