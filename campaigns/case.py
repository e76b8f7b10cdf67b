"""A case as a user states it, in a campaign file or on the command line."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from campaigns.conditions import CALM, ConditionKeys
from planners.outside import OutsidePlanner
from tracking.fleet import Departures
from tracking.verdict import TRACKWORTHY, Expectation

Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Corners = Literal["as-drawn", "fly-by"]
Unit = Annotated[float, msgspec.Meta(gt=0.0)]
Count = Annotated[int, msgspec.Meta(ge=1, le=1_000_000)]


class Case(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """One path, from a file or a planner, under one vehicle, tried `trials` times.

    Quantities are as users write them; what is left out is the vehicle's default. The case is trackworthy when at
    least `pass_share` of its trials are. A `planner`, one of ours by name with the settings in `set` or one of others,
    plans once for each `plan_seed`, and with `replan` once for each trial. A scenario with several starts gives a
    fleet, and so do the paths of `others` beside the first; its `departures` are together, or separated by delays that
    keep it `separation` apart.

    `unit` are the metres a unit of the scenario's map stands for, in place of its own, and `planet` is where all of it
    happens: if it is left out, where the scenario lies, or else where the vehicle is at home.
    """

    path: str = ""
    others: tuple[str, ...] = ()
    planner: str | OutsidePlanner | None = None
    set: dict[str, Any] = {}
    plan_seed: int = 0
    replan: bool = False
    scenario: str | None = None
    unit: Unit | None = None
    planet: str | None = None
    vehicle: str
    name: str = ""
    controller: str = "lqr"
    speed: str | float | None = None
    altitude: str | float | None = None
    corridor: str | float | None = None
    corners: Corners = "as-drawn"
    steering_hz: float = 20.0
    departures: Departures = "together"
    separation: str | float | None = None
    conditions: ConditionKeys = CALM
    trials: Count = 1
    pass_share: Share = 1.0
    require: tuple[str, ...] = ()
    expect: Expectation = TRACKWORTHY
