import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.aco.walk_kernels import prune, ring, walk
from planners.segments import is_free, polyline_length

SEEDS = st.integers(0, 2**32)


def ants_way(blocked, seed, longest=400.0, step=8, sampling=2, bias=0.5):
    """A way between two corners of the grid."""
    rows, columns = blocked.shape
    nodes = np.empty((1000, 2))
    state = np.array([seed], dtype=np.uint64)
    start, goal = np.array([2.5, 2.5]), np.array([columns - 2.5, rows - 2.5])
    count, arrived = walk(
        blocked, np.ones_like(blocked), np.ones(blocked.shape), state, start, goal, ring(step, sampling), 6.0, 3.0,
        bias, longest, np.zeros(blocked.shape, np.int64), 1, nodes,
    )  # fmt: skip
    return nodes[:count], arrived


def test_eq_7_counts_corners_and_middles_twice():
    step, sampling = 8, 2
    assert (math.floor(step / sampling + 1) + 1) * 8 == 48  # as printed
    cells = ring(step, sampling)
    assert len(cells) == len({tuple(cell) for cell in cells.tolist()}) == 32
    assert (np.abs(cells).max(axis=1) == step).all()


def test_a_ring_of_one_step_is_the_eight_neighbours():
    assert sorted(map(tuple, ring(1, 1).tolist())) == sorted(
        (a, b) for a in (-1, 0, 1) for b in (-1, 0, 1) if (a, b) != (0, 0)
    )


@pytest.mark.parametrize(("step", "sampling"), [(8, 1), (5, 2), (7, 3), (3, 8)])
def test_rings_have_four_equal_sides(step, sampling):
    cells = {tuple(cell) for cell in ring(step, min(sampling, step)).tolist()}
    assert cells == {(-y, x) for x, y in cells} == {(x, -y) for x, y in cells}
    assert {(step, step), (-step, step)} <= cells


@given(SEEDS)
def test_an_ant_arrives_in_the_open(seed):
    way, arrived = ants_way(np.zeros((80, 120), dtype=bool), seed)
    assert arrived
    assert way[0].tolist() == [2.5, 2.5]
    assert way[-1].tolist() == [117.5, 77.5]


@given(SEEDS)
def test_an_ant_steps_on_no_cell_twice_and_through_no_obstacle(seed):
    blocked = np.zeros((80, 120), dtype=bool)
    blocked[20:60, 50:70] = blocked[0:30, 80:90] = True
    way, _ = ants_way(blocked, seed, bias=0.0)
    inner = way[:-1].astype(int)
    assert len({tuple(cell) for cell in inner.tolist()}) == len(inner)
    assert all(is_free(blocked, *a, *b) for a, b in itertools.pairwise(way))


@given(SEEDS, st.floats(10.0, 135.0))
def test_an_ant_that_cannot_arrive_within_its_range_dies(seed, longest):
    _, arrived = ants_way(np.zeros((80, 120), dtype=bool), seed, longest=longest)
    assert not arrived  # the straight way is 137.3


@given(SEEDS)
def test_pruning_shortens_and_stays_free(seed):
    blocked = np.zeros((80, 120), dtype=bool)
    blocked[20:60, 50:70] = True
    way, _ = ants_way(blocked, seed)
    pruned = prune(blocked, way, 10, 4, 0.8)
    assert polyline_length(pruned) <= polyline_length(way) + 1e-9
    assert all(is_free(blocked, *a, *b) for a, b in itertools.pairwise(pruned))
    assert (pruned[[0, -1]] == way[[0, -1]]).all()
