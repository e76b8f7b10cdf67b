"""The exceptions a user may meet; each says in one line what is wrong, where, and what to do."""

from __future__ import annotations


class TrackworthyError(Exception):
    """The machinery failed (a simulator crashed, a disk was full); exit code 3."""

    exit_code = 3


class InputError(TrackworthyError):
    """The user's input cannot be used; exit code 2.

    `place` names the file, row, item or option; `what` is wrong there; `remedy` says what to do about it.
    """

    exit_code = 2

    def __init__(self, place: str, what: str, remedy: str = "") -> None:
        super().__init__(place, what, remedy)  # as they are, so that the error passes between processes

    def __str__(self) -> str:
        place, what, remedy = self.args
        return ": ".join(part for part in (place, what) if part) + (f"; {remedy}" if remedy else "")
