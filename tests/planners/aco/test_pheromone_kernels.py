import numpy as np
import pytest

from planners.aco.pheromone_kernels import evaporate_and_lay, lay_along, region


def test_layers_weigh_less_the_farther_out():
    weights = region(2, 0.5)
    assert weights.sum() == 1.0 + 8 * 0.5 + 16 * 0.25  # eq. 10
    assert region(2, 0.0).sum() == region(0, 0.5).sum() == 1.0


def test_what_is_seen_is_the_regional_sum_of_what_lies():
    """Eq. 4 and 10 by their definitions."""
    rng, weights, rho = np.random.default_rng(1), region(2, 0.5), 0.6
    lies = np.full((12, 15), 2.0)
    seen = np.full(lies.shape, 2.0 * weights.sum())
    for _ in range(4):
        laid = np.where(rng.random(lies.shape) < 0.1, rng.random(lies.shape), 0.0)
        lies = (1.0 - rho) * lies + laid
        touched = np.argwhere(laid)[:, ::-1].copy()
        evaporate_and_lay(seen, laid, touched, len(touched), rho, weights)
        assert not laid.any()
    for row in range(2, 10):
        for column in range(2, 13):
            around = lies[row - 2 : row + 3, column - 2 : column + 3]
            assert seen[row, column] == pytest.approx((around * weights).sum())


def test_pheromone_lies_on_cells_or_on_nodes():
    way = np.array([[0.5, 0.5], [6.5, 0.5], [6.5, 3.5]])
    on_cells, on_nodes = np.zeros((5, 8)), np.zeros((5, 8))
    touched, count = np.empty((40, 2), np.int64), 0
    for _ in range(2):  # the second ant touches no new cell
        count = lay_along(on_cells, touched, count, 0.5, way, False)
        lay_along(on_nodes, np.empty((40, 2), np.int64), 0, 0.5, way, True)
    assert sorted(map(tuple, touched[:count].tolist())) == sorted((x, y) for y, x in np.argwhere(on_cells).tolist())
    assert on_cells.sum() == 9.0
    assert np.argwhere(on_nodes).tolist() == [[0, 6], [3, 6]]
