"""Calls a planner in Python: `call_python.py module:callable scenario.json path.csv seed`, in a child interpreter.

It imports nothing of trackworthy and is run as a file, so that a module of the user's may have any name.
"""

from __future__ import annotations

import importlib
import json
import os
import sys
from collections.abc import Iterable
from functools import reduce


def main(target: str, scenario: str, output: str, seed: str) -> None:
    """Write the path that `target` returns, rows of x, y[, z] [m], as CSV; what it prints goes to standard error."""
    sys.stdout = sys.stderr
    sys.path.insert(0, os.getcwd())
    module, _, name = target.partition(":")
    plan = reduce(getattr, name.split("."), importlib.import_module(module))
    if not callable(plan):
        sys.exit(f"{target} is not callable")
    with open(scenario, encoding="utf-8") as stream:
        task = json.load(stream)
    points = plan(task, int(seed))
    rows = _rows(points)
    if rows is None:
        sys.exit(f"{target} returned {type(points).__name__} {repr(points)[:60]}, not rows of x, y or x, y, z")
    titles = "x,y,z"[: 2 * len(rows[0]) - 1] if rows else "x,y"
    with open(output, "w", encoding="utf-8") as stream:
        stream.writelines(f"{line}\n" for line in [titles, *(",".join(map(repr, row)) for row in rows)])


def _rows(points: object) -> list[list[float]] | None:
    """The points as rows of floats; None if they are not all pairs or all triples of numbers."""
    if not isinstance(points, Iterable):
        return None
    try:
        rows = [[float(value) for value in row] for row in points]
    except (TypeError, ValueError, OverflowError):
        return None
    return rows if {len(row) for row in rows} in (set(), {2}, {3}) else None


if __name__ == "__main__":
    main(*sys.argv[1:])
