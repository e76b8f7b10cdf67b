"""The picture of a scenario: the planned paths of all cases on it, what was flown of each, and its worst place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from reports.figures.extent import Extent, around, whole_fleet
from reports.figures.fitted import fit, shortened
from reports.figures.focus import Focus, focus
from reports.figures.layout import LEFT, Box
from reports.figures.legend import mark_look
from reports.figures.scenario_cases import Run, ScenarioRuns
from reports.figures.scenario_head import draw_scenario_head, scenario_head_height
from reports.figures.scenario_layout import MOST_SHARES, ScenarioLayout, scenario_layout
from reports.figures.scenario_map import (
    OTHERS,
    PLAIN,
    draw_band,
    draw_driven,
    draw_ground,
    draw_planned,
    draw_told_apart,
    driven_marks,
    ground_marks,
    looks_of,
    members_of,
)  # fmt: skip
from reports.figures.scenario_near import draw_worst_place
from reports.figures.style import INK, MARK, MUTED, WIDTH, Look, new_figure, place
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from reports.figures.wind_mark import draw_wind, same_wind
from reports.words.quantity import counted
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LEGEND_NAME, _TITLE = 34, 60  # characters of a name
_ASIDE, _SMALLEST = 0.3, 7.0  # [in] that a title may be wider than its map, and its smallest type [pt]


def scenario_figure(runs: ScenarioRuns) -> Figure:
    """The figure of `runs`, of which at least one was flown; to be called, and saved, within `style.style()`.

    The map has the planned paths by source. Of several sources, or else controllers or settings, each has a map of its
    own with its tracks, the worst first, as many as there is room for; otherwise the tracks are on the map itself.
    """
    flown, groups = runs.flown, runs.groups
    view = whole_fleet([member for _, outcome in flown for member in members_of(outcome)])
    looks = looks_of(runs.sources) if len(runs.sources) > 1 else {runs.sources[0]: PLAIN}
    tracks = looks if len(looks) > 1 else looks_of(groups)
    shares = list(groups)[:MOST_SHARES] if len(groups) > 1 else []
    marked = focus(flown[0][1])
    top = scenario_head_height(runs)
    entries = [
        *_named(looks, tracks),
        *driven_marks(runs.driven, runs.banded),
        *ground_marks([outcome for _, outcome in flown]),
    ]
    plan = scenario_layout(view.width / view.height, top, marked is not None, len(shares), -(-(len(entries) + 1) // 4))
    figure = new_figure(plan.height)
    draw_scenario_head(figure, runs)
    view = _draw_world(figure, runs, looks, view, plan, marked)
    if marked is not None and plan.near is not None:
        near = around(flown[0][1], marked, view).filled(plan.near.width / plan.near.height)
        draw_worst_place(figure, plan.near, flown, looks, flown[0], marked, near)
        entries.append(Line2D([], [], **{**_ring(marked, 8.0), "markeredgewidth": 1.6}))
    if not shares:
        _draw_tracks(figure.axes[0], flown, view, INK)
    elif len(looks) == 1:  # the worst of each on the one path, in the colour of its own map
        for group, look in reversed([*tracks.items()]):
            draw_told_apart(figure.axes[0], groups[group][0][1], view, look)
    for i, (group, box) in enumerate(zip(shares, plan.shares, strict=True)):
        tried = sum(run.source == group for run in runs.runs) if len(looks) > 1 else len(groups[group])
        _draw_share(figure, box, group, groups[group], tried, tracks[group], view)
        _label_share(figure.axes[-1], plan.shares, i)
    figure.legend(
        handles=entries, loc="upper left", ncols=4, columnspacing=1.4, handletextpad=0.6, labelspacing=0.45,
        borderaxespad=0.0, handlelength=2.6, bbox_to_anchor=(LEFT / WIDTH, 1.0 - plan.key / plan.height),
    )  # fmt: skip
    return figure


def _draw_world(
    figure: Figure,
    runs: ScenarioRuns,
    looks: Mapping[str, Look],
    view: Extent,
    plan: ScenarioLayout,
    marked: Focus | None,
) -> Extent:
    """Draw the map with every planned path; returns what it shows."""
    box, flown = plan.map, runs.flown
    axes, view = place(figure, box.left, box.top, box.width, box.height), view.filled(box.width / box.height)
    draw_ground(axes, flown[0][1], view)
    for source, look in reversed([*looks.items()]):
        paths = [one.path for run, outcome in flown if run.source == source for one in members_of(outcome)]
        draw_planned(axes, paths, view, look)
    if marked is not None:
        axes.plot(marked.x, marked.y, **{**_ring(marked, 12.0), "markeredgewidth": 1.8, "zorder": 8})
    _label(axes, box, view)
    if same_wind([outcome for _, outcome in flown]):
        draw_wind(axes, flown[0][1], view)
    return view


def _draw_tracks(axes: Axes, flown: Sequence[tuple[Run, Outcome]], view: Extent, colour: str) -> None:
    """The tracks of `flown`, and in `colour` where most of their trials were."""
    for run, outcome in reversed(flown):
        draw_band(axes, run, outcome, view, colour)
        draw_driven(axes, outcome, view, INK)


def _draw_share(
    figure: Figure, box: Box, name: str, own: Sequence[tuple[Run, Outcome]], tried: int, look: Look, view: Extent
) -> None:
    """The map of one group: its paths, the tracks of those flown of its `tried` cases, and where
    most of their trials were.
    """
    axes, view = place(figure, box.left, box.top, box.width, box.height), view.filled(box.width / box.height)
    draw_ground(axes, own[0][1], view)
    draw_planned(axes, [one.path for _, outcome in own for one in members_of(outcome)], view, look, 2.6)
    _draw_tracks(axes, own, view, look["color"])
    good = sum(run.result.verdict == TRACKWORTHY for run, _ in own)
    title = axes.set_title(shortened(name, _TITLE), pad=14.0)
    told = axes.annotate(
        f"{good} of {counted(tried, 'case')} trackworthy", (0.0, 1.0), xycoords="axes fraction", xytext=(0.0, 4.0),
        textcoords="offset points", fontsize=7.5, color=MUTED, annotation_clip=False,
    )  # fmt: skip
    for text in (title, told):
        fit(text, (box.width + _ASIDE) * figure.dpi, _SMALLEST)
    _label(axes, box, view)


def _label_share(axes: Axes, boxes: Sequence[Box], i: int) -> None:
    """What the axes are is said at the left, and under the last of each column."""
    if boxes[i].left != boxes[0].left:
        axes.set_ylabel("")
    if any(other.left == boxes[i].left for other in boxes[i + 1 :]):
        axes.set_xlabel("")


def _label(axes: Axes, box: Box, view: Extent) -> None:
    scale, unit = length_unit(view.larger)
    ticks(axes.xaxis, box.width / BROAD, scale)
    ticks(axes.yaxis, box.height / HIGH, scale)
    axes.set(xlabel=f"east [{unit}]", ylabel=f"north [{unit}]")


def _named(looks: Mapping[str, Look], tracks: Mapping[str, Look]) -> list[Line2D | Patch]:
    """Whose planned path or, of one path, whose track is which."""
    planned = Line2D([], [], linewidth=1.5, label="planned", **PLAIN)
    names = {shortened(name, _LEGEND_NAME): look for name, look in tracks.items() if look is not OTHERS}
    own: list[Line2D | Patch] = [Line2D([], [], linewidth=1.8, label=name, **look) for name, look in names.items()]
    if len(tracks) > len(own):
        own.append(Line2D([], [], linewidth=1.8, label=f"{len(tracks) - len(own)} more", **OTHERS))
    if len(looks) > 1:
        return own
    return [planned, *own] if len(tracks) > 1 else [planned]


def _ring(marked: Focus, size: float) -> Look:
    return mark_look(marked.title.lower(), "o", size, "none", MARK[marked.alarm])
