"""The map of one run: what is forbidden, what was planned, and what was flown, coloured by its error."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import matplotlib.patheffects as effects
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from shapely import LineString, Polygon, box

from planners.kernel import Floats
from planners.path import Path
from reports.figures.decimate import polyline
from reports.figures.extent import Extent
from reports.figures.focus import Focus
from reports.figures.obstacle_panel import draw_obstacles
from reports.figures.shapes import fill, stroke
from reports.figures.style import (
    CORRIDOR,
    DASHES,
    GROUND_COLOUR,
    INK,
    MARK,
    PAPER,
    ROUND_TICKS,
    TIGHT,
    Look,
    error_colours,
)
from tracking.feasibility import Stretch
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_THINNEST_CORRIDOR = 3.0  # pixels; a narrower one is hidden under the track anyway
_MOST_POINTS = 1500  # of a coloured track
_SHADES = 24  # steps of colour up to the corridor; neighbours in the same step are one line
_SMALL, _LEAST = 0.4, 0.01  # corridors: errors below the first have colours of their own, down to the second
_FINE = 0.25  # pixels that a line may be simplified by


def draw_map(axes: Axes, outcome: Outcome, view: Extent, marked: Focus | None) -> None:
    """Draw the part of the world in `view` on `axes`, whose box must have the view's aspect."""
    axes.set(xlim=(view.x_min, view.x_max), ylim=(view.y_min, view.y_max), facecolor=GROUND_COLOUR)
    axes.set_aspect("equal", adjustable="box")
    axes.spines[:].set_visible(True)
    pixel = view.width / axes.bbox.width
    window = box(view.x_min, view.y_min, view.x_max, view.y_max)
    line = LineString(outcome.path.xy).simplify(_FINE * pixel)
    _corridor(axes, outcome, line, window, pixel)
    if outcome.obstacles is not None:
        draw_obstacles(axes, outcome.obstacles, window)
    _tight(axes, outcome, window)
    stroke(axes, line.intersection(window), {"color": INK, "linewidth": 1.0, "linestyle": DASHES, "zorder": 2.9})
    _flown(axes, outcome, view, pixel)
    _marks(axes, outcome, view, marked)


def colour_top(outcome: Outcome) -> float:
    """The distance from the path [m] at which the colours of a track end: the corridor, beyond which it is vermilion,
    or a round distance that holds them all where they are far smaller.
    """
    error = np.abs(outcome.track["cross_track"])
    largest = float(np.max(error[np.isfinite(error)], initial=0.0))
    if largest > _SMALL * outcome.corridor:
        return outcome.corridor
    decade = 10.0 ** math.floor(math.log10(max(largest, _LEAST * outcome.corridor)))
    return min(outcome.corridor, next(step * decade for step in ROUND_TICKS if step * decade >= largest))


def _corridor(axes: Axes, outcome: Outcome, line: LineString, window: Polygon, pixel: float) -> None:
    if 2.0 * outcome.corridor < _THINNEST_CORRIDOR * pixel:
        return
    inside = line.buffer(outcome.corridor, quad_segs=12).intersection(window)
    fill(axes, inside, {"facecolor": CORRIDOR, "alpha": 0.25, "edgecolor": "none", "zorder": 1.0})
    fill(axes, inside, {"facecolor": "none", "edgecolor": CORRIDOR, "linewidth": 0.6, "zorder": 1.1})


def _tight(axes: Axes, outcome: Outcome, window: Polygon) -> None:
    """The stretches of the path that are too tight, broad enough to be seen on both sides of the flown line."""
    look: Look = {"color": TIGHT, "linewidth": 7.0, "alpha": 0.9, "solid_capstyle": "butt", "zorder": 2.8}
    for stretch in outcome.feasibility.stretches:
        if stretch.s_end > stretch.s:
            stroke(axes, _piece(outcome.path, stretch).intersection(window), look)


def _piece(path: Path, stretch: Stretch) -> LineString:
    within = (path.s > stretch.s) & (path.s < stretch.s_end)
    return LineString([path.point_at(stretch.s), *path.xy[within], path.point_at(stretch.s_end)])


def _flown(axes: Axes, outcome: Outcome, view: Extent, pixel: float) -> None:
    xy = np.column_stack([outcome.track["x"], outcome.track["y"]])
    error = np.abs(outcome.track["cross_track"])
    good = np.isfinite(xy).all(axis=1)
    xy, error = xy[good], error[good]
    near = np.flatnonzero(view.grown(0.5 * view.larger).holds(xy))
    if len(near):  # what lies between stays, so that the line is whole
        xy, error = xy[near[0] : near[-1] + 1], error[near[0] : near[-1] + 1]
    if len(xy) < 2:
        axes.plot(xy[:, 0], xy[:, 1], "o", color=INK, markersize=4, zorder=4)
        return
    kept = polyline(xy, _FINE * pixel, _MOST_POINTS)
    share = np.fmax.reduceat(error, kept[:-1]) / colour_top(outcome)
    pieces, shares = _alike(xy[kept], np.ceil(share * _SHADES) / _SHADES)
    axes.plot(xy[kept, 0], xy[kept, 1], color=INK, linewidth=2.9, zorder=3.0)
    look: Look = {"linewidths": 2.0, "capstyle": "round", "norm": Normalize(0.0, 1.0), "cmap": error_colours()}
    axes.add_collection(LineCollection(pieces, array=shares, zorder=3.1, **look))


def _alike(xy: Floats, shares: Floats) -> tuple[list[Floats], Floats]:
    """The line (N, 2) in pieces whose segments have the same of the `shares` (N - 1,), and each one's share."""
    starts = np.concatenate([[0], np.flatnonzero(shares[1:] != shares[:-1]) + 1])
    ends = np.append(starts[1:], len(shares)) + 1
    return [xy[i:j] for i, j in zip(starts, ends, strict=True)], shares[starts]


def _marks(axes: Axes, outcome: Outcome, view: Extent, marked: Focus | None) -> None:
    path = outcome.path
    _mark(axes, view, path.points[0, :2], {"marker": "o", "markersize": 6.5}, INK, PAPER)
    _mark(axes, view, path.points[-1, :2], {"marker": "s", "markersize": 6.5}, INK, PAPER)
    for stretch in outcome.feasibility.stretches:
        worst = np.array([stretch.worst.x, stretch.worst.y])
        _mark(axes, view, worst, {"marker": "v", "markersize": 7.0}, TIGHT, INK)
    if marked is not None:
        ring: Look = {
            "marker": "o", "markersize": 12.0, "markeredgewidth": 1.8, "zorder": 8,
            "path_effects": [effects.Stroke(linewidth=3.6, foreground=PAPER), effects.Normal()],
        }  # fmt: skip
        _mark(axes, view, np.array([marked.x, marked.y]), ring, "none", MARK[marked.alarm])


def _mark(axes: Axes, view: Extent, at: Floats, look: Look, face: str, edge: str) -> None:
    if view.holds(at[None, :]).all():
        common: Look = {"linestyle": "none", "markeredgewidth": 0.8, "zorder": 7}
        axes.plot(at[0], at[1], markerfacecolor=face, markeredgecolor=edge, **{**common, **look})
