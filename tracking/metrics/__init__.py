"""The metrics: one function an idea, and one line here."""

from __future__ import annotations

from collections.abc import Callable

from tracking.metric import Metric
from tracking.metrics.clearance import body_clearance
from tracking.metrics.corridor import completion, corridor, lengths
from tracking.metrics.errors import cross_track
from tracking.metrics.following import altitude, angles, speed
from tracking.metrics.frechet import frechet
from tracking.metrics.fuel import fuel
from tracking.metrics.loads import aircraft_loads, ground_loads, saturation
from tracking.metrics.turning import corners, turn_angles, turn_radii
from tracking.run import Run

ALL_METRICS: tuple[Callable[[Run], list[Metric]], ...] = (
    cross_track,
    corridor,
    completion,
    angles,
    altitude,
    speed,
    frechet,
    lengths,
    turn_angles,
    turn_radii,
    corners,
    aircraft_loads,
    ground_loads,
    saturation,
    fuel,
    body_clearance,
)


def measure(run: Run) -> dict[str, Metric]:
    """Every metric of `run`, by name."""
    return {metric.name: metric for compute in ALL_METRICS for metric in compute(run)}
