"""Where a plan asks too much of a ground vehicle: the stretches that need more lateral acceleration than its limit."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import matplotlib.patheffects as effects
import numpy as np
from matplotlib.lines import Line2D

from planners.astar.heading_limits import LATERAL
from planners.kernel import Floats
from planners.needed import lateral_acceleration_needed
from planners.path import Path
from planners.planner import Plan
from planners.units import STANDARD_GRAVITY
from reports.figures.legend import mark_look
from reports.figures.style import MARK, PAPER, PASS_BADGE, VERMILION
from reports.words.quantity import number
from reports.words.words import KMH

if TYPE_CHECKING:
    from matplotlib.axes import Axes

WITHIN = PASS_BADGE  # the colour of a plan that is shown with its stretches beyond the limit
_TOLERANCE = 1.005  # of the limit: chords of an arc at the limit are that much shorter than the arc
_ASIDE = 9.0  # [pt] of what is said, from its place
_PLACES = 2000  # along a path, finer than the pixels of a map


def draw_beyond(axes: Axes, plan: Plan, speed: float) -> None:
    """Draw over the paths of `plan` what is beyond the limit at `speed` [m/s]."""
    for path in plan.paths:
        for piece in stretches_beyond(path, speed):
            axes.plot(*piece.T, color=VERMILION, linewidth=2.8, solid_capstyle="butt", zorder=4.3)


def ring_worst(axes: Axes, plan: Plan, speed: float) -> None:
    """Ring the place that needs the most; none where the path is straight."""
    path, s, needed = worst_place(plan, speed)
    if needed != 0.0:
        ring = {**mark_look("", "o", 10.0, "none", MARK[beyond(needed)]), "markeredgewidth": 1.6, "zorder": 7.5}
        axes.plot(*path.point_at(s), **ring)


def draw_worst(axes: Axes, plan: Plan, speed: float) -> None:
    """Ring the place that needs the most, and say how much in g on the outside of its bend."""
    path, s, needed = worst_place(plan, speed)
    if needed == 0.0:
        return
    ring_worst(axes, plan, speed)
    x, y = path.point_at(s)
    colour, outward = MARK[beyond(needed)], path.heading_at(s) - math.copysign(math.pi / 2, needed)
    across, up = math.cos(outward), math.sin(outward)
    axes.annotate(
        f"{number(abs(needed))} g", (x, y), xytext=(_ASIDE * across, _ASIDE * up), textcoords="offset points",
        ha="left" if across > 0.0 else "right", va="bottom" if up > 0.0 else "top", color=colour, fontweight="bold",
        zorder=8, path_effects=[effects.Stroke(linewidth=2.5, foreground=PAPER), effects.Normal()],
    )  # fmt: skip


def needed_entries(plans: Iterable[Plan], speed: float) -> list[Line2D]:
    """What the colours and rings mean, for a legend; nothing where there is no path."""
    worst = [abs(worst_place(plan, speed)[2]) for plan in plans if plan.paths]
    if not worst:
        return []
    return entries_up_to(max(worst), f"at {number(KMH * speed)} km/h")


def entries_up_to(most: float, when: str) -> list[Line2D]:
    """The same of paths that need at `most` so much [g] `when` they are driven."""
    limit = f"needs up to {number(LATERAL)} g of lateral acceleration {when}"
    entries = [Line2D([], [], color=WITHIN, linewidth=1.8, label=limit)]
    if beyond(most):
        entries.append(Line2D([], [], color=VERMILION, linewidth=2.8, label="needs more"))
    if most > 0.0:
        look = mark_look("needs most", "o", 8.0, "none", MARK[beyond(most)])
        entries.append(Line2D([], [], **{**look, "markeredgewidth": 1.6}))
    return entries


def stretches_beyond(path: Path, speed: float) -> list[Floats]:
    """The stretches, each (N, 2) [m], that need more than the limit at `speed` [m/s]."""
    s, needed = lateral_acceleration_needed(path, speed)
    fine = np.unique(np.concatenate([np.linspace(0.0, path.length, _PLACES), s, path.s]))
    beyond = np.abs(np.interp((fine[1:] + fine[:-1]) / 2, s, needed)) > _TOLERANCE * LATERAL * STANDARD_GRAVITY
    change = np.flatnonzero(np.diff(np.concatenate([[False], beyond, [False]])))
    line = np.column_stack([np.interp(fine, path.s, column) for column in path.xy.T])
    return [line[start : end + 1] for start, end in zip(change[::2], change[1::2], strict=True)]


def worst_place(plan: Plan, speed: float) -> tuple[Path, float, float]:
    """The path of `plan` and the arc length [m] on it that need the most at `speed` [m/s], and how much [g]."""
    found = []
    for path in plan.paths:
        s, needed = lateral_acceleration_needed(path, speed)
        most = int(np.argmax(np.abs(needed)))
        found.append((path, float(s[most]), float(needed[most]) / STANDARD_GRAVITY))
    return max(found, key=lambda place: abs(place[2]))


def beyond(needed: float) -> bool:
    """Whether a path that needs so much [g] needs more than the limit."""
    return abs(needed) > _TOLERANCE * LATERAL
