"""A track's columns and their units as they are written where people read them."""

from __future__ import annotations

from planners.kernel import Floats
from planners.units import degrees
from tracking.columns import UNITS
from tracking.track import Track

FROM_EAST = (
    "heading",
    "course",
    "path_heading",
)  # not a compass's: from east, left positive; their header says so


def header(column: str) -> str:
    """The column's name with its unit as exported: "bank [deg]", "heading [deg from east]"."""
    unit = UNITS.get(column)
    if unit is None:
        return column
    shown = degrees(0.0, unit)[1]
    return f"{column} [{shown} from east]" if column in FROM_EAST else f"{column} [{shown}]"


def exported(track: Track, column: str) -> Floats:
    """The column's values (N,) in the unit its header names."""
    factor = degrees(1.0, UNITS.get(column, ""))[0]
    return factor * track[column]
