"""What JSBSim says, kept from the user's terminal and at hand for errors."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

os.environ.setdefault("JSBSIM_DEBUG", "0")  # JSBSim prints its banner on standard output otherwise

import jsbsim

MOST_LINES = 3  # of errors told


class _Listener(jsbsim.FGLogger):
    def __init__(self) -> None:
        super().__init__()
        self._level = jsbsim.LogLevel.BULK
        self._errors: list[str] = []

    def set_level(self, level: jsbsim.LogLevel) -> None:
        self._level = level

    def file_location(self, filename: str, line: int) -> None:
        if self._level >= jsbsim.LogLevel.ERROR:
            self._errors.append(f"{filename}, line {line}: ")

    def message(self, message: str) -> None:
        if self._level >= jsbsim.LogLevel.ERROR:
            self._errors.append(message)

    def format(self, format: jsbsim.LogFormat) -> None:
        """Colours are not for error messages."""

    def flush(self) -> None:
        """Records are joined when they are asked for."""

    def errors(self) -> str:
        """The last errors heard, each once, in one line."""
        lines = dict.fromkeys(" ".join(line.split()) for line in "".join(self._errors).splitlines())
        return "; ".join(list(filter(None, lines))[-MOST_LINES:])


@contextmanager
def listening() -> Iterator[_Listener]:
    """Take what JSBSim logs within the block; its own logger returns afterwards, as it must before the program ends."""
    before = jsbsim.get_logger()
    listener = _Listener()
    jsbsim.set_logger(listener)
    try:
        yield listener
    finally:
        jsbsim.set_logger(before)
