"""How a colony's search becomes a plan."""

from __future__ import annotations

from planners.aco.colony import Found
from planners.ground import Ground, path_of
from planners.planner import NOT_FOUND, Plan
from planners.rounding import Rounded, rounded, taut
from planners.scenario import Scenario


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


def tight_notes(smooth: Rounded, radius: float) -> tuple[str, ...]:
    """A line for each corner that obstacles leave less than `radius` [m]."""
    return tuple(
        f"corner at ({tight.x / 1000:.2f}, {tight.y / 1000:.2f}) km: pulled back to a radius of {tight.radius:.0f} m, "
        f"obstacles leave no room for {radius:.0f} m"
        for tight in smooth.tight
    )
