"""The map of a fleet: every planned path and flown track in the colour of its vehicle, and where two came closest."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, islice
from typing import TYPE_CHECKING

import matplotlib.patheffects as effects
import numpy as np
from matplotlib.lines import Line2D
from shapely import box

from planners.kernel import Floats
from reports.figures.extent import Extent, flown
from reports.figures.focus import Focus
from reports.figures.legend import mark_look
from reports.figures.obstacle_panel import draw_obstacles
from reports.figures.style import DASHES, FENCE, FENCE_DASHES, GROUND_COLOUR, INK, MARK, MEMBERS, MUTED, PAPER, Look
from tracking.outcome import Fleet, Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_START, _TARGET = ("D", 6.0), ("*", 11.0)  # as paper 001 draws them
_FLOWN: Look = {"linewidth": 3.2, "alpha": 0.6, "zorder": 3.0}
_PLANNED: Look = {"color": INK, "linewidth": 0.8, "linestyle": DASHES, "zorder": 3.2}
_CLOSEST: Look = {
    "color": INK, "linewidth": 1.0, "marker": "o", "markersize": 6.0, "markerfacecolor": PAPER, "markeredgecolor": INK,
    "markeredgewidth": 1.2, "zorder": 7.5,
}  # fmt: skip
FREE_START: Look = mark_look("start", *_START, MUTED, INK)  # of no vehicle
FREE_TARGET: Look = mark_look("target", *_TARGET, MUTED, INK)
_ASIDE = 9.0  # [pt] from a start to its number


def member_colours(count: int) -> list[str]:
    """A colour for each of `count` vehicles."""
    return list(islice(cycle(MEMBERS), count))


def draw_fleet(
    axes: Axes, outcome: Outcome, fleet: Fleet, colours: Sequence[str], view: Extent, marked: Focus | None
) -> None:
    """Draw the part of the world in `view` on `axes`, whose box must have the view's aspect."""
    axes.set(xlim=(view.x_min, view.x_max), ylim=(view.y_min, view.y_max), facecolor=GROUND_COLOUR)
    axes.set_aspect("equal", adjustable="box")
    axes.spines[:].set_visible(True)
    if outcome.obstacles is not None:
        draw_obstacles(axes, outcome.obstacles, box(view.x_min, view.y_min, view.x_max, view.y_max))
    for member, colour in zip(fleet.members, colours, strict=True):
        axes.plot(*flown(member).T, color=colour, **_FLOWN)
        axes.plot(*member.path.xy.T, **_PLANNED)
    for i, (member, colour) in enumerate(zip(fleet.members, colours, strict=True), start=1):
        draw_ends(axes, member.path.xy, str(i), colour)
    if (places := closest_places(outcome, fleet)) is not None:
        axes.plot(*places.T, **_CLOSEST)
    if marked is not None:
        look: Look = {**mark_look("", "o", 12.0, "none", MARK[marked.alarm]), "markeredgewidth": 1.8, "zorder": 8}
        axes.plot(marked.x, marked.y, **look)


def draw_ends(axes: Axes, xy: Floats, number: str, colour: str) -> None:
    """A diamond where the path (N, 2) starts, with the vehicle's `number` behind it, and a star where it ends."""
    for (shape, size), place in ((_START, xy[0]), (_TARGET, xy[-1])):
        axes.plot(*place, **{**mark_look("", shape, size, colour, INK), "zorder": 7})
    ahead = xy[1] - xy[0]
    back = -_ASIDE * ahead / max(float(np.hypot(*ahead)), 1e-9)
    axes.annotate(
        number, tuple(xy[0]), xytext=tuple(back), textcoords="offset points", ha="center", va="center", fontsize=8.5,
        fontweight="bold", color=INK, zorder=9, annotation_clip=False,
        path_effects=[effects.Stroke(linewidth=2.2, foreground=PAPER), effects.Normal()],
    )  # fmt: skip


def closest_places(outcome: Outcome, fleet: Fleet) -> Floats | None:
    """Where both vehicles were (2, 2) [m] when two of the fleet were closest; None where never two were under way."""
    nearest = outcome.metrics["separation_min"]
    if not nearest.who:
        return None
    pair = [int(number) - 1 for number in nearest.who.split(" and ")]
    places = []
    for i in pair:
        track = fleet.members[i].track
        places.append([np.interp(nearest.t - fleet.departures[i], track["t"], track[axis]) for axis in ("x", "y")])
    return np.array(places)


def fleet_entries(outcome: Outcome, fleet: Fleet, marked: Focus | None) -> list[Line2D]:
    """What the marks of the map mean, for a legend."""
    driven = "driven" if outcome.limits.kind == "ground" else "flown"
    looks: list[Look] = [
        {**_PLANNED, "label": "planned"},
        {**_FLOWN, "color": MUTED, "label": driven},
    ]
    entries = [Line2D([], [], **look) for look in looks] + end_entries()
    looks = []
    if closest_places(outcome, fleet) is not None:
        looks.append({**_CLOSEST, "label": "closest approach"})
    if marked is not None:
        ring = mark_look(marked.title.lower(), "o", 8.0, "none", MARK[marked.alarm])
        looks.append({**ring, "markeredgewidth": 1.6})
    area = outcome.obstacles
    if area is not None and (area.keep_in or area.keep_in_circles):
        looks.append({"label": "fence", "color": FENCE, "linewidth": 1.4, "linestyle": FENCE_DASHES})
    return entries + [Line2D([], [], **look) for look in looks]


def end_entries() -> list[Line2D]:
    """What diamonds and stars mean, for a legend."""
    return [Line2D([], [], **look) for look in (FREE_START, FREE_TARGET)]
