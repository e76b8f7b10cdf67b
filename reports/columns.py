"""The units of a track's columns, and how they are written where people read them."""

from __future__ import annotations

from planners.kernel import Floats
from reports.quantity import degrees
from tracking.track import Track

# Every column and every channel of the vehicles in the tree; one that is not here is written without a unit.
UNITS = {
    "t": "s", "x": "m", "y": "m", "z": "m", "s": "m", "cross_track": "m", "altitude_command": "m",
    "heading": "rad", "course": "rad", "path_heading": "rad", "bank": "rad", "pitch": "rad", "alpha": "rad",
    "beta": "rad", "angle_of_attack": "rad", "sideslip": "rad", "steering": "rad",
    "ground_speed": "m/s", "airspeed": "m/s", "climb_rate": "m/s", "speed_command": "m/s",
    "steering_rate": "rad/s", "yaw_rate": "rad/s", "roll_rate": "rad/s", "pitch_rate": "rad/s",
    "lateral_acceleration": "m/s^2", "curvature": "1/m", "curvature_command": "1/m",
    "saturated": "1", "load_factor": "g", "stall_margin": "rad", "throttle": "1", "friction_use": "1",
    "elevator": "1", "aileron": "1", "rudder": "1",
}  # fmt: skip
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
