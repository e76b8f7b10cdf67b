"""What metrics are computed from: a path, the track that followed it, and what surrounded both."""

from __future__ import annotations

from dataclasses import dataclass

from planners.map import Map
from planners.path import Path
from sim.vehicle import Conditions, Limits
from tracking.feasibility import Feasibility
from tracking.metric import Where
from tracking.track import Track


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """One run: `corridor` [m] is the half-width, `max_range` [m] the scenario's limit if it has one."""

    path: Path
    track: Track
    limits: Limits
    speed: float
    corridor: float
    conditions: Conditions
    feasibility: Feasibility
    obstacles: Map | None = None
    max_range: float | None = None

    def where(self, sample: int) -> Where:
        """Arc length and time of the track's sample of that index."""
        return Where(s=float(self.track["s"][sample]), t=float(self.track["t"][sample]))
