"""What papers claim of planners, beside which a campaign's own plans are shown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated

import msgspec

from campaigns.case import Case, Count
from planners.all_planners import make_planner
from planners.astar.heading_limits import STEP_TIME
from planners.astar.settings import planned_speed
from planners.errors import InputError
from planners.scenario import stem_of
from planners.typed_toml import suggestion
from planners.units import parse_speed

Positive = Annotated[float, msgspec.Meta(gt=0.0)]
Angle = Annotated[float, msgspec.Meta(ge=0.0, le=180.0)]
SAME = 1e-3  # of a speed: a case may have it in m/s, rounded
Ants = tuple[Annotated[int, msgspec.Meta(ge=0)], Count]


class Beside(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The source's own figures, as "Fig. 10", beside which ours stand; "" for none."""

    plan: str = ""
    ants: str = ""
    comparison: str = ""
    roadmap: str = ""
    sectors: str = ""


class Claim(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What a `source` says of a `planner`: `length` [map units] of its path, its largest `turn` [deg], the `iterations`
    it takes, and `survivors`, of how many. Of a fleet `length` is the sum over its paths, and `longest` is its longest.
    `straight` [map units] is how far start and goal are apart on the source's own map, where it says so.

    With a `speed` it is about plans for that speed. It holds on one `scenario`, by the name of its file, at every
    scale; "" for that of the first case that plans so.
    """

    planner: str
    source: str
    scenario: str = ""
    speed: str | float | None = None
    straight: Positive | None = None
    length: Positive | None = None
    longest: Positive | None = None
    turn: Angle | None = None
    iterations: Count | None = None
    survivors: Ants | None = None
    beside: Beside = Beside()

    def holds_for(self, speed: float | None) -> bool:
        """Whether it is about plans for that `speed` [m/s], None for that of a planner that plans for none."""
        return self.speed is None or (speed is not None and math.isclose(parse_speed(self.speed), speed, rel_tol=SAME))

    def needed(self, speed: float | None) -> float | None:
        """The lateral acceleration [m/s^2] of its largest turn at its own speed, else at `speed` [m/s]; None for none.

        That of an arc which turns so far in one step of `STEP_TIME` (paper 004, section 2.2), as `planners.needed` has
        it of a path.
        """
        speed = speed if self.speed is None else parse_speed(self.speed)
        return None if speed is None or self.turn is None else speed * math.radians(self.turn) / STEP_TIME


def check_claims(claims: Sequence[Claim], cases: Sequence[Case], file: str) -> None:
    """Raises `InputError` with the place in `file` of a claim on what none of `cases` plans with, or plans on."""
    known = sorted({case.planner for case in cases if isinstance(case.planner, str)})
    for i, claim in enumerate(claims):
        if claim.planner not in known:
            remedy = suggestion(claim.planner, known) if known else "add a case with that planner"
            raise InputError(f"{file}: claim[{i}]", f"no case plans with {claim.planner!r}", remedy)
        on = sorted({stem_of(case.scenario) for case in cases if case.planner == claim.planner and case.scenario})
        if claim.scenario and claim.scenario not in on:
            what = f"no case plans on {claim.scenario!r} with {claim.planner}"
            raise InputError(f"{file}: claim[{i}]", what, suggestion(claim.scenario, on))
        if claim.speed is not None:
            parse_speed(claim.speed, f"{file}: claim[{i}]: speed")
            _check_speed(claim, [case for case in cases if case.planner == claim.planner], f"{file}: claim[{i}]")


def _check_speed(claim: Claim, cases: Sequence[Case], place: str) -> None:
    """Raises `InputError` where the claim's planner, or none of `cases` as far as they say it, plans for its speed."""
    if planned_speed(make_planner(claim.planner)) is None:
        raise InputError(place, f"{claim.planner} plans for no speed", "leave speed out")
    stated = [case.set.get("speed", case.speed) for case in cases]
    if not any(speed is None or claim.holds_for(parse_speed(speed, f"{place}: speed of its case")) for speed in stated):
        remedy = f"use {', '.join(dict.fromkeys(map(str, stated)))}"
        raise InputError(place, f"no case plans for {claim.speed} with {claim.planner}", remedy)
