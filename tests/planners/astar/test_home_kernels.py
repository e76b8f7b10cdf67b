import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grid_maps import random_grid
from planners.astar.home_kernels import pooled, way_to_point, ways_home
from planners.astar.room_kernels import along_arc


@given(st.integers(0, 1000), st.integers(1, 5))
def test_a_large_cell_is_free_where_one_of_its_cells_is(seed, factor):
    rng = np.random.default_rng(seed)
    field = rng.random(rng.integers(1, 14, 2))
    free = pooled(field, factor, 0.8)
    assert free.shape == tuple(-(-np.array(field.shape) // factor))
    for row, column in np.ndindex(free.shape):
        block = field[row * factor : (row + 1) * factor, column * factor : (column + 1) * factor]
        assert free[row, column] == (block.max() >= 0.8)


def test_in_the_open_the_way_home_is_straight():
    """First-order fast sweeping: exact along the axes, too long by less than 2 cells anywhere on 200."""
    home = ways_home(np.ones((201, 201), dtype=np.bool_), 100, 100)
    straight = np.hypot(*(np.indices(home.shape) - 100))
    assert (home[100] == straight[100]).all()
    assert (home - straight).min() >= -1e-9
    assert (home - straight).max() < 2.0


@pytest.mark.parametrize("seed", range(3))
def test_no_way_home_is_shorter_than_straight_and_none_leads_through_walls(seed):
    free = ~random_grid(np.random.default_rng(seed), 40, 60, 0.25)
    free[20, 30] = True
    home = ways_home(free, 20, 30)
    rows, columns = np.indices(home.shape)
    assert (home >= np.hypot(rows - 20, columns - 30) - 1e-9).all()
    assert np.isinf(home[~free]).all()
    free[:, 45] = False
    assert np.isinf(ways_home(free, 20, 30)[:, 45:]).all()


@pytest.mark.parametrize("cells", [50, 200])
def test_round_a_corner_the_way_home_is_at_most_two_cells_longer_for_each_leg(cells):
    """A wall from below up to the middle; the shortest path bends at its upper end."""
    free = np.ones((cells, cells), dtype=np.bool_)
    half = cells // 2
    free[:half, half] = False
    home = ways_home(free, 0, cells - 1)
    for row in range(0, half, 7):
        for column in range(0, half, 7):
            # Past the centre of the cell above the wall's end
            exact = math.hypot(half - row, half - column) + math.hypot(half, cells - 1 - half)
            assert exact - 1.0 <= home[row, column] <= exact + 4.0


@pytest.mark.parametrize(
    ("ahead", "left", "length"),
    [
        (5.0, 0.0, 5.0),
        (0.0, 4.0, 2.0 * math.pi),  # beside, two radii: half a circle
        (0.0, -4.0, 2.0 * math.pi),
        (2.0, 2.0, math.pi),  # a quarter
        (0.0, 0.0, 0.0),
    ],
)
def test_ways_to_points_in_closed_form(ahead, left, length):
    assert way_to_point(ahead, left, 2.0) == pytest.approx(length, abs=1e-3)


@given(
    turns=st.lists(st.tuples(st.floats(-1.0, 1.0), st.floats(0.0, 3.0)), min_size=1, max_size=5),
    radius=st.floats(0.1, 100.0),
)
def test_nothing_driven_is_shorter(turns, radius):
    pose, length = (0.0, 0.0, 0.0), 0.0
    for curvature, s in turns:
        pose, length = along_arc(*pose, curvature / radius, s * radius), length + s * radius
    assert way_to_point(pose[0], pose[1], radius) <= length + 1e-6 * radius


def test_inside_of_the_turning_circle_brute_force_finds_the_same():
    """An arc to the right, then one to the left, or the other way round: of all such, the least that ends there."""
    rng = np.random.default_rng(3)
    first, then = np.meshgrid(np.linspace(0.0, 2.0 * math.pi, 1500), np.linspace(0.0, 2.0 * math.pi, 1500))
    x = 2.0 * np.sin(first) + np.sin(then - first)
    y = 2.0 * np.cos(first) - 1.0 - np.cos(then - first)
    for _ in range(10):
        far, to = 0.9 * math.sqrt(rng.random()), 2.0 * math.pi * rng.random()
        ahead, left = far * math.cos(to), 1.0 + far * math.sin(to)
        near = np.hypot(x - ahead, y - left) < 6e-3
        assert way_to_point(ahead, left, 1.0) == pytest.approx((first + then)[near].min(), abs=0.05)
