"""Worker processes that may die or hang: each costs the one task it was on, and is replaced."""

from __future__ import annotations

import atexit
import contextlib
import multiprocessing
import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import connection
from typing import Any, ParamSpec, TypeVar

from planners.errors import TrackworthyError

P = ParamSpec("P")
T = TypeVar("T")

GRACE = 5.0  # [s] for a worker to leave when told to, before it is killed
START_UP = 60.0  # [s] more for a process's first task: it loads simulators, and may compile kernels


class WorkerDiedError(TrackworthyError):
    """The process that worked on a task died, of a fault in a simulator or killed from outside."""


class WorkerTimedOutError(TrackworthyError):
    """A task took longer than it may, and its process was killed."""


class Workers(Executor):
    """As many spawn-started processes as `jobs`, each with a thread here that feeds it one task at a time.

    Each process has a `ProcessPoolExecutor` of its own: when it dies, it is known which task it was on. A task that
    takes longer than `timeout` [s] is killed with its process.
    """

    def __init__(self, jobs: int, timeout: float) -> None:
        self._timeout = timeout
        self._tasks: queue.SimpleQueue[tuple[Future[Any], Callable[[], Any]] | None] = queue.SimpleQueue()
        self._processes: set[int] = set()
        self._closed = False
        self._threads = [threading.Thread(target=self._feed, daemon=True) for _ in range(jobs)]
        for thread in self._threads:
            thread.start()

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        """Run `fn` in a worker; its future may raise `WorkerDiedError` or `WorkerTimedOutError`."""
        future: Future[T] = Future()
        self._tasks.put((future, _Call(fn, args, kwargs)))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let go of the workers; with `cancel_futures`, at once: what they are on is lost."""
        self._closed = cancel_futures
        for _ in self._threads:
            self._tasks.put(None)
        if cancel_futures:
            self._stop_all()
        if wait:
            for thread in self._threads:
                thread.join()

    def _stop_all(self) -> None:
        """Tell every process to leave, and kill those that do not."""
        end = time.monotonic() + GRACE
        while any(thread.is_alive() for thread in self._threads):
            late = time.monotonic() > end
            for pid in list(self._processes):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL if late else signal.SIGTERM)
            for thread in self._threads:
                thread.join(0.2)

    def _feed(self) -> None:
        """The life of one worker and its successors."""
        # Ctrl-C is for the coordinator: a process started by this thread inherits that the signal is blocked
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        worker: _Worker | None = None
        while (task := self._tasks.get()) is not None:
            future, call = task
            if self._closed or not future.set_running_or_notify_cancel():
                future.cancel()
                continue
            try:
                worker = worker or _Worker(self._processes)
                future.set_result(worker.run(call, self._timeout))
            except (WorkerDiedError, WorkerTimedOutError) as error:
                worker = None
                future.set_exception(error)
            except BaseException as error:
                future.set_exception(error)
        if worker is not None:
            worker.close()


class _Call:
    """A function with its arguments, picklable."""

    def __init__(self, fn: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        self.fn, self.args, self.kwargs = fn, args, kwargs

    def __call__(self) -> Any:
        return self.fn(*self.args, **self.kwargs)


class _Worker:
    """One process."""

    def __init__(self, processes: set[int]) -> None:
        context = multiprocessing.get_context("spawn")
        self._pool = ProcessPoolExecutor(1, mp_context=context, initializer=_prepare_process)
        self._processes, self._start_up = processes, START_UP
        try:
            self._pid = self._pool.submit(os.getpid).result()
        except BrokenProcessPool as error:
            self._pool.shutdown()
            raise WorkerDiedError("a worker process died while it started") from error
        processes.add(self._pid)

    def run(self, call: Callable[[], T], timeout: float) -> T:
        future = self._pool.submit(call)
        start_up, self._start_up = self._start_up, 0.0
        try:
            return future.result(timeout + start_up)
        except (BrokenProcessPool, SystemExit):  # the latter where it was told to leave
            self.close()
            raise WorkerDiedError("the process that ran it died") from None
        except TimeoutError:
            if future.done():  # the task's own
                raise
            with contextlib.suppress(ProcessLookupError):
                os.kill(self._pid, signal.SIGKILL)
            self.close()
            raise WorkerTimedOutError(f"it took longer than {timeout:g} s") from None

    def close(self) -> None:
        self._pool.shutdown()
        self._processes.discard(self._pid)


def _prepare_process() -> None:
    """In a new worker: chatter to standard error, an orderly end when told, and none without a parent."""
    os.dup2(2, 1)
    signal.signal(signal.SIGTERM, _leave)
    sys.unraisablehook = _tell_unraisable
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_leave_with, args=(parent.sentinel,), daemon=True).start()


def _leave(*_: object) -> None:
    raise SystemExit(0)


def _tell_unraisable(one: sys.UnraisableHookArgs) -> None:
    """What cannot be raised is told, but for our own leaving, where that meets a callback of the compiler."""
    if not isinstance(one.exc_value, SystemExit):
        sys.__unraisablehook__(one)


def _leave_with(sentinel: int) -> None:
    """Leave when the parent is gone, even if it was killed: first in order, then whatever happens."""
    connection.wait([sentinel])
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE)
    atexit._run_exitfuncs()
    os._exit(1)
