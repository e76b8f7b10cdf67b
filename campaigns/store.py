"""The results of a campaign in SQLite: a row a trial, committed as it finishes."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns.attempt import Attempt, Measured
from planners.errors import InputError, TrackworthyError

TABLES = """
CREATE TABLE IF NOT EXISTS trials (
    key TEXT PRIMARY KEY,       -- hash of all that decides the outcome
    case_name TEXT NOT NULL,
    trial INTEGER NOT NULL,     -- from 1
    seed INTEGER NOT NULL,
    error TEXT NOT NULL,        -- '' where it was tried; all that follows counts only then
    kind TEXT NOT NULL,         -- of the error: input, machinery, died
    trackworthy INTEGER NOT NULL,
    passed INTEGER NOT NULL,    -- as expected
    score REAL NOT NULL,        -- margin of the requirement that decides, relative to its limit
    decided_by TEXT NOT NULL,
    ended TEXT NOT NULL,        -- how, or why there was no path
    metrics TEXT NOT NULL,      -- JSON: name -> [value, arc length, time], SI units
    profile BLOB NOT NULL       -- cross-track error along the path, 32-bit floats [m]; empty where there was no path
);
CREATE INDEX IF NOT EXISTS trials_of_case ON trials (case_name, trial);
CREATE TABLE IF NOT EXISTS metrics (name TEXT PRIMARY KEY, unit TEXT NOT NULL, better TEXT NOT NULL);
"""
COLUMNS = "trial, seed, error, kind, trackworthy, passed, score, decided_by, ended, metrics, profile"


@dataclass(frozen=True, slots=True)
class Row:
    """A stored trial; the fields are those of `Attempt`."""

    trial: int
    seed: int
    error: str
    kind: str
    trackworthy: bool
    passed: bool
    score: float
    decided_by: str
    ended: str
    metrics: dict[str, Measured]
    profile: bytes

    @property
    def flown(self) -> bool:
        """Whether there was a path to fly or drive."""
        return not self.error and bool(self.profile)


_METRICS = msgspec.json.Decoder(dict[str, tuple[float | None, float | None, float | None]])


class Store:
    """The file `results.sqlite`; raises `TrackworthyError` where the disk does not take what is written."""

    def __init__(self, file: Path, read_only: bool = False) -> None:
        self._file, self._read_only = file, read_only
        self._known: set[str] = set()
        with self._failing():
            where = f"{file.absolute().as_uri()}{'?mode=ro' if read_only else ''}"
            self._db = sqlite3.connect(where, uri=True, isolation_level=None)
            if not read_only:
                self._db.execute("PRAGMA journal_mode = WAL")
                self._db.execute("PRAGMA synchronous = NORMAL")
                self._db.executescript(TABLES)

    def close(self) -> None:
        """Close the file, which then needs no other beside it."""
        with self._failing():
            if not self._read_only:
                self._db.execute("PRAGMA journal_mode = DELETE")
            self._db.close()

    def add(self, key: str, case_name: str, trial: int, result: Attempt) -> None:
        """Store a trial's result, in place of an earlier one."""
        values = {name: [m.value, m.s, m.t] for name, m in result.metrics.items()}
        row = (
            key, case_name, trial, result.seed, result.error, result.kind, result.trackworthy, result.passed,
            result.score, result.decided_by, result.ended, msgspec.json.encode(values).decode(), result.profile,
        )  # fmt: skip
        units = [(name, *both) for name, both in result.units.items() if name not in self._known]
        with self._failing():
            self._db.execute("BEGIN")
            self._db.execute(f"INSERT OR REPLACE INTO trials VALUES ({', '.join('?' * len(row))})", row)
            if units:
                self._db.executemany("INSERT OR REPLACE INTO metrics VALUES (?, ?, ?)", units)
            self._db.execute("COMMIT")
        self._known |= result.units.keys()

    def finished(self) -> set[str]:
        """Keys of the trials that need not be tried again: those without an error."""
        with self._failing():
            return {key for (key,) in self._db.execute("SELECT key FROM trials WHERE error = ''")}

    def rows(self, case_name: str, trials: int) -> Iterator[Row]:
        """The stored trials of a case in order, up to the number `trials`."""
        query = f"SELECT {COLUMNS} FROM trials WHERE case_name = ? AND trial <= ? ORDER BY trial"
        with self._failing():
            for row in self._db.execute(query, (case_name, trials)):
                trial, seed, error, kind, trackworthy, passed, score, decided_by, ended, metrics, profile = row
                decoded = {name: Measured(*values) for name, values in _METRICS.decode(metrics).items()}
                yield Row(
                    trial, seed, error, kind, bool(trackworthy), bool(passed), score, decided_by, ended, decoded,
                    profile,
                )  # fmt: skip

    def units(self) -> dict[str, tuple[str, str]]:
        """Unit and direction of every metric met."""
        with self._failing():
            return {name: (unit, better) for name, unit, better in self._db.execute("SELECT * FROM metrics")}

    @contextmanager
    def _failing(self) -> Iterator[None]:
        try:
            yield
        except sqlite3.Error as error:
            if self._read_only:
                raise InputError(str(self._file), f"cannot be read: {error}", "run the campaign again") from error
            remedy = "what was stored before is kept; make room and run the same command again"
            raise TrackworthyError(f"{self._file}: cannot be used: {error}; {remedy}") from error
