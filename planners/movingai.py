"""Benchmark problems of movingai.com: grid maps (.map) with starts, goals and optimal lengths beside them (.scen).

Sturtevant 2012, Benchmarks for grid-based pathfinding, IEEE Transactions on Computational Intelligence and AI in Games
4(2); formats: https://movingai.com/benchmarks/formats.html. Cells count from the north-west corner there, and have a
side of 1 map unit.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np

from planners.errors import InputError
from planners.files.text import read_text
from planners.kernel import Bools

COLUMNS = ("bucket", "map", "map width", "map height", "start x", "start y", "goal x", "goal y", "optimal length")
PASSABLE, BLOCKED = (
    ".GS",
    "@OTW",
)  # swamp as any other ground, for the format names no cost; water is not reached from it

HEADER = ("type", "height", "width", "map")

_PROBLEM = re.compile(r"(.+\.scen):([0-9]+)")
_UNKNOWN = 2


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """Problem `number` (from 1) of the .scen `files[0]`, on the .map `files[1]`.

    `blocked` (rows, cols) has row 0 in the south; `start` and `goal` are the centres of cells (x, y) from the
    south-west corner, `length` is the published one of the shortest path, all in cells. That path may step diagonally,
    but cut no corner.
    """

    number: int
    name: str
    blocked: Bools
    start: tuple[float, float]
    goal: tuple[float, float]
    length: float
    files: tuple[FilePath, FilePath]


def is_movingai(name: str) -> bool:
    """Whether a scenario of that name is one of these files, or meant to be."""
    return _PROBLEM.fullmatch(name) is not None or name.endswith((".scen", ".map"))


def read_problem(name: str) -> Problem:
    """The problem called `FILE.scen:NUMBER`; its map lies where the file says, or beside it.

    Raises `InputError` naming file and line for what is missing, malformed or does not fit the map.
    """
    given = _PROBLEM.fullmatch(name)
    if given is None:
        file = name if name.endswith(".scen") else f"{name}.scen"
        what = "it holds many problems" if file == name else "a map alone has no start and no goal"
        raise InputError(name, what, f"name a problem by its number, as {file}:1")
    scen, number = FilePath(given[1]), int(given[2])
    place, fields = _columns(scen, number)
    at = scen.parent / fields[1]
    at = at if at.is_file() else scen.parent / at.name
    blocked = read_map(at)
    rows, columns = blocked.shape
    width, height, *ends = (_whole(text, what, place) for text, what in zip(fields[2:8], COLUMNS[2:8], strict=True))
    if (width, height) != (columns, rows):
        what = f"its map is {width} x {height}, and {at} is {columns} x {rows}"
        raise InputError(place, what, "scaled maps are not known: give a map of that size")
    for which, (x, y) in (("start", ends[:2]), ("goal", ends[2:])):
        if not (x < columns and y < rows):
            raise InputError(place, f"the {which} ({x}, {y}) is off the map", f"it has {columns} x {rows} cells")
        if blocked[rows - 1 - y, x]:
            raise InputError(place, f"the {which} ({x}, {y}) is in a blocked cell of {at}", "move it to free ground")
    start, goal = ((x + 0.5, rows - y - 0.5) for x, y in (ends[:2], ends[2:]))
    stem = scen.name.removesuffix(".scen").removesuffix(".map")
    return Problem(number, f"{stem} {number}", blocked, start, goal, _length(fields[8], place), (scen, at))


def _columns(scen: FilePath, number: int) -> tuple[str, list[str]]:
    """The place and the nine columns of a problem."""
    lines = read_text(scen).rstrip("\n").split("\n")
    if lines[0].split() not in (["version", "1"], ["version", "1.0"]):
        raise InputError(f"{scen}: line 1", f"{lines[0][:40]!r} is not 'version 1'", "give a .scen file of version 1")
    if not 0 < number < len(lines):
        raise InputError(str(scen), f"there is no problem {number}", f"it has those from 1 to {len(lines) - 1}")
    place, fields = f"{scen}: line {number + 1}", lines[number].split("\t")
    fields = fields if len(fields) == len(COLUMNS) else lines[number].split()
    if len(fields) != len(COLUMNS):
        raise InputError(place, f"it has {len(fields)} columns", f"give {len(COLUMNS)}: {', '.join(COLUMNS)}")
    return place, fields


def read_map(file: FilePath) -> Bools:
    """Which cells (rows, cols) of a .map are blocked, row 0 in the south.

    Raises `InputError` naming file and line for a header that is none, rows too few, too many or too short, and for a
    letter that stands for no terrain.
    """
    lines = read_text(file).rstrip("\n").split("\n")
    for number, key in enumerate(HEADER, 1):
        words = lines[number - 1].split() if number <= len(lines) else []
        if words[:1] != [key] or (key == "type" and words[1:] != ["octile"]):
            what = f"{' '.join(words)[:40]!r} is not its {key}"
            raise InputError(f"{file}: line {number}", what, "begin with type octile, height H, width W and map")
    height, width = (_whole(lines[i].split(maxsplit=1)[-1], HEADER[i], f"{file}: line {i + 1}") for i in (1, 2))
    rows = lines[4:]
    if len(rows) != height or not height * width:
        raise InputError(f"{file}: line 2", f"the height is {height}, and there are {len(rows)} rows", "correct one")
    for number, row in enumerate(rows, 5):
        if len(row) != width:
            what = f"the row has {len(row)} cells, and the width is {width}"
            raise InputError(f"{file}: line {number}", what, "correct one of them")
    terrain = np.full(128, _UNKNOWN, dtype=np.uint8)
    for letters, kind in ((PASSABLE, 0), (BLOCKED, 1)):
        terrain[[ord(letter) for letter in letters]] = kind
    codes = np.frombuffer("".join(rows).encode("ascii", "replace"), dtype=np.uint8).reshape(height, width)
    kinds = terrain[codes]
    if (kinds == _UNKNOWN).any():
        row, column = np.argwhere(kinds == _UNKNOWN)[0].tolist()
        remedy = f"use {' '.join(PASSABLE)} for ground and {' '.join(BLOCKED)} for what is blocked"
        raise InputError(f"{file}: line {row + 5}", f"{rows[row][column]!r} is no terrain", remedy)
    return np.asarray(kinds[::-1] == 1)


def _whole(text: str, what: str, place: str) -> int:
    if not re.fullmatch("[0-9]{1,6}", text.strip()):
        raise InputError(place, f"{what} is {text[:40]!r}", "give a whole number")
    return int(text)


def _length(text: str, place: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError(place, f"{COLUMNS[8]} is {text[:40]!r}", "give a number") from None
