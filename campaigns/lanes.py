"""Tasks through an executor, a few at a time, each given back as it finishes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from dataclasses import dataclass
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Lanes:
    """Where tasks run: in `executor`, at most `width` of them under way, so that memory stays flat."""

    executor: Executor
    width: int

    def each(self, tasks: Iterable[T], send: Callable[[Executor, T], Future[R]]) -> Iterator[tuple[T, Future[R]]]:
        """Every task with its finished future, as they finish."""
        pending: dict[Future[R], T] = {}
        for task in tasks:
            pending[send(self.executor, task)] = task
            while len(pending) >= self.width:
                yield from _finished(pending)
        while pending:
            yield from _finished(pending)


def _finished(pending: dict[Future[R], T]) -> Iterator[tuple[T, Future[R]]]:
    done, _ = wait(pending, return_when=FIRST_COMPLETED)
    for future in done:
        yield pending.pop(future), future
