"""Grids for tests: random, rooms and mazes, and what a shortest path on them has by another's Dijkstra."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from planners.map import Map, Raster
from planners.scenario import Scenario

FOUR = [(0, 1), (1, 0)]
EIGHT = [*FOUR, (1, 1), (1, -1)]


def random_grid(rng, rows, columns, density):
    """Blocked cells (rows, columns) by chance."""
    return rng.random((rows, columns)) < density


def rooms(rng, count, side):
    """`count` x `count` rooms of `side` cells, most walls with a door of one cell."""
    size = count * (side + 1) + 1
    blocked = np.zeros((size, size), dtype=bool)
    blocked[:: side + 1], blocked[:, :: side + 1] = True, True
    for wall in range(side + 1, size - 1, side + 1):
        for room in range(count):
            for grid in (blocked, blocked.T):
                if rng.random() < 0.8:
                    grid[wall, room * (side + 1) + 1 + rng.integers(side)] = False
    return blocked


def maze(rng, count):
    """A perfect maze of `count` x `count` places, corridors of one cell (depth first)."""
    blocked = np.ones((2 * count + 1, 2 * count + 1), dtype=bool)
    stack = [(0, 0)]
    blocked[1, 1] = False
    while stack:
        row, column = stack[-1]
        near = [(row + i, column + j) for i, j in ((0, 1), (1, 0), (0, -1), (-1, 0))]
        near = [
            (i, j) for i, j in near if 0 <= i < count and 0 <= j < count and blocked[2 * i + 1, 2 * j + 1]
        ]  # fmt: skip
        if not near:
            stack.pop()
            continue
        i, j = near[rng.integers(len(near))]
        blocked[row + i + 1, column + j + 1] = blocked[2 * i + 1, 2 * j + 1] = False
        stack.append((i, j))
    return blocked


def distances(blocked, start, steps=EIGHT, cutting=False):
    """Length (rows, cols) in cells of the shortest path from the cell `start` (row, column), inf for none; by scipy."""
    rows, columns = blocked.shape
    index = np.arange(rows * columns).reshape(rows, columns)
    ends, lengths = [], []
    for i, j in steps:
        here = (slice(0, rows - i), slice(max(-j, 0), columns - max(j, 0)))
        there = (slice(i, rows), slice(max(j, 0), columns - max(-j, 0)))
        free = ~blocked[here] & ~blocked[there]
        if i and j and not cutting:
            free &= ~blocked[here[0], there[1]] & ~blocked[there[0], here[1]]
        ends.append((index[here][free], index[there][free]))
        lengths.append(np.full(free.sum(), np.hypot(i, j)))
    one, other = (np.concatenate([end[k] for end in ends]) for k in (0, 1))
    graph = coo_array((np.concatenate(lengths), (one, other)), shape=(rows * columns, rows * columns))
    return dijkstra(graph.tocsr(), directed=False, indices=index[start]).reshape(rows, columns)


def on_cells(blocked, start, goal, cell=1.0):
    """A scenario on that grid from the centre of one cell (row, column) to that of another."""
    rows, columns = np.array(blocked.shape) * cell
    starts, goals = ((np.array([place[::-1]]) + 0.5) * cell for place in (start, goal))
    area = Map(raster=Raster(blocked, cell), bounds=(0.0, 0.0, columns, rows))
    return Scenario(name="grid", map=area, starts=starts, goals=goals, size=(columns, rows))


def free_cells(rng, blocked, count):
    """That many free cells (row, column), each of them once."""
    cells = np.argwhere(~blocked)
    return [tuple(cell) for cell in cells[rng.choice(len(cells), count, replace=False)].tolist()]
