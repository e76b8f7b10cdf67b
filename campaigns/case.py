"""A case as a user states it, in a campaign file or on the command line."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from campaigns.conditions import CALM, ConditionKeys
from planners.outside import OutsidePlanner
from tracking.verdict import TRACKWORTHY, Expectation

Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Count = Annotated[int, msgspec.Meta(ge=1, le=1_000_000)]


class Case(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """One path, from a file or a planner, under one vehicle, tried `trials` times.

    Quantities are as users write them; what is left out is the vehicle's default. The case is trackworthy when at
    least `pass_share` of its trials are. A `planner`, one of ours by name with the settings in `set` or one of others,
    plans once for each `plan_seed`, and with `replan` once for each trial.
    """

    path: str = ""
    planner: str | OutsidePlanner | None = None
    set: dict[str, Any] = {}
    plan_seed: int = 0
    replan: bool = False
    scenario: str | None = None
    vehicle: str
    name: str = ""
    controller: str = "lqr"
    speed: str | float | None = None
    altitude: str | float | None = None
    corridor: str | float | None = None
    corners: Literal["as-drawn", "fly-by"] = "as-drawn"
    steering_hz: float = 20.0
    conditions: ConditionKeys = CALM
    trials: Count = 1
    pass_share: Share = 1.0
    require: tuple[str, ...] = ()
    expect: Expectation = TRACKWORTHY
