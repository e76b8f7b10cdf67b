"""The planners: one file each, and one line here."""

from __future__ import annotations

from typing import Any, cast

import msgspec
import numpy as np

from planners.aco.basic import AcoBasic, AcoBasicPrinted
from planners.aco.improved import AcoImproved
from planners.aco.turn_aware import AcoTurnAware
from planners.astar.arc import AstarArc
from planners.astar.arc_printed import AstarArcPaper
from planners.astar.grid import AstarEight, AstarFour
from planners.errors import InputError
from planners.exact import Exact
from planners.pio.vdp import Vdp, VdpPio
from planners.planner import Plan, Planner
from planners.scenario import Scenario
from planners.typed_toml import convert, suggestion
from planners.voronoi.vd import Vd

ALL_PLANNERS: tuple[type[Planner], ...] = (
    Exact, AcoBasicPrinted, AcoBasic, AcoImproved, AcoTurnAware, Vd, VdpPio, Vdp,
    AstarFour, AstarEight, AstarArcPaper, AstarArc,
)  # fmt: skip


def make_planner(name: str, settings: dict[str, Any] | None = None) -> Planner:
    """The planner of that name with these settings; raises `InputError` for an unknown one, or an impossible value."""
    found = next((planner for planner in ALL_PLANNERS if planner.name == name), None)
    names = [planner.name for planner in ALL_PLANNERS]
    if found is None:
        raise InputError("planner", f"there is no planner {name!r}", suggestion(name, names))
    return cast(Planner, convert(settings or {}, cast("type[msgspec.Struct]", found), f"planner {name}"))


def plan_with(planner: Planner, scenario: Scenario, seed: int) -> Plan:
    """The plan of that seed, which decides all that is random in it."""
    return planner.plan(scenario, np.random.default_rng(seed))
