"""Planned and flown lines as geographic coordinates, for the formats that know nothing else."""

from __future__ import annotations

import numpy as np

from planners.errors import InputError
from planners.frame import Frame
from planners.kernel import Floats
from planners.path import Path
from tracking.outcome import Outcome


def frame_of(path: Path, what: str) -> Frame:
    """Where the path lies; raises `InputError` for one in a local frame only, which `what` cannot hold."""
    if path.frame is None:
        raise InputError(
            path.name,
            f"has no geographic origin, which {what} needs",
            "give the path in latitude and longitude, or export CSV",
        )
    return path.frame


def planned(outcome: Outcome, frame: Frame) -> Floats:
    """The path as longitude, latitude [deg] and height [m], (N, 3); else at the commanded heights."""
    path = outcome.path
    heights = path.z if path.z is not None else _commanded(outcome)
    return _places(path.xy, heights, frame)


def flown(outcome: Outcome, frame: Frame) -> Floats:
    """The track's finite samples as longitude, latitude [deg] and height [m], (N, 3)."""
    xyz = np.column_stack([outcome.track[column] for column in ("x", "y", "z")])
    xyz = xyz[np.isfinite(xyz).all(axis=1)]
    return _places(xyz[:, :2], xyz[:, 2], frame)


def _places(xy: Floats, heights: Floats, frame: Frame) -> Floats:
    if not len(xy):
        return np.empty((0, 3))
    places = frame.to_geographic(xy)
    # A line over the antimeridian goes on beyond 180 degrees, else it would be drawn around the planet.
    return np.column_stack([np.unwrap(places[:, 1], period=360.0), places[:, 0], heights])


def _commanded(outcome: Outcome) -> Floats:
    track = outcome.track
    samples = np.column_stack([track["s"], track["altitude_command"]])
    samples = samples[np.isfinite(samples).all(axis=1)]
    if not len(samples):
        return np.zeros(len(outcome.path.s))
    order = np.argsort(samples[:, 0], kind="stable")
    return np.interp(outcome.path.s, *samples[order].T)
