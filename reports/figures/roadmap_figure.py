"""The picture of a Voronoi roadmap over its hazards (paper 001, Fig. 1), and of the paths that were found along it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.planner import Plan
from planners.scenario import Scenario
from planners.voronoi.roadmap import Roadmap, roadmap_of
from planners.voronoi.vd import ROADMAP
from reports.figures.fleet_map import FREE_START, FREE_TARGET, draw_ends, end_entries, member_colours
from reports.figures.fleet_plan_figure import pair_of
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.plan_map import draw_hazards, label_ground, whole_map
from reports.figures.style import DASHES, INK, MUTED, PURPLE, VERMILION, WIDTH, Look, new_figure, place
from reports.words.quantity import number

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TOP, _LABELS, _KEY, _BOTTOM, _GAP = 0.28, 0.44, 0.28, 0.06, 0.2  # [in]
_LOWEST, _HIGHEST = 1.6, 3.6  # [in] of a map
_FREE: Look = {"color": PURPLE, "linewidth": 0.9, "label": "roadmap"}
_BLOCKED: Look = {"color": VERMILION, "linewidth": 0.9, "linestyle": (0, (1, 1.5)), "label": "blocked"}
_ALONG, _AFTER = (0, (1, 1.2)), DASHES


def has_roadmap(plan: Plan) -> bool:
    """Whether `plan` was found along a Voronoi roadmap."""
    return bool(plan.stages) and plan.stages[0].name == ROADMAP


def roadmap_figure(scenario: Scenario, plan: Plan, clearance: float) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    view, roadmap = whole_map(scenario), roadmap_of(scenario, clearance)
    width = (WIDTH - LEFT - RIGHT - _GAP) / 2
    high = min(_HIGHEST, max(_LOWEST, width * view.height / view.width))
    view = view.filled(width / high)
    figure = new_figure(_TOP + high + _LABELS + _KEY + _BOTTOM)
    for i in range(2):
        box = Box(LEFT + i * (width + _GAP), _TOP, width, high)
        axes = place(figure, box.left, box.top, box.width, box.height)
        draw_hazards(axes, scenario, view, INK)
        label_ground(axes, box, view, north=i == 0)
        if i == 0:
            _draw_roadmap(axes, scenario, roadmap)
        else:
            _draw_stages(axes, scenario, plan)
    stages = [Line2D([], [], **{**look, "color": MUTED}) for look in _looks(plan)]
    roads = [Line2D([], [], **look) for look in (_FREE, *([] if roadmap.free.all() else [_BLOCKED]))]
    entries = [*end_entries(), *roads, *stages]
    figure.legend(
        handles=entries, loc="upper left", ncols=len(entries), borderaxespad=0.0, columnspacing=1.3, handletextpad=0.6,
        bbox_to_anchor=(LEFT / WIDTH, 1.0 - (_TOP + high + _LABELS + 0.06) / figure.get_size_inches()[1]),
    )  # fmt: skip
    return figure


def _draw_roadmap(axes: Axes, scenario: Scenario, roadmap: Roadmap) -> None:
    lines = roadmap.vertices[roadmap.edges]
    for look, chosen in ((_FREE, roadmap.free), (_BLOCKED, ~roadmap.free)):
        shown: Look = {"colors": look["color"], "linewidths": look["linewidth"]}
        dashes = look.get("linestyle", "solid")
        axes.add_collection(
            LineCollection(list(lines[chosen]), linestyles=[dashes], zorder=3.0, **shown), autolim=False
        )
    axes.plot(*scenario.starts.T, **{**FREE_START, "zorder": 7})
    axes.plot(*scenario.goals.T, **{**FREE_TARGET, "zorder": 7})
    axes.set_title(f"Voronoi roadmap: {len(roadmap.vertices)} vertices, {len(roadmap.edges)} edges")


def _draw_stages(axes: Axes, scenario: Scenario, plan: Plan) -> None:
    colours = member_colours(len(scenario.starts))
    for stage, look in zip(plan.stages, _looks(plan), strict=True):
        for path in stage.paths:
            axes.plot(*path.xy.T, **{**look, "color": colours[pair_of(scenario, path)[0]]}, zorder=4.0)
    for path in plan.stages[-1].paths:
        start, _ = pair_of(scenario, path)
        draw_ends(axes, path.xy, str(start + 1), colours[start])
    sums = [number(sum(path.length for path in stage.paths) / scenario.unit, 4) for stage in plan.stages]
    axes.set_title(f"Paths after each step: {' → '.join(sums)}")


def _looks(plan: Plan) -> list[Look]:
    """How each stage is drawn: the last one solid."""
    lines = [_ALONG, _AFTER, *["-"] * len(plan.stages)]
    return [
        {"label": stage.name, "linestyle": line, "linewidth": 1.8 if line == "-" else 1.2}
        for stage, line in zip(plan.stages, lines, strict=False)
    ]
