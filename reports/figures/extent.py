"""How much of the world a map shows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from planners.footprint import Disc
from planners.kernel import Floats
from reports.figures.focus import Focus
from tracking.outcome import Outcome

_MARGIN = 0.06  # of the larger side, around everything
_STRAY = 0.6  # of the path's larger side: how far the picture follows a vehicle that left the path
_FRAMED = 0.4  # a map's bounds are shown where the path spans this share of them


@dataclass(frozen=True, slots=True)
class Extent:
    """A rectangle of the local frame [m]."""

    x_min: float
    y_min: float
    x_max: float
    y_max: float

    @property
    def width(self) -> float:
        """East to west [m]."""
        return self.x_max - self.x_min

    @property
    def height(self) -> float:
        """South to north [m]."""
        return self.y_max - self.y_min

    @property
    def larger(self) -> float:
        """The larger side [m]."""
        return max(self.width, self.height)

    def grown(self, by: float) -> Extent:
        """Larger by `by` [m] on every side."""
        return Extent(self.x_min - by, self.y_min - by, self.x_max + by, self.y_max + by)

    def filled(self, aspect: float) -> Extent:
        """Grown on two sides about its middle until width / height is `aspect`."""
        width, height = max(self.width, self.height * aspect), max(self.height, self.width / aspect)
        x, y = (self.x_min + self.x_max) / 2, (self.y_min + self.y_max) / 2
        return Extent(x - width / 2, y - height / 2, x + width / 2, y + height / 2)

    def holds(self, xy: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
        """Which of the points (N, 2) lie inside, (N,)."""
        inside: np.ndarray[tuple[int], np.dtype[np.bool_]] = (
            (xy[:, 0] >= self.x_min) & (xy[:, 0] <= self.x_max) & (xy[:, 1] >= self.y_min) & (xy[:, 1] <= self.y_max)
        )
        return inside


def flown(outcome: Outcome) -> Floats:
    """The finite positions of the track (N, 2) [m]."""
    xy = np.column_stack([outcome.track["x"], outcome.track["y"]])
    return xy[np.isfinite(xy).all(axis=1)]


def whole(outcome: Outcome) -> Extent:
    """All of the path, the track as far as it does not stray absurdly, and the map's edge if the path fills it."""
    path = _bounding(outcome.path.xy)
    reach = path.grown(_STRAY * path.larger)
    track = flown(outcome)
    shown = _bounding(np.concatenate([outcome.path.xy, track[reach.holds(track)]]))
    bounds = outcome.obstacles.bounds if outcome.obstacles else None
    if bounds is not None and path.larger >= _FRAMED * max(bounds[2] - bounds[0], bounds[3] - bounds[1]):
        corners = np.array([[shown.x_min, shown.y_min], [shown.x_max, shown.y_max], bounds[:2], bounds[2:]])
        shown = _bounding(corners)
    return shown.grown(max(_MARGIN * shown.larger, 1.5 * min(outcome.corridor, 0.1 * shown.larger)))


def whole_fleet(outcomes: Sequence[Outcome]) -> Extent:
    """All that `whole` shows of each of `outcomes`."""
    views = [whole(outcome) for outcome in outcomes]
    return _bounding(np.array([corner for one in views for corner in ((one.x_min, one.y_min), (one.x_max, one.y_max))]))


def _bounding(xy: Floats) -> Extent:
    (x_min, y_min), (x_max, y_max) = xy.min(axis=0), xy.max(axis=0)
    return Extent(float(x_min), float(y_min), float(x_max), float(y_max))


def around(outcome: Outcome, marked: Focus, view: Extent) -> Extent:
    """What to show of the surroundings of `marked`: the corridor, and the way back to the path."""
    if marked.index is not None:
        error = abs(float(outcome.track["cross_track"][marked.index]))
    else:  # the path was not reached there: how near the vehicle came
        error = float(np.min(np.hypot(*(flown(outcome) - [marked.x, marked.y]).T), initial=view.larger))
    body = outcome.limits.footprint
    body_size = 2.0 * body.radius if isinstance(body, Disc) else body.length
    wanted = float(np.nanmax([4.0 * outcome.corridor, 1.8 * error, 1.1 * body_size]))
    half = min(wanted, 0.4 * view.larger)
    return Extent(marked.x, marked.y, marked.x, marked.y).grown(half)
