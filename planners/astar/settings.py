"""What the planners for ground vehicles are told of the vehicle."""

from __future__ import annotations

from typing import Annotated

import msgspec
from msgspec.structs import replace

from planners.errors import InputError
from planners.planner import Planner
from planners.units import parse_speed

DEFAULT_SPEED = 45.0 / 3.6  # [m/s]
FASTEST = 400.0  # [m/s] the land speed record is 341 m/s

Length = Annotated[float, msgspec.Meta(gt=0.0, le=100.0)]


class SpeedSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The `speed` that a path is planned for: as 12.5, "45km/h"; None for that of the case, or 45 km/h."""

    speed: str | float | None = None

    def __post_init__(self) -> None:
        if self.speed is not None and parse_speed(self.speed, "set.speed") > FASTEST:
            raise InputError("set.speed", f"{self.speed} is faster than any vehicle on the ground", "give less")

    @property
    def planned_speed(self) -> float:
        """The speed [m/s]."""
        return DEFAULT_SPEED if self.speed is None else parse_speed(self.speed)


def planned_speed(planner: Planner) -> float | None:
    """The speed [m/s] that `planner` plans for, None for one that plans for no speed."""
    return planner.planned_speed if isinstance(planner, SpeedSettings) else None


def for_speed(planner: Planner, speed: float) -> Planner:
    """`planner` with its speed as a number [m/s]: the one it was set to, else `speed`; any other planner as it is."""
    if not isinstance(planner, SpeedSettings):
        return planner
    return replace(planner, speed=speed if planner.speed is None else planner.planned_speed)
