"""Paths moved into the frame of a scenario, or onto another planet."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from planners.errors import InputError
from planners.frame import Frame
from planners.path import Path
from planners.scenario import Scenario


def in_frame_of(scenario: Scenario, path: Path) -> Path:
    """`path` in the scenario's frame, so that its map need not be moved; one without a frame is taken to be in it.

    Raises `InputError` for a path on the planet when the scenario has no origin there.
    """
    frame = scenario.map.frame
    if path.frame is None or path.frame == frame:
        return path
    if frame is None:
        raise InputError(
            scenario.name, "this scenario has no place on the planet, but the path has", "give it origin = [lat, lon]"
        )
    return _moved(path, path.frame, frame)


def in_frame_with(first: Path, path: Path) -> Path:
    """`path` in the frame of the `first`; raises `InputError` where only one of them has a place on the planet."""
    if path.frame == first.frame:
        return path
    if path.frame is None or first.frame is None:
        what = f"only one of {first.name} and {path.name} has a place on the planet"
        raise InputError("paths of a fleet", what, "give all in metres, or all in degrees")
    return _moved(path, path.frame, first.frame)


def on_ellipsoid(path: Path, a: float, b: float) -> Path:
    """`path` at the same latitudes and longitudes of the ellipsoid with semi-axes `a`, `b` [m].

    Files give those and no planet, so they are read as the Earth's. A path without a frame stays as it is.
    """
    frame = path.frame
    if frame is None or (frame.a, frame.b) == (a, b):
        return path
    return _moved(path, frame, Frame(frame.lat, frame.lon, a, b))


def _moved(path: Path, old: Frame, new: Frame) -> Path:
    xy = new.to_local(*old.to_geographic(path.xy).T)
    return replace(path, points=np.column_stack([xy, path.points[:, 2:]]), frame=new)
