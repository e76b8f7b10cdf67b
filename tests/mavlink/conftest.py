"""An outcome known exactly: a left circle of 500 m radius at 50 m/s, flown 3 m outside of its path."""

import dataclasses
import math

import numpy as np
import pytest

from planners.footprint import Disc
from planners.frame import Frame
from planners.path import Path
from sim.vehicle import Conditions, Limits
from tracking.feasibility import Feasibility
from tracking.outcome import Outcome
from tracking.track import GUIDANCE_COLUMNS, STATE_COLUMNS, Track
from tracking.verdict import Verdict

SPEED, RADIUS, OUTSIDE = 50.0, 500.0, 3.0
BANK = math.atan(SPEED**2 / (9.80665 * RADIUS))
LIMITS = Limits(
    kind="fixed-wing", speed=50.0, speed_min=35.0, speed_max=65.0, lateral_acceleration=9.8, response_time=1.0,
    equivalent_length=50.0, corridor=30.0, footprint=Disc(5.5),
)  # fmt: skip


def circle(radius, angle):
    return np.column_stack([radius * np.sin(angle), RADIUS - radius * np.cos(angle)])


def flown(frame=Frame(48.1, 11.6), kind="fixed-wing", seconds=20.0, dt=0.05):  # noqa: B008
    """Eastward at the start, left turn; -OUTSIDE is right of the path."""
    t = np.arange(0.0, seconds, dt)
    angle = SPEED / (RADIUS + OUTSIDE) * t
    ends = np.linspace(0.0, max(angle[-1], 0.1), 200)
    path = Path(np.column_stack([circle(RADIUS, ends), np.full(200, 400.0)]), frame, "circle")
    xy = circle(RADIUS + OUTSIDE, angle)
    columns = dict.fromkeys((*STATE_COLUMNS, "bank", "pitch", "throttle", *GUIDANCE_COLUMNS), np.zeros(len(t)))
    columns |= {
        "t": t, "x": xy[:, 0], "y": xy[:, 1], "z": 400.0 + 2.0 * t, "heading": angle, "course": angle,
        "ground_speed": np.full(len(t), SPEED), "airspeed": np.full(len(t), SPEED + 1.0),
        "climb_rate": np.full(len(t), 2.0), "curvature": np.full(len(t), 1 / RADIUS), "bank": np.full(len(t), BANK),
        "pitch": np.full(len(t), 0.05), "throttle": np.full(len(t), 0.65), "s": RADIUS * angle,
        "cross_track": np.full(len(t), -OUTSIDE), "path_heading": angle,
        "curvature_command": np.full(len(t), 1 / RADIUS),
        "speed_command": np.full(len(t), SPEED), "altitude_command": np.full(len(t), 400.0),
    }  # fmt: skip
    track = Track(tuple(columns), np.column_stack(list(columns.values())), "completed", frame)
    limits = dataclasses.replace(LIMITS, kind=kind)
    return Outcome(
        name="circle", path=path, obstacles=None, vehicle="c172x", limits=limits, controller="lqr", speed=SPEED,
        corridor=30.0, conditions=Conditions(), seed=0, track=track, metrics={}, feasibility=Feasibility((), ()),
        verdict=Verdict(()),
    )  # fmt: skip


@pytest.fixture(scope="session")
def fly():
    return flown
