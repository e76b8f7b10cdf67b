"""A scenario's map with many cases on it: planned paths by source, tracks, and where most of the trials were."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import matplotlib.patheffects as effects
import numpy as np
import shapely
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from shapely import LineString, Polygon, box

from campaigns.statistics import Band
from planners.kernel import Bools, Floats
from planners.path import Path
from reports.figures.decimate import polyline
from reports.figures.extent import Extent
from reports.figures.legend import mark_look
from reports.figures.obstacle_panel import draw_obstacles
from reports.figures.scenario_cases import Run
from reports.figures.shapes import fill, stroke
from reports.figures.style import (
    BLUE,
    DASHES,
    FENCE,
    FENCE_DASHES,
    GREEN,
    GROUND_COLOUR,
    INK,
    MUTED,
    OBSTACLE_EDGE,
    ORANGE,
    PAPER,
    PURPLE,
    SKY,
    VERMILION,
    Look,
)
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Told apart by dash and lightness too, in grey and by every kind of colour vision; vermilion is for alarms.
LOOKS: tuple[Look, ...] = (
    {"color": BLUE, "linestyle": "-"},
    {"color": ORANGE, "linestyle": (0, (5, 1.6))},
    {"color": GREEN, "linestyle": (0, (6, 1.5, 1, 1.5))},
    {"color": PURPLE, "linestyle": (0, (1.5, 1.2))},
    {"color": SKY, "linestyle": (0, (4, 1.2, 1, 1.2, 1, 1.2))},
)
PLAIN: Look = {"color": INK, "linestyle": DASHES}  # of the one path there is
OTHERS: Look = {"color": OBSTACLE_EDGE, "linestyle": "-", "alpha": 0.7}
_PLANNED, _DRIVEN = 1.5, 0.7  # [pt] of a planned path, and of a track beside it
_FINE, _MOST_POINTS = 0.25, 1500  # pixels that a line may be simplified by; points of a track
_BAND_STEPS = 800  # along a path
_FARTHEST = 4.0  # half-widths of the corridor
_START: Look = mark_look("start", "o", 6.0, INK, PAPER)
_GOAL: Look = mark_look("goal", "s", 6.0, INK, PAPER)


def looks_of(names: Iterable[str]) -> dict[str, Look]:
    """A look for each of `names`; those beyond the colours there are look alike."""
    return {name: LOOKS[i] if i < len(LOOKS) else OTHERS for i, name in enumerate(names)}


def members_of(outcome: Outcome) -> tuple[Outcome, ...]:
    """The vehicles of a fleet, or the one that is alone."""
    return outcome.fleet.members if outcome.fleet else (outcome,)


def draw_ground(axes: Axes, outcome: Outcome, view: Extent) -> None:
    """Draw what of the world of `outcome` is in `view` on `axes`, whose box must have the view's aspect."""
    axes.set(xlim=(view.x_min, view.x_max), ylim=(view.y_min, view.y_max), facecolor=GROUND_COLOUR)
    axes.set_aspect("equal", adjustable="box")
    axes.spines[:].set_visible(True)
    if outcome.obstacles is not None:
        draw_obstacles(axes, outcome.obstacles, _window(view))


def draw_planned(axes: Axes, paths: Iterable[Path], view: Extent, look: Look, width: float = _PLANNED) -> None:
    """Draw `paths`, each that is the same as another once, and their starts and goals."""
    pixel = view.width / axes.bbox.width
    shown = {path.xy.tobytes(): path for path in paths}
    for path in shown.values():
        line = LineString(path.xy).simplify(_FINE * pixel).intersection(_window(view))
        edged = [effects.Stroke(linewidth=width + 1.2, foreground=PAPER, alpha=0.8), effects.Normal()]
        stroke(axes, line, {"linewidth": width, "zorder": 3.5, "path_effects": edged, **look})
    for path in shown.values():
        for end, mark in ((0, _START), (-1, _GOAL)):
            if view.holds(path.xy[[end]]).all():
                axes.plot(*path.xy[end], **{**mark, "zorder": 7})


def draw_driven(axes: Axes, outcome: Outcome, view: Extent, colour: str, width: float = _DRIVEN) -> None:
    """Draw the tracks of `outcome` in `colour`, and in vermilion where they are beyond the corridor."""
    for line, beyond in _tracks(outcome, view, view.width / axes.bbox.width):
        out = beyond[:-1] | beyond[1:]
        starts = np.concatenate([[0], np.flatnonzero(np.diff(out)) + 1])
        pieces = [line[i : j + 1] for i, j in zip(starts, [*starts[1:], len(out)], strict=True)]
        look: Look = {"linewidths": width, "capstyle": "round", "zorder": 3.6}
        colours = [VERMILION if out[start] else colour for start in starts]
        axes.add_collection(LineCollection(pieces, colors=colours, **look), autolim=False)


def draw_told_apart(axes: Axes, outcome: Outcome, view: Extent, look: Look) -> None:
    """Draw the tracks of `outcome` in a `look` that tells them from others, wherever they are."""
    for line, _ in _tracks(outcome, view, view.width / axes.bbox.width):
        axes.plot(*line.T, linewidth=1.1, zorder=3.6, **look)


def _tracks(outcome: Outcome, view: Extent, pixel: float) -> Iterator[tuple[Floats, Bools]]:
    """Of every vehicle what of its track (N, 2) [m] is about `view`, and where (N,) it is beyond the corridor."""
    reach = view.grown(0.5 * view.larger)
    for member in members_of(outcome):
        xy = np.column_stack([member.track["x"], member.track["y"]])
        good = np.isfinite(xy).all(axis=1)
        xy, beyond = xy[good], (np.abs(member.track["cross_track"]) > member.corridor)[good]
        near = np.flatnonzero(reach.holds(xy))
        if len(near) > 1:
            within = slice(near[0], near[-1] + 1)  # what lies between stays, so that the line is whole
            kept = polyline(xy[within], _FINE * pixel, _MOST_POINTS)
            yield xy[within][kept], beyond[within][kept]


def draw_band(axes: Axes, run: Run, outcome: Outcome, view: Extent, colour: str) -> bool:
    """Fill the places where 90 % of the trials are; was there any?

    They are left out where they are thinner than a pixel, and where they reach farther from the path than `_FARTHEST`
    corridors: there the vehicle is lost, and its distance from the path no longer says where it is.
    """
    band, pixel = run.result.statistics.band, view.width / axes.bbox.width
    if band is None or run.result.case.replan or outcome.fleet is not None:  # along which path would it be?
        return False
    low, high, wide = band_lines(outcome.path, band, pixel, _FARTHEST * outcome.corridor)
    corners = np.stack([low[:-1], low[1:], high[1:], high[:-1]], axis=1)[wide[:-1] & wide[1:]]
    # Where a bend folds the offset back on itself a quad crosses itself
    area = shapely.union_all(shapely.convex_hull(shapely.polygons(corners))).intersection(_window(view))
    fill(axes, area.simplify(_FINE * pixel), {"facecolor": colour, "alpha": 0.35, "edgecolor": "none", "zorder": 2.7})
    return bool(wide.any())


def band_lines(path: Path, band: Band, thinnest: float, farthest: float) -> tuple[Floats, Floats, Bools]:
    """The path (N, 2) [m] offset by the 5th and by the 95th percentile of the trials' errors, left positive; and where
    (N,) these are at least `thinnest` [m] apart, and at most `farthest` [m] from the path.
    """
    fine = path.resample(path.length / _BAND_STEPS)
    middles = (np.arange(len(band.p5)) + 0.5) * path.length / len(band.p5)
    low, high = (np.interp(fine.s, middles, edge) for edge in (band.p5, band.p95))
    shown = (high - low >= thinnest) & (np.maximum(np.abs(low), np.abs(high)) <= farthest)
    step = np.gradient(fine.xy, axis=0)
    left = np.column_stack([-step[:, 1], step[:, 0]]) / np.maximum(np.hypot(*step.T), 1e-12)[:, None]
    return fine.xy + low[:, None] * left, fine.xy + high[:, None] * left, shown


def ground_marks(outcomes: Sequence[Outcome]) -> list[Line2D]:
    """What the marks of the ground mean, for a legend."""
    looks: list[Look] = [_START, _GOAL]
    areas = [outcome.obstacles for outcome in outcomes if outcome.obstacles is not None]
    if any(area.keep_in or area.keep_in_circles for area in areas):
        looks.append({"label": "fence", "color": FENCE, "linewidth": 1.4, "linestyle": FENCE_DASHES})
    if any(area.bounds is not None for area in areas):
        looks.append({"label": "map edge", "color": MUTED, "linewidth": 1.2})
    return [Line2D([], [], **look) for look in looks]


def driven_marks(driven: str, banded: bool) -> list[Line2D | Patch]:
    """What the looks of tracks and bands mean, `driven` or flown, for a legend."""
    entries: list[Line2D | Patch] = [
        Line2D([], [], color=INK, linewidth=_DRIVEN, label=f"{driven}, worst trial"),
        Line2D([], [], color=VERMILION, linewidth=_DRIVEN + 0.4, label="beyond the corridor"),
    ]
    return entries + ([Patch(facecolor=MUTED, alpha=0.4, label="90 % of the trials")] if banded else [])


def _window(view: Extent) -> Polygon:
    return box(view.x_min, view.y_min, view.x_max, view.y_max)
