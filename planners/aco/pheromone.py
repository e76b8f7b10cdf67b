"""Pheromone on cells, as the ants of the improved colony see it."""

from __future__ import annotations

import numpy as np

from planners.aco.pheromone_kernels import evaporate_and_lay, lay_along, region
from planners.aco.settings import RingSettings
from planners.ground import Ground
from planners.kernel import Floats
from planners.scenario import Scenario


class Pheromone:
    """`seen` (rows, cols) is the regional equivalent pheromone of each cell (paper 000, eq. 10)."""

    def __init__(self, settings: RingSettings, ground: Ground, scenario: Scenario, nodes_only: bool = False) -> None:
        self._weights = region(settings.observation_radius, settings.equivalence)
        self._evaporation, self._nodes_only = settings.evaporation, nodes_only
        self._strength = settings.pheromone * scenario.unit
        self._laid = np.zeros(ground.blocked.shape)
        self._touched, self._count = np.empty((ground.blocked.size, 2), np.int64), 0
        self.seen = np.full(ground.blocked.shape, settings.initial_pheromone * self._weights.sum())

    def lay(self, way: Floats, length: float) -> None:
        """Lay Q / L along a `way` (N, 2) [cells] of that `length` [m] (eq. 2 and 3)."""
        amount = self._strength / length
        self._count = lay_along(self._laid, self._touched, self._count, amount, way, self._nodes_only)

    def evaporate(self) -> None:
        """Let the old evaporate and the new be seen (eq. 4)."""
        evaporate_and_lay(self.seen, self._laid, self._touched, self._count, self._evaporation, self._weights)
        self._count = 0
