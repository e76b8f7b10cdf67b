"""A* on a grid of cells (Hart, Nilsson and Raphael 1968), in whole numbers and with buckets for a queue."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from planners.kernel import Ints, kernel

Bytes = NDArray[np.uint8]
Links = NDArray[np.int32]

# Lengths are whole numbers, so that equal ones are equal: a side of a cell is 2^36, its diagonal sqrt(2) 2^36 rounded.
# No path among 5e7 cells overflows, and no two lengths change places below 1e5 diagonals.
SIDE, DIAGONAL = 1 << 36, 97_184_015_999
HALF_SIDE = 35  # [bits] the width of a bucket
BUCKETS = 8  # half sides: more than the sqrt(8) sides that one step adds to f at most

EAST = np.array([1, 0, -1, 0, 1, -1, -1, 1])
NORTH = np.array([0, 1, 0, -1, 1, 1, -1, -1])
FREE, BLOCKED, FIRST = 0, 1, 2  # of a cell; from `FIRST` on, by which step it was reached
WAITING = 16  # added to a cell in a bucket


@kernel
def search(
    cells: Bytes, lengths: Ints, links: Links, width: int,
    start: int, goal: int, directions: int, diagonal: int, cutting: bool,
) -> int:  # fmt: skip
    """Length of the shortest path from `start` to `goal`, indices of cells, in units of `SIDE`; -1 if there is none.

    `cells` (N,) are `FREE` or `BLOCKED`, row by row of `width`, with a border of blocked ones, and then say how each
    was reached; `lengths` (N,) and `links` (N, 2) are room to work in. There are 4 or 8 `directions`; a step in the
    last four costs `diagonal`, and needs both cells beside it free unless `cutting`.

    The heuristic is the length without obstacles: octile, or Manhattan's where a diagonal costs two sides. A step adds
    nothing to f or more than half a side, so that buckets of that width serve as queue (Dial 1969; Denardo and Fox
    1979). Of a bucket the last to come is taken first, and once more if it then becomes nearer. With the goal reached,
    only what may lead to it by a shorter way is looked at.
    """
    steps = EAST + width * NORTH
    goal_x, goal_y = goal % width, goal // width
    heads = np.full(BUCKETS, -1)
    cells[start], lengths[start] = FIRST + 8, 0
    at = _least(start % width - goal_x, start // width - goal_y, diagonal) >> HALF_SIDE
    _put(start, at, cells, links, heads)
    best, waiting = -1, 1
    while waiting > 0 and (best < 0 or at << HALF_SIDE < best):
        here = heads[at & BUCKETS - 1]
        if here < 0:
            at += 1
            continue
        _take(here, at, cells, links, heads)
        waiting -= 1
        x, y = here % width - goal_x, here // width - goal_y
        if best >= 0 and lengths[here] + _least(x, y, diagonal) >= best:
            continue
        for k in range(directions):
            there = here + steps[k]
            if cells[there] == BLOCKED:
                continue
            length = lengths[here] + (SIDE if k < 4 else diagonal)
            if cells[there] != FREE and lengths[there] <= length:
                continue
            beside, across = here + steps[k & 3], here + steps[k - 3 & 3]
            if k >= 4 and not cutting and (cells[beside] == BLOCKED or cells[across] == BLOCKED):
                continue
            rest = _least(x + EAST[k], y + NORTH[k], diagonal)
            if cells[there] >= WAITING:
                _take(there, (lengths[there] + rest) >> HALF_SIDE, cells, links, heads)
                waiting -= 1
            lengths[there], cells[there] = length, FIRST + k
            if there == goal:
                best = length
            else:
                _put(there, (length + rest) >> HALF_SIDE, cells, links, heads)
                waiting += 1
    return best


@kernel
def corners(cells: Bytes, width: int, start: int, goal: int) -> Ints:
    """The cells at which the path found turns, from goal to start, both included."""
    steps = EAST + width * NORTH
    found = np.empty(8, np.int64)
    found[0], here, last, count = goal, goal, -1, 1
    while here != start:
        by = cells[here] % WAITING - FIRST
        if by != last and here != goal:
            if count + 1 == len(found):
                found = np.concatenate((found, found))
            found[count] = here
            count += 1
        here, last = here - steps[by], by
    if start != goal:
        found[count] = start
        count += 1
    return found[:count]


@kernel
def _least(x: int, y: int, diagonal: int) -> int:
    """The length over `x` columns and `y` rows without obstacles."""
    return SIDE * max(abs(x), abs(y)) + (diagonal - SIDE) * min(abs(x), abs(y))


@kernel
def _put(cell: int, bucket: int, cells: Bytes, links: Links, heads: Ints) -> None:
    """Put the cell in front of the others of that bucket."""
    after = heads[bucket & BUCKETS - 1]
    links[cell, 0], links[cell, 1] = -1, after
    if after >= 0:
        links[after, 0] = cell
    heads[bucket & BUCKETS - 1] = cell
    cells[cell] += WAITING


@kernel
def _take(cell: int, bucket: int, cells: Bytes, links: Links, heads: Ints) -> None:
    """Take the cell out of that bucket."""
    before, after = links[cell, 0], links[cell, 1]
    if before >= 0:
        links[before, 1] = after
    else:
        heads[bucket & BUCKETS - 1] = after
    if after >= 0:
        links[after, 0] = before
    cells[cell] -= WAITING
