"""The units of a track's columns."""

from __future__ import annotations

# Every column and every channel of the vehicles in the tree; one that is not here is written without a unit.
UNITS = {
    "t": "s", "x": "m", "y": "m", "z": "m", "s": "m", "cross_track": "m", "altitude_command": "m",
    "heading": "rad", "course": "rad", "path_heading": "rad", "bank": "rad", "pitch": "rad", "alpha": "rad",
    "beta": "rad", "angle_of_attack": "rad", "sideslip": "rad", "steering": "rad",
    "ground_speed": "m/s", "airspeed": "m/s", "climb_rate": "m/s", "speed_command": "m/s",
    "steering_rate": "rad/s", "yaw_rate": "rad/s", "roll_rate": "rad/s", "pitch_rate": "rad/s",
    "lateral_acceleration": "m/s^2", "curvature": "1/m", "curvature_command": "1/m",
    "saturated": "1", "load_factor": "g", "stall_margin": "rad", "throttle": "1", "friction_use": "1",
    "elevator": "1", "aileron": "1", "rudder": "1", "fuel": "kg",
}  # fmt: skip
