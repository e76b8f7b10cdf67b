"""What papers claim of planners, beside which a campaign's own plans are shown."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import msgspec

from campaigns.case import Case, Count
from planners.errors import InputError
from planners.typed_toml import suggestion

Positive = Annotated[float, msgspec.Meta(gt=0.0)]
Angle = Annotated[float, msgspec.Meta(ge=0.0, le=180.0)]
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

    It holds on one `scenario`, by the name of its file, at every scale; "" for that of the first case that plans so.
    """

    planner: str
    source: str
    scenario: str = ""
    length: Positive | None = None
    longest: Positive | None = None
    turn: Angle | None = None
    iterations: Count | None = None
    survivors: Ants | None = None
    beside: Beside = Beside()


def check_claims(claims: Sequence[Claim], cases: Sequence[Case], file: str) -> None:
    """Raises `InputError` with the place in `file` of a claim on what none of `cases` plans with, or plans on."""
    known = sorted({case.planner for case in cases if isinstance(case.planner, str)})
    for i, claim in enumerate(claims):
        if claim.planner not in known:
            remedy = suggestion(claim.planner, known) if known else "add a case with that planner"
            raise InputError(f"{file}: claim[{i}]", f"no case plans with {claim.planner!r}", remedy)
        on = sorted({Path(case.scenario).stem for case in cases if case.planner == claim.planner and case.scenario})
        if claim.scenario and claim.scenario not in on:
            what = f"no case plans on {claim.scenario!r} with {claim.planner}"
            raise InputError(f"{file}: claim[{i}]", what, suggestion(claim.scenario, on))
