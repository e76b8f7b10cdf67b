"""Trials on the machines of a dask scheduler; results come back over the wire, no disk is shared."""

from __future__ import annotations

import multiprocessing
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any, ParamSpec, TypeVar

from campaigns.manifest import fingerprint
from campaigns.workers import Workers
from planners.errors import InputError, TrackworthyError

P = ParamSpec("P")
T = TypeVar("T")

CONNECT_WITHIN = "10s"


class Cluster(Executor):
    """The workers of the scheduler at `address`, as an executor.

    On each, a task runs in a process of its own, as `Workers` do it: what dies or hangs costs its task, never the dask
    worker. Raises `InputError` where no scheduler answers, or a worker has another trackworthy than this.
    """

    def __init__(self, address: str, timeout: float) -> None:
        connect = _dask_client()
        try:
            self._client: Any = connect(address, timeout=CONNECT_WITHIN, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            what = f"no dask scheduler answers ({' '.join(str(error).split())})"
            raise InputError(f"--dask {address}", what, "give it as tcp://host:8786") from None
        threads = self._client.nthreads()
        if not threads:
            self._client.close()
            raise InputError(f"--dask {address}", "the scheduler has no workers", "start some: dask worker ADDRESS")
        self.width = 2 * sum(threads.values())
        self._timeout = timeout
        self._check_versions(address)
        self._inner = self._client.get_executor(pure=False)

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        """Run `fn` on one of the machines."""
        future: Future[T] = self._inner.submit(_in_own_process, self._timeout, fn, args, kwargs)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let go of the scheduler."""
        self._inner.shutdown(wait=wait and not cancel_futures)
        self._client.close()

    def _check_versions(self, address: str) -> None:
        ours = fingerprint()
        for worker, theirs in self._client.run(fingerprint).items():
            if theirs != ours:
                self._client.close()
                what = f"worker {worker} has another version of trackworthy or its libraries"
                raise InputError(f"--dask {address}", what, "install the same there")


def _dask_client() -> Any:
    try:
        from distributed import Client
    except ImportError:
        raise InputError("--dask", "dask is not installed", "install trackworthy[cluster]") from None
    return Client


_WORKERS: dict[float, Workers] = {}
_LOCK = threading.Lock()


def _in_own_process(timeout: float, fn: Callable[..., T], args: tuple[Any, ...], kwargs: dict[str, Any]) -> T:
    """Within a dask worker: run `fn` in one of its processes."""
    from distributed import get_worker

    with _LOCK:
        if timeout not in _WORKERS:
            multiprocessing.current_process().daemon = False  # or it may not have processes of its own
            _WORKERS[timeout] = Workers(get_worker().state.nthreads, timeout)
    try:
        return _WORKERS[timeout].submit(fn, *args, **kwargs).result()
    except SystemExit as error:
        raise TrackworthyError("the process that ran it was told to leave") from error
