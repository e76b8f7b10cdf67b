"""What the vehicle really did: a time series with named columns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planners.frame import Frame
from planners.kernel import Floats

# Columns of every track, in order; the vehicle's own channels follow. SI units, angles in radians.
STATE_COLUMNS = (
    "t", "x", "y", "z", "heading", "course", "ground_speed", "airspeed", "climb_rate", "curvature", "saturated",
)  # fmt: skip
GUIDANCE_COLUMNS = (
    "s", "cross_track", "path_heading", "curvature_command", "speed_command", "altitude_command",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Track:
    """Samples of a run, one row each control period: `data` (N, M) with a name for every column.

    `cross_track`, `s` and `path_heading` are those of the true position's projection on the path. `ended` says why the
    run ended: "completed", "time budget spent", "corridor lost for good", "stall", "ground" or "not a number".
    """

    columns: tuple[str, ...]
    data: Floats
    ended: str
    frame: Frame | None = None

    def __getitem__(self, column: str) -> Floats:
        """The column of that name, (N,)."""
        values: Floats = self.data[:, self.columns.index(column)]
        return values

    def __contains__(self, column: str) -> bool:
        return column in self.columns

    def __len__(self) -> int:
        return len(self.data)

    @property
    def distance(self) -> Floats:
        """Distance flown over the ground at each sample (N,) [m]."""
        steps = np.hypot(np.diff(self["x"]), np.diff(self["y"]))
        return np.concatenate([[0.0], np.cumsum(steps)])
