"""The corners of a path rounded for the vehicle that is to fly by them, and what that does to the path."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from campaigns.conditions import ConditionKeys, known_wind
from planners.corners import Rounded, fly_by
from planners.errors import InputError
from planners.path import Path
from sim.vehicle import Limits
from sim.wind import Wind
from tracking.feasibility import required_radius

RESERVE = 1.2  # of the required radius: a turn at the limit leaves a controller nothing to steer with
ARC_DEVIATION = 1 / 300  # of the corridor, within which arcs are drawn as points
ENOUGH = 0.999  # of the radius wanted
ONE_BY_ONE = 3  # corners that are told of each


def fly_by_corners(
    path: Path, limits: Limits, speed: float, conditions: ConditionKeys, corridor: float
) -> tuple[Path, list[str]]:
    """Corners as wide as the wind asks for that is known beforehand, or as calm air does where it is drawn.

    Lines tell of each corner, or of all together where there are many.
    """
    wind = known_wind(conditions) or Wind()

    def radius(course: float, angle: float) -> float:
        required = RESERVE * required_radius(limits, speed, wind, course, angle)
        if not np.isfinite(required):
            raise InputError("wind", f"{wind.speed:.4g} m/s of wind cannot be held at {speed:.4g} m/s")
        return required

    rounded_path, corners = fly_by(path, radius, ARC_DEVIATION * corridor)
    return rounded_path, _notes(corners)


def _notes(corners: Sequence[Rounded]) -> list[str]:
    if len(corners) <= ONE_BY_ONE:
        return [_note(corner) for corner in corners]
    drawn = [corner for corner in corners if corner.radius == 0.0]
    short = [corner for corner in corners if 0.0 < corner.radius < ENOUGH * corner.wanted]
    smallest = min((corner.radius for corner in corners if corner.radius > 0.0), default=0.0)
    most = max(corners, key=lambda corner: corner.cut)
    all_of_them = f"{len(corners)} corners: rounded with a radius of {smallest:.0f} m or more"
    told = [f"{all_of_them}, cut by at most {most.cut:.1f} m, at {most.s / 1000:.2f} km"]
    if short:
        told.append(f"{len(short)} of them with less than the {short[0].wanted:.0f} m wanted, the legs leave no more")
    return ["; ".join(told), *(_note(corner) for corner in drawn)]


def _note(corner: Rounded) -> str:
    where = f"corner at {corner.s / 1000:.2f} km, {abs(np.degrees(corner.angle)):.0f} deg"
    if corner.radius == 0.0:
        return f"{where}: left as drawn, too sharp to fly by"
    short = f" (wanted {corner.wanted:.0f} m, the legs leave no more)" if corner.radius < ENOUGH * corner.wanted else ""
    return f"{where}: rounded with a radius of {corner.radius:.0f} m{short}, cut by {corner.cut:.1f} m"
