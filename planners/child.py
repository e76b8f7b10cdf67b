"""A program of others, run once within a time limit; nothing of it goes on running."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import IO

TAIL_BYTES = 10_000  # of what a program prints, kept
_CHUNK = 1 << 16  # [B] read at once
_GRACE = 0.5  # [s] for what is still in a pipe when its program has ended


@dataclass(frozen=True, slots=True)
class Ended:
    """How a program ended: its exit `code`, negative for a signal, None when its time was over.

    `said` is the end of its standard output and then of its standard error, at most `TAIL_BYTES` together.
    """

    code: int | None
    said: str


def run_child(command: Sequence[str], folder: FilePath, timeout: float) -> Ended:
    """Run `command` in `folder` for at most `timeout` [s], without input and in a process group of its own.

    The whole group is killed at the end, however that comes about. Python programs get a fixed hash seed,
    if the user has set none, so that their sets come in the same order each time. Raises `OSError` or
    `ValueError` when the program cannot be started.
    """
    process = subprocess.Popen(
        command,
        cwd=folder,
        env={"PYTHONHASHSEED": "0", **os.environ},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        bufsize=0,
        start_new_session=True,
    )
    code = None
    try:
        tails = [_Tail(pipe) for pipe in (process.stdout, process.stderr) if pipe is not None]
        for tail in tails:
            tail.start()
        with contextlib.suppress(subprocess.TimeoutExpired):
            code = process.wait(timeout)
    finally:
        with contextlib.suppress(ProcessLookupError, PermissionError):  # macOS: the latter for a group of zombies
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    said = b"\n".join(text for tail in tails if (text := tail.end().strip()))
    return Ended(code, said[-TAIL_BYTES:].decode("utf-8", "replace"))


class _Tail(threading.Thread):
    """Empties a pipe, so that nobody blocks on it, and keeps the end of what came."""

    def __init__(self, pipe: IO[bytes]) -> None:
        super().__init__(daemon=True)
        self._pipe = pipe
        self._kept = b""
        self._enough = False

    def run(self) -> None:
        with self._pipe as pipe:
            while not self._enough and (chunk := pipe.read(_CHUNK)):
                self._kept = (self._kept + chunk)[-TAIL_BYTES:]

    def end(self) -> bytes:
        """What was kept; a process that left its group may hold the pipe open and is not waited for."""
        self.join(_GRACE)
        self._enough = True
        return self._kept
