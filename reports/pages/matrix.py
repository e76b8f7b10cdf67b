"""The matrix of cases: planners or paths against vehicles, speeds and controllers, coloured by margin."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from campaigns.summary import ERROR, CaseResult
from reports.files.json_result import Json
from reports.pages.shades import shade
from reports.words.deciding import deciding, metric_words, severity
from reports.words.dimensions import COLUMNS, DIMENSIONS, ROWS, dimensions
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

Key = tuple[str, ...]
_BROADEST = 8  # columns, side by side on a page
_FEW = 4  # times as many columns as rows
_MOST = 90  # characters of what all cases have in common, of each dimension


def matrix_data(results: Sequence[CaseResult], outcomes: Mapping[str, Outcome]) -> dict[str, Json]:
    """The matrix as data: the names of what stands at its rows and columns, their values, and the cells.

    `cells` (rows, columns) has null where there is no case. A cell with several cases shows the worst and says how many
    there are. A dimension in which all cases are the same is left out, and told in `same`.
    """
    told = dict(zip((result.case.name for result in results), dimensions(results, outcomes), strict=True))
    varying = [one for one in DIMENSIONS if len({case[one] for case in told.values()}) > 1]
    across, down = [one for one in COLUMNS if one in varying], [one for one in ROWS if one in varying]
    across, down = _balanced(across, down or [ROWS[0]], list(told.values()))
    groups: dict[tuple[Key, Key], list[CaseResult]] = {}
    for result in results:
        case = told[result.case.name]
        key = tuple(case[one] for one in down), tuple(case[one] for one in across)
        groups.setdefault(key, []).append(result)
    rows = list(dict.fromkeys(row for row, _ in groups))
    columns = sorted(dict.fromkeys(column for _, column in groups), key=_order([c for _, c in groups]))
    first = next(iter(told.values()), {})
    same = [f"{one} {_cut(first[one])}" for one in DIMENSIONS if one not in (*varying, *down) and first.get(one)]
    return {
        "down": [*down],
        "across": [*across],
        "rows": [[*row] for row in rows],
        "columns": [[*column] for column in columns],
        "cells": [
            [_cell(groups[row, column], outcomes) if (row, column) in groups else None for column in columns]
            for row in rows
        ],
        "same": [*same],
    }


def _balanced(across: list[str], down: list[str], cases: Sequence[Mapping[str, str]]) -> tuple[list[str], list[str]]:
    """The dimensions across and down; of many columns over few rows the longest one stands at the rows."""

    def count(which: Sequence[str]) -> int:
        return len({tuple(case[one] for one in which) for case in cases})

    if count(across) <= _BROADEST or count(across) < _FEW * count(down):
        return across, down
    longest = max(across, key=lambda one: count([one]))
    kept = [one for one in down if count([one]) > 1]
    return [one for one in across if one != longest], [*kept, longest]


def _order(columns: Sequence[Key]) -> Callable[[Key], list[int]]:
    """The place of a column: of one vehicle stand together, within it of one speed, each in the order of the cases."""
    met = [list(dict.fromkeys(parts)) for parts in zip(*columns, strict=True)]
    return lambda column: [one.index(part) for one, part in zip(met, column, strict=True)]


def _cell(group: Sequence[CaseResult], outcomes: Mapping[str, Outcome]) -> Json:
    """The worst case of the `group`."""
    worst = min(group, key=lambda result: severity(result, outcomes.get(result.case.name)))
    found = deciding(worst, outcomes.get(worst.case.name))
    met = worst.verdict == TRACKWORTHY
    fill, ink = shade(found.share, met)
    return {
        "case": worst.case.name,
        "verdict": worst.verdict,
        "met": met,
        "passed": all(result.passed for result in group),
        "margin": found.words,
        "metric": metric_words(found),
        "share": _share(worst),
        "fill": fill,
        "ink": ink,
        "count": len(group),
    }


def _share(result: CaseResult) -> str:
    """ "18/20" trials are trackworthy; "" for one trial."""
    if result.case.trials == 1 or result.verdict == ERROR:
        return ""
    return f"{result.statistics.trackworthy}/{result.statistics.tried}"


def _cut(words: str) -> str:
    return words if len(words) <= _MOST else f"{words[: _MOST - 1]}…"
