"""Pigeons on a bowl, whose least value is known."""

import math
from dataclasses import dataclass

import numpy as np
import pytest

from planners.pio.course import Judged
from planners.pio.search import Search, factors, landed, mutate, search, steered
from planners.pio.settings import Pigeons

LEAST = np.array([3.0, -2.0, 1.0])
IMPROVED = {"cauchy": True, "communication": "rescaled", "gradient": True}


@dataclass
class Bowl:
    """The squared distance to `LEAST`, and 1."""

    paths: int = 1

    def judge(self, positions):
        cost = 1.0 + ((positions - LEAST) ** 2).sum(axis=1)
        return Judged(cost, cost, cost < 5.0)

    def clipped(self, positions):
        return positions

    def gradients(self, positions, step):
        return 2.0 * (positions - LEAST)


def flock(seed=0, pigeons=60):
    rng = np.random.default_rng(seed)
    return rng.normal(0.0, 5.0, (pigeons, 3)), np.zeros((pigeons, 3)), rng


@pytest.mark.parametrize("settings", [Pigeons(), Pigeons(**IMPROVED)], ids=["PIO", "GCCPIO"])
def test_pigeons_come_to_the_least(settings):
    seen = search(Bowl(), *flock(), settings)
    assert seen.best_cost < 1.5
    assert seen.costs == sorted(seen.costs, reverse=True)
    assert seen.best_cost == seen.costs[-1]
    assert Bowl().judge(np.array(seen.found)).kept.all()


def test_every_evaluation_is_counted():
    """60 at first, in 80 iterations 60, a mutation each and before, 5 % by a gradient of 4, then halves (eq. 9)."""
    halves = [30, 15, 8, 4, 2] + 15 * [1]
    assert search(Bowl(), *flock(), Pigeons()).evaluated == 60 * 81 + sum(halves)
    improved = search(Bowl(), *flock(), Pigeons(**IMPROVED))
    assert improved.evaluated == 60 * 81 + sum(halves) + 81 + 80 * 3 * 4
    assert improved.evaluations[-1] == improved.evaluated


def test_of_300_pigeons_one_is_left_after_9_landmark_iterations():
    positions, _, rng = flock(pigeons=300)
    seen = Search(Bowl())
    told, counts = seen.look(positions), []
    for _ in range(9):
        positions, told = landed(seen, positions, told, rng)
        counts.append(len(positions))
    assert counts == [150, 75, 38, 19, 10, 5, 3, 2, 1]


def test_the_printed_factors_are_not_from_0_to_1_and_the_rescaled_are():
    """Eq. 15 with A 1.2, B 0.5, C -1, R 0.5: c1 from 0.7 to 1.2 / e + 0.5 / sqrt(e) - 1."""
    printed, rescaled = Pigeons(communication="printed"), Pigeons(communication="rescaled")
    assert factors(0.0, printed) == pytest.approx((0.7, 0.3))
    assert factors(1.0, printed)[0] == pytest.approx(1.2 / math.e + 0.5 / math.sqrt(math.e) - 1.0)
    assert factors(0.0, rescaled) == pytest.approx((1.0, 0.0))
    assert factors(1.0, rescaled) == pytest.approx((0.0, 1.0))
    grown = [factors(share, rescaled)[1] for share in np.linspace(0.0, 1.0, 50)]
    assert grown == sorted(grown)


def test_a_mutation_scales_the_best_and_is_kept_only_if_better():
    positions, _, rng = flock()
    seen = Search(Bowl())
    seen.look(positions)
    first, before = seen.best.copy(), seen.best_cost
    for _ in range(100):
        mutate(seen, rng)
    assert seen.best_cost < before
    assert np.linalg.matrix_rank(np.array([first, seen.best]), tol=1e-9) == 1


def test_down_the_gradient_pigeons_keep_their_speed_and_where_it_is_flat_they_stop():
    """Eq. 18: -g |V / g| is V's size against g's sign; pigeon 0 is at the least."""
    positions, _, rng = flock()
    positions[0] = LEAST
    velocities = rng.normal(0.0, 1.0, positions.shape)
    seen = Search(Bowl())
    seen.look(positions)
    steered_by = steered(seen, positions, velocities, 1, rng, Pigeons(gradient=True, gradient_share=1.0))
    assert steered_by == pytest.approx(-np.sign(positions - LEAST) * np.abs(velocities))
    assert (steered_by[0] == 0.0).all()
