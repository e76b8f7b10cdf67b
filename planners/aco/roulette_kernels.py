"""Kernels of an ant's choice: dice, the limit of the biased roulette, the roulette itself."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from planners.kernel import Floats, kernel

TRACE = 1e-300  # pheromone of what may be chosen, where all of it has evaporated
Dice = NDArray[np.uint64]  # (1,): state of a generator, which a kernel takes 50 times as fast as numpy's


def dice(rng: np.random.Generator) -> Dice:
    """Dice whose rolls are decided by `rng`."""
    return rng.integers(0, 2**64, 1, dtype=np.uint64)


@kernel
def roll(state: Dice) -> float:
    """A number from [0, 1), by SplitMix64 (Steele, Lea and Flood 2014)."""
    state[0] += np.uint64(0x9E3779B97F4A7C15)
    z = state[0]
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    z = z ^ (z >> np.uint64(31))
    return float(z >> np.uint64(11)) * 2.0**-53


@kernel
def eta_limit(eta: Floats, bias: float) -> float:
    """The least heuristic that the biased roulette takes (paper 000, eq. 8)."""
    low, high = math.inf, 0.0
    for k in range(len(eta)):
        low, high = min(low, eta[k]), max(high, eta[k])
    return low + bias * (high - low)


@kernel
def roulette(eta: Floats, weight: Floats, alpha: float, beta: float, state: Dice) -> int:
    """One of those with any pheromone in `weight` (K,), by the probability of eq. 1; `weight` is overwritten."""
    strongest, nearest, total = 0.0, 0.0, 0.0
    for k in range(len(eta)):
        strongest, nearest = max(strongest, weight[k]), max(nearest, eta[k])
    for k in range(len(eta)):
        if weight[k] > 0.0:
            weight[k] = power(weight[k] / strongest, alpha) * power(eta[k] / nearest, beta)
            total += weight[k]
    left = roll(state) * total
    last = 0
    for k in range(len(eta)):
        if weight[k] > 0.0:
            left -= weight[k]
            last = k
            if left < 0.0:
                break
    return last


@kernel
def power(base: float, exponent: float) -> float:
    """base ** exponent; by products where the exponent is a small whole number, which is many times as fast."""
    if exponent != math.floor(exponent) or exponent > 16.0:
        return float(base**exponent)
    product = 1.0
    for _ in range(int(exponent)):
        product *= base
    return product
