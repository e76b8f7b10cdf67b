"""Searches for the border of what is trackworthy, as a user states them: the smallest scale, the top speed."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

import msgspec
from msgspec.structs import replace

from campaigns.case import Case, Corners, Unit
from campaigns.conditions import CALM, ConditionKeys
from planners.units import parse_speed

Tolerance = Annotated[float, msgspec.Meta(ge=0.001, le=1.0)]
Speed = str | float


class _Search(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What all searches share: what is planned and how it is followed is as in a case, in conditions without chance."""

    name: str = ""
    set: dict[str, Any] = {}
    plan_seed: int = 0
    vehicle: str
    controller: str = "lqr"
    speed: Speed | None = None
    altitude: str | float | None = None
    corridor: str | float | None = None
    corners: Corners = "as-drawn"
    steering_hz: float = 20.0
    conditions: ConditionKeys = CALM
    require: tuple[str, ...] = ()
    tolerance: Tolerance = 0.02

    @property
    def case(self) -> Case:
        """What is planned and followed each time."""
        shared = [key for key in self.__struct_fields__ if key in Case.__struct_fields__ and key != "replan"]
        return Case(**{key: getattr(self, key) for key in shared})


class ScaleSearch(_Search, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """How small a map may be, in metres a map unit, for the plan on it to be trackworthy; looked for `between` two.

    The found scale is at most `tolerance` times itself above one that is not. With `replan` it is planned anew at each
    scale, with the settings as they are; without, once at the map's own, and that route drawn smaller or larger. With
    `expect_at_most` [m a map unit] the answer passes or fails.
    """

    BLOCK: ClassVar[str] = "smallest_scale"
    UNIT: ClassVar[str] = "m"

    scenario: str
    planner: str
    replan: bool = True
    between: tuple[Unit, Unit] = (0.5, 100.0)
    expect_at_most: Unit | None = None

    def settled(self, case: Case) -> ScaleSearch:
        """With the quantities of its settled `case`."""
        return replace(self, set=case.set, speed=case.speed, corridor=case.corridor)

    @property
    def ends(self) -> tuple[float, float]:
        """Of the range, that where all is easiest first."""
        low, high = self.between
        return high, low

    def as_expected(self, found: float | None) -> bool | None:
        """Whether the smallest scale `found` is as expected; None where nothing was expected."""
        return None if self.expect_at_most is None else found is not None and found <= self.expect_at_most


class SpeedSearch(_Search, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """How fast a path may be followed and be trackworthy; looked for `between` two speeds.

    The next that is not is at most `tolerance` times the found speed above it. The path is the same at every speed:
    that of a file, or the one that a planner gives once for `speed`; of `corners` to be flown by, the waypoints are.
    With `expect_at_least` the answer passes or fails.
    """

    BLOCK: ClassVar[str] = "top_speed"
    UNIT: ClassVar[str] = "m/s"

    path: str = ""
    planner: str | None = None
    scenario: str | None = None
    unit: Unit | None = None
    between: tuple[Speed, Speed]
    expect_at_least: Speed | None = None

    def settled(self, case: Case) -> SpeedSearch:
        """With the quantities of its settled `case`, its speeds in m/s; raises `InputError` for one that is none."""
        low, high = (parse_speed(speed, "between") for speed in self.between)
        least = None if self.expect_at_least is None else parse_speed(self.expect_at_least, "expect_at_least")
        # A default speed is none that a path from a file was planned for
        speed = None if self.speed is None else case.speed
        return replace(
            self, set=case.set, speed=speed, corridor=case.corridor, between=(low, high), expect_at_least=least
        )

    @property
    def planned_for(self) -> float | None:
        """The speed [m/s] that the path is planned for, of a settled search; None where it is not known, or none."""
        speed = self.speed if self.planner is None else self.set.get("speed")
        return None if speed is None else float(speed)

    @property
    def ends(self) -> tuple[float, float]:
        """Of the range [m/s], that where all is easiest first; of a settled search."""
        low, high = map(float, self.between)
        return low, high

    def as_expected(self, found: float | None) -> bool | None:
        """Whether the top speed `found` [m/s] is as expected, of a settled search; None where nothing was expected."""
        if self.expect_at_least is None:
            return None
        return found is not None and found >= float(self.expect_at_least)


Search = ScaleSearch | SpeedSearch
ALL_SEARCHES: tuple[type[Search], ...] = (ScaleSearch, SpeedSearch)
