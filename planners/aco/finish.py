"""How a colony's search becomes a plan."""

from __future__ import annotations

import numpy as np

from planners.aco.colony import Found
from planners.ground import Ground
from planners.kernel import Floats
from planners.path import Path
from planners.planner import NO_PATH, NOT_FOUND, Plan
from planners.rounding import Rounded, rounded, taut
from planners.scenario import Scenario


def without_path(clearance: float) -> Plan:
    """The answer where a flood fill does not reach the goal."""
    what = f"no free cells lead from the start to the goal with {clearance:g} m of clearance"
    return Plan(outcome=NO_PATH, reason=what)


def not_found(found: Found, keeping: str = "") -> Plan:
    """The answer where no ant arrived, though a way exists; `keeping` says what else they had to keep to."""
    history = found.history
    what = f"none of {history.population} ants arrived in any of {len(history.survivors)} iterations"
    return Plan(outcome=NOT_FOUND, reason=f"{what}{keeping}", history=history)


def finished(found: Found, ground: Ground, scenario: Scenario, name: str, tight: bool, radius: float) -> Plan:
    """The shortest way, pulled taut where it is to be `tight`, its corners rounded with `radius` [m], as drawn with 0.

    It is rounded as it was found: a line already taut leaves the rounding less room.
    """
    if found.way is None:
        return not_found(found)
    drawn = path_of(ground.to_metres(taut(ground, found.way) if tight else found.way), scenario, name)
    if radius == 0.0:
        return Plan(paths=(drawn,), polylines=(drawn,), history=found.history)
    smooth = rounded(ground, found.way, radius)
    return Plan(
        paths=(path_of(smooth.points, scenario, name),),
        polylines=(drawn,),
        notes=tight_notes(smooth, radius),
        smallest_radius=smooth.smallest_radius,
        history=found.history,
    )


def path_of(points: Floats, scenario: Scenario, name: str) -> Path:
    """The line (N, 2) [m] as a path from the very start to the very goal of the scenario."""
    apart = np.concatenate([[True], (np.diff(points, axis=0) != 0.0).any(axis=1)])
    points = points[apart]
    points[0], points[-1] = scenario.starts[0], scenario.goals[0]
    return Path(points, name=name, frame=scenario.map.frame)


def tight_notes(smooth: Rounded, radius: float) -> tuple[str, ...]:
    """A line for each corner that obstacles leave less than `radius` [m]."""
    return tuple(
        f"corner at ({tight.x / 1000:.2f}, {tight.y / 1000:.2f}) km: pulled back to a radius of {tight.radius:.0f} m, "
        f"obstacles leave no room for {radius:.0f} m"
        for tight in smooth.tight
    )
