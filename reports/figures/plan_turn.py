"""The sharpest turn of a plan from near: the polyline of the search against the curve that replaces it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
import shapely
from matplotlib.lines import Line2D

from planners.kernel import Floats
from planners.path import Path
from planners.planner import Plan
from planners.scenario import Scenario
from reports.figures.extent import Extent
from reports.figures.fitted import fit, shortened
from reports.figures.plan_map import draw_ground
from reports.figures.style import DASHES, INK, PAPER, VERMILION, Look
from reports.figures.ticks import ticks_from
from reports.words.quantity import number, text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_STEPS = 2000  # in which a path is searched for its turns
_WINDOW = 21  # steps over which a bend is taken, so that the corners of a sampled curve are one turn
_STRAIGHT = 0.05  # a stretch that bends less than this share of the sharpest bend is between two turns
_SHARP = 0.8  # turns that bend at least by this share of it are as sharp
_CUT = 12.0  # how many times what the curve cuts off the corner the view reaches, within these shares of the map
_NEAREST, _FARTHEST = 0.008, 0.04
_ENDED: Look = {
    "marker": "X", "markersize": 9.0, "linestyle": "none", "color": VERMILION, "markeredgecolor": PAPER,
    "markeredgewidth": 0.8, "zorder": 7.5,
}  # fmt: skip
_LABEL_PAD, _TITLE_PAD = 4.5, 16.0  # [pt] above the box
_NAMED, _ASIDE, _SMALLEST = 60, 0.1, 7.0  # characters of a name, [in] a title may be wider than its box, its type [pt]


def sharpest(plan: Plan) -> tuple[Floats, float]:
    """The middle (2,) [m] of the sharpest turn of all paths, and its angle [rad].

    Of a path with corners that is a corner, of one with curves the curve that goes farthest round among the sharpest.
    """
    return max((_sharpest(path, plan.smallest_radius is None) for path in plan.paths), key=lambda found: found[1])


def _sharpest(path: Path, cornered: bool) -> tuple[Floats, float]:
    if cornered:
        corner = int(np.argmax(np.abs(path.turns)))
        return path.xy[corner], abs(float(path.turns[corner]))
    fine = path.resample(path.length / _STEPS)
    bends = np.convolve(fine.turns, np.ones(_WINDOW), "same")
    sharp = float(np.abs(bends).max())
    side = np.sign(bends) * (np.abs(bends) > _STRAIGHT * sharp)
    starts = np.concatenate([[0], np.flatnonzero(np.diff(side)) + 1])
    angles = np.abs(np.add.reduceat(fine.turns, starts))
    peaks = np.maximum.reduceat(np.abs(bends), starts)
    chosen = int(np.argmax(np.where(peaks >= _SHARP * sharp, angles, -1.0)))
    end = starts[chosen + 1] if chosen + 1 < len(starts) else len(bends)
    return fine.xy[(starts[chosen] + end) // 2], float(angles[chosen])


def turn_view(scenario: Scenario, plan: Plan) -> Extent:
    """What to show of the sharpest turn of all paths: so much that the corner it cuts can be seen."""
    larger = max(scenario.size)
    place, _ = sharpest(plan)
    cut = 0.0
    if plan.polylines:
        xy = np.vstack([path.xy for path in plan.paths])
        near = xy[np.hypot(*(xy - place).T) <= _FARTHEST * larger]
        lines = shapely.MultiLineString([polyline.xy for polyline in plan.polylines])
        cut = float(shapely.distance(shapely.points(near), lines).max(initial=0.0))
    half = min(max(_CUT * cut, _NEAREST * larger), _FARTHEST * larger)
    return Extent(*place, *place).grown(half)


def draw_turn(axes: Axes, scenario: Scenario, plan: Plan, exact: Sequence[Path], name: str, colour: str) -> None:
    """Draw it on `axes` in metres from it; the title has `name`."""
    width, height = axes.get_window_extent().size
    view = turn_view(scenario, plan).filled(width / height)
    draw_ground(axes, scenario, view)
    draw_exact(axes, exact)
    draw_lines(axes, plan, colour, corners=True)
    place, angle = sharpest(plan)
    radius = plan.smallest_radius
    angled = number(math.degrees(angle))
    told = f"{angled}° at the corner" if radius is None else f"{angled}° in all, smallest radius {text(radius, 'm')}"
    what = "sharpest turn" if radius is None else "tightest curve"
    title = axes.set_title(f"{shortened(name, _NAMED)}: {what}", pad=_TITLE_PAD)
    fit(title, width + _ASIDE * axes.figure.dpi, _SMALLEST)
    axes.annotate(
        told if angle else "it is straight", (0.0, 1.0), xycoords="axes fraction", xytext=(0.0, _LABEL_PAD),
        textcoords="offset points", va="bottom",
    )  # fmt: skip
    ticks_from(axes, *place)


def draw_exact(axes: Axes, exact: Sequence[Path]) -> None:
    """The exact shortest paths as the yardstick."""
    for path in exact:
        axes.plot(*path.xy.T, color=INK, linewidth=0.7, zorder=4.0)


def draw_lines(axes: Axes, plan: Plan, colour: str, corners: bool = False) -> None:
    """The plan's paths, and the polylines before smoothing with their `corners`."""
    for polyline in plan.polylines:
        dots: Look = {"marker": "o", "markersize": 3.5} if corners else {}
        axes.plot(*polyline.xy.T, color=colour, linewidth=0.9, linestyle=DASHES, zorder=4.2, **dots)
    for path in plan.paths:
        axes.plot(*path.xy.T, color=colour, linewidth=1.8, zorder=4.1)


def draw_came(axes: Axes, plan: Plan, colour: str) -> None:
    """How far a search without a path came, with a cross where it ended."""
    for path in came(plan):
        axes.plot(*path.xy.T, color=colour, linewidth=1.4, linestyle=DASHES, zorder=4.2)
        axes.plot(*path.xy[-1], **_ENDED)


def came(plan: Plan) -> tuple[Path, ...]:
    """The ways on which a search without a path came to its end; none where they are not known."""
    return plan.stages[-1].paths if plan.stages and not plan.paths else ()


def came_entries(plans: Iterable[Plan], colour: str) -> list[Line2D]:
    """What the marks of `draw_came` mean, for a legend; nothing where there are none."""
    if not any(came(plan) for plan in plans):
        return []
    way = Line2D([], [], color=colour, linewidth=1.4, linestyle=DASHES, label="as far as it came")
    return [way, Line2D([], [], **_ENDED, label="no way on")]
