import numpy as np
import pytest

from planners.aco.roulette_kernels import dice, eta_limit, power, roll, roulette

SPLITMIX_1234567 = (6457827717110365317, 3203168211198807973, 9817491932198370423)  # published test vector


def test_dice_are_splitmix64():
    state = np.array([1234567], dtype=np.uint64)
    for number in SPLITMIX_1234567:
        assert roll(state) == (number >> 11) * 2.0**-53


def test_a_generator_decides_the_dice():
    one, two = (dice(np.random.default_rng(3)) for _ in range(2))
    assert [roll(one) for _ in range(5)] == [roll(two) for _ in range(5)]


def test_the_limit_of_the_biased_roulette():
    eta = np.array([0.2, 0.5, 1.0])
    assert eta_limit(eta, 0.5) == pytest.approx(0.6)  # eq. 8
    assert eta_limit(eta, 0.0) == 0.2


@pytest.mark.parametrize("exponent", [0.0, 1.0, 3.0, 6.0, 2.5, 40.0])
def test_power(exponent):
    assert power(0.7, exponent) == pytest.approx(0.7**exponent, rel=1e-14)


def test_choices_come_as_often_as_eq_1_says():
    eta, pheromone = np.array([1.0, 0.8, 0.5, 0.9]), np.array([2.0, 3.0, 2.5, 0.0])
    state, count = np.array([5], dtype=np.uint64), np.zeros(4)
    draws = 40_000
    for _ in range(draws):
        count[roulette(eta, pheromone.copy(), 2.0, 3.0, state)] += 1
    weight = pheromone**2 * eta**3
    share = weight / weight.sum()
    assert count[3] == 0
    assert np.abs(count / draws - share).max() < 4.0 * np.sqrt(share.max() * (1 - share.max()) / draws)
