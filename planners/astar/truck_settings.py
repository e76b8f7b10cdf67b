"""A ground vehicle as a planner sees it."""

from __future__ import annotations

import math
from typing import Annotated

import msgspec

from planners.astar.heading_limits import LATERAL, STEP_TIME, curvature_limit
from planners.astar.settings import Length, SpeedSettings
from planners.errors import InputError
from planners.units import STANDARD_GRAVITY

Angle = Annotated[float, msgspec.Meta(gt=0.0, lt=90.0)]
Share = Annotated[float, msgspec.Meta(gt=0.0, le=2.0)]


class TruckSettings(SpeedSettings, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A ground vehicle in metres, degrees and g; by default the truck that is driven here.

    Its body, `length` by `width`, reaches `overhang` behind the rear axle, which is its reference point. A path keeps
    to `lateral` [g] and to `steering_limit` [deg] at the front wheels, and turns them by at most `steering_rate`
    [deg/s].
    """

    wheelbase: Length = 4.5
    length: Length = 7.0
    width: Length = 2.5
    overhang: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 1.25
    lateral: Share = LATERAL
    steering_limit: Angle = 45.0
    steering_rate: Annotated[float, msgspec.Meta(gt=0.0, le=1000.0)] = 30.0

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.overhang > self.length:
            what = f"{self.overhang:g} m are longer than the body of {self.length:g} m"
            raise InputError("overhang", what, "give how far it reaches behind the rear axle")

    @property
    def step(self) -> float:
        """The way [m] from one steering action to the next (paper 004, eq. 10)."""
        return self.planned_speed * STEP_TIME

    def curvature(self, lateral: float) -> float:
        """The largest curvature [1/m] that `lateral` [g] and the steering leave."""
        return curvature_limit(
            self.planned_speed, self.wheelbase, lateral * STANDARD_GRAVITY, math.radians(self.steering_limit)
        )

    def curvature_rate(self, steering_rate: float) -> float:
        """How fast the curvature may change along the path [1/m^2], wheels turning at `steering_rate` [deg/s].

        d(tan(delta) / L) / ds >= delta' / (L v), with which straight wheels begin.
        """
        return math.radians(steering_rate) / (self.wheelbase * self.planned_speed)
