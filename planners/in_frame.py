"""Paths moved into the frame of a scenario."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from planners.errors import InputError
from planners.path import Path
from planners.scenario import Scenario


def in_frame_of(scenario: Scenario, path: Path) -> Path:
    """`path` in the scenario's frame, so that its map need not be moved; one without a frame is taken to be in it.

    Raises `InputError` for a path on the planet when the scenario has no origin there.
    """
    if path.frame is None:
        return path
    frame = scenario.map.frame
    if frame is None:
        raise InputError(
            scenario.name, "this scenario has no place on the planet, but the path has", "give it origin = [lat, lon]"
        )
    geographic = path.frame.to_geographic(path.xy)
    xy = frame.to_local(geographic[:, 0], geographic[:, 1])
    return replace(path, points=np.column_stack([xy, path.points[:, 2:]]), frame=frame)
