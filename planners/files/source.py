"""What a path file is: its text before reading, the path after."""

from __future__ import annotations

from dataclasses import dataclass

from planners.map import Map
from planners.path import Path


@dataclass(frozen=True, slots=True)
class Source:
    """The `text` of a file, lines ended by line feeds, its `place` for errors and the `name` for its path."""

    text: str
    place: str
    name: str


@dataclass(frozen=True, slots=True)
class PathFile:
    """A path with what else its file says.

    `notes` has one line for each item that was skipped or read in another sense, without the file's name, for
    standard error. `fence` is the file's geofence, in the frame of the path. `speed` [m/s] is the one that
    the mission sets by DO_CHANGE_SPEED before its first leg, over the ground or through the air as the item
    says; the `cruiseSpeed` and `hoverSpeed` of a QGroundControl plan only serve its time estimates and are
    not taken.
    """

    path: Path
    notes: tuple[str, ...] = ()
    fence: Map | None = None
    speed: float | None = None
