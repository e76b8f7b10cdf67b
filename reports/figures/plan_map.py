"""The map under a plan: obstacles, start and goal, drawn to scale."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import cycle
from typing import TYPE_CHECKING

from matplotlib.lines import Line2D
from shapely import box

from planners.path import Path
from planners.scenario import Scenario
from reports.figures.extent import Extent
from reports.figures.layout import Box
from reports.figures.obstacle_panel import draw_obstacles
from reports.figures.style import BLUE, GREEN, GROUND_COLOUR, INK, MUTED, OBSTACLE, ORANGE, PAPER, PURPLE, SKY, Look
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COLOURS = (BLUE, ORANGE, GREEN, PURPLE, SKY)
_MARGIN = 0.02  # of the larger side, around the map
_START: Look = {"marker": "o", "label": "start"}
_GOAL: Look = {"marker": "s", "label": "goal"}
_PLACE: Look = {
    "linestyle": "none", "markersize": 6.0, "markerfacecolor": INK, "markeredgecolor": PAPER,
    "markeredgewidth": 0.8, "zorder": 7,
}  # fmt: skip


def colours_of(names: Iterable[str]) -> dict[str, str]:
    """A colour for each of several plans in one figure."""
    return dict(zip(names, cycle(_COLOURS), strict=False))


def whole_map(scenario: Scenario) -> Extent:
    """The map with a little around it."""
    view = Extent(0.0, 0.0, *scenario.size)
    return view.grown(_MARGIN * view.larger)


def total(paths: Sequence[Path]) -> float | None:
    """The length of all `paths` together [m], None for none."""
    return sum(path.length for path in paths) if paths else None


def draw_ground(axes: Axes, scenario: Scenario, view: Extent) -> None:
    """Draw what of the map is in `view` on `axes`, whose box must have the view's aspect, without ticks."""
    draw_hazards(axes, scenario, view, OBSTACLE)
    axes.plot(*scenario.starts.T, **_START, **_PLACE)
    axes.plot(*scenario.goals.T, **_GOAL, **_PLACE)


def draw_hazards(axes: Axes, scenario: Scenario, view: Extent, colour: str) -> None:
    """Like `draw_ground`, without start and goal, the obstacles in that `colour`."""
    axes.set(xlim=(view.x_min, view.x_max), ylim=(view.y_min, view.y_max), facecolor=GROUND_COLOUR)
    axes.set_aspect("equal", adjustable="box")
    axes.spines[:].set_visible(True)
    draw_obstacles(axes, scenario.map, box(view.x_min, view.y_min, view.x_max, view.y_max), colour)


def label_ground(axes: Axes, room: Box, view: Extent, east: bool = True, north: bool = True) -> None:
    """Ticks and labels of a map drawn in `room`, in km where it is large; `east`, `north`: of which axes."""
    scale, unit = length_unit(view.larger)
    ticks(axes.xaxis, room.width / BROAD, scale)
    ticks(axes.yaxis, room.height / HIGH, scale)
    axes.tick_params(labelbottom=east, labelleft=north)
    axes.set(xlabel=f"east [{unit}]" if east else "", ylabel=f"north [{unit}]" if north else "")


def ground_entries(scenario: Scenario) -> list[Line2D]:
    """What the marks of `draw_ground` mean, for a legend."""
    places = [Line2D([], [], **{**_PLACE, **kind}) for kind in (_START, _GOAL)]
    edge = [Line2D([], [], color=MUTED, linewidth=1.2, label="map edge")] if scenario.map.bounds is not None else []
    return places + edge
