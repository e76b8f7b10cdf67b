"""The seam to controllers: truth and path in, commanded curvature out."""

from __future__ import annotations

from typing import Protocol

from planners.path import Path, Projection
from sim.vehicle import Limits, State


class Controller(Protocol):
    """Commands a path curvature over the ground [1/m, left positive], whatever the vehicle.

    `dt` [s] is the guidance period. Time constants derive from `Limits.response_time`, so that one tuning serves an
    aircraft and a truck.
    """

    name: str

    def reset(self, limits: Limits, dt: float) -> None:
        """Prepare for a run with a vehicle of these `limits`."""

    def curvature(self, state: State, path: Path, at: Projection) -> float:
        """Curvature [1/m] to command at `state`, projected on `path` at `at`."""


def delay(limits: Limits, dt: float) -> float:
    """Effective delay [s] from a decision to its effect: the vehicle's lag and half of the guidance period's hold."""
    return limits.response_time + dt / 2
