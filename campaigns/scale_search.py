"""The search for the smallest scale of a map, as a user states it."""

from __future__ import annotations

from typing import Annotated, Any

import msgspec

from campaigns.case import Case, Corners, Unit
from campaigns.conditions import CALM, ConditionKeys


class ScaleSearch(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """How small a map may be, in metres a map unit, for the plan on it to be trackworthy; looked for `between` two.

    The found scale is at most `tolerance` times itself above one that is not. What is planned and how it is flown is as
    in a case, in conditions without chance. With `replan` it is planned anew at each scale, with the settings as they
    are; without, once at the map's own, and that route drawn smaller or larger. With `expect_at_most` [m a map unit]
    the answer passes or fails.
    """

    name: str = ""
    scenario: str
    planner: str
    set: dict[str, Any] = {}
    plan_seed: int = 0
    replan: bool = True
    vehicle: str
    controller: str = "lqr"
    speed: str | float | None = None
    altitude: str | float | None = None
    corridor: str | float | None = None
    corners: Corners = "as-drawn"
    conditions: ConditionKeys = CALM
    require: tuple[str, ...] = ()
    between: tuple[Unit, Unit] = (0.5, 100.0)
    tolerance: Annotated[float, msgspec.Meta(ge=0.001, le=1.0)] = 0.02
    expect_at_most: Unit | None = None

    @property
    def case(self) -> Case:
        """What is planned and flown at each scale."""
        return Case(
            name=self.name, scenario=self.scenario, planner=self.planner, set=self.set, plan_seed=self.plan_seed,
            vehicle=self.vehicle, controller=self.controller, speed=self.speed, altitude=self.altitude,
            corridor=self.corridor, corners=self.corners, conditions=self.conditions, require=self.require,
        )  # fmt: skip
