"""What planners of fleets share: their starts and goals checked, and what is told of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import shapely

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.kernel import Bools, Floats
from planners.scenario import Scenario

GAP = 1e-10  # [largest coordinates] by which rounding may move a place


def fleet_ends(scenario: Scenario, keep: float, planner: str, or_else: str = "give less clearance") -> Floats:
    """All starts, then all goals (S + G, 2) [m], each at least `keep` [m] from what is forbidden.

    Raises `InputError` for one that is nearer, with what to do `or_else`, and for a start that is a goal.
    """
    if not math.isfinite(keep):
        raise InputError(f"planner {planner}: clearance", f"{keep} m is not possible", "give a finite number")
    for i, j in np.argwhere((scenario.starts[:, None] == scenario.goals[None]).all(axis=2)):
        which = "its start is its goal"
        if len(scenario.starts) > 1 or len(scenario.goals) > 1:
            which = f"its start {i + 1} is its goal {j + 1}"
        raise InputError(scenario.name, which, "move one of them")
    ends = np.vstack([scenario.starts, scenario.goals])
    poses = np.column_stack([ends, np.zeros(len(ends))])
    depths = -clearance(scenario.map, poses, Disc(0.0))
    missing = -clearance(scenario.map, poses, Disc(keep))
    for i, (end, depth, lack) in enumerate(zip(ends, depths, missing, strict=True)):
        if not lack <= GAP * max(scenario.size):
            what = f"is {depth:.3g} m deep in what is forbidden"
            if depth <= 0.0:
                what = f"is {keep - lack:.3g} m from what is forbidden, nearer than the clearance of {keep:g} m"
            remedy = "move it to free ground" + (f", or {or_else}" if keep else "")
            raise InputError(f"{scenario.name}: {_end_name(scenario, i)}", f"{end.tolist()} m {what}", remedy)
    return ends


def _end_name(scenario: Scenario, index: int) -> str:
    """What the start or goal of that index is called; numbered from 1 where there are several."""
    starts, goals = len(scenario.starts), len(scenario.goals)
    name, number, count = ("start", index, starts) if index < starts else ("goal", index - starts, goals)
    return f"{name} {number + 1}" if count > 1 else name


def pair_name(scenario: Scenario, aircraft: int, target: int) -> str:
    """What the path of that aircraft to that target is called: after the scenario, where there is only one."""
    if len(scenario.starts) == len(scenario.goals) == 1:
        return scenario.name
    return f"aircraft {aircraft + 1} to target {target + 1}"


def unserved(scenario: Scenario, aircraft: set[int], why: str) -> tuple[str, ...]:
    """A note where some of the starts are not among the `aircraft` that have a path; `why` ends it."""
    left = [str(i + 1) for i in range(len(scenario.starts)) if i not in aircraft]
    if not left:
        return ()
    verb = "has" if len(left) == 1 else "have"
    return (f"aircraft {', '.join(left)} {verb} no path: {why}; paths are numbered on without",)


def why_unserved(scenario: Scenario) -> str:
    """The reason why an aircraft stays: too few targets, or none left that it reaches."""
    fewer = len(scenario.goals) < len(scenario.starts)
    return (
        "there are fewer targets than aircraft" if fewer else "no target that is left can be reached within the range"
    )


def joined(free: Any, ends: Floats, starts: int) -> Bools:
    """Which of the first `starts` of `ends` (S + G, 2) [m] share a part of `free` with which of the others (S, G)."""
    points = shapely.points(ends)
    reach = GAP * float(np.abs(ends).max(initial=1.0))
    inside = np.array([shapely.dwithin(part, points, reach) for part in shapely.get_parts(free)], dtype=bool)
    if not len(inside):
        return np.zeros((starts, len(ends) - starts), dtype=bool)
    return np.asarray((inside[:, :starts, None] & inside[:, None, starts:]).any(axis=0))
