"""The worst place of a scenario from near: every planned path there, and what the worst case did."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from matplotlib.figure import Figure

from reports.figures.body import draw_body
from reports.figures.extent import Extent
from reports.figures.fitted import fit
from reports.figures.focus import Focus
from reports.figures.frame import draw_frame
from reports.figures.layout import Box
from reports.figures.legend import mark_look
from reports.figures.scenario_cases import Run
from reports.figures.scenario_map import draw_band, draw_driven, draw_ground, draw_planned, members_of
from reports.figures.style import INK, MARK, Look, place
from reports.figures.ticks import ticks_from
from tracking.outcome import Outcome

_LABEL_PAD, _TITLE_PAD = 4.5, 16.0  # [pt] above the box
_SMALLEST = 7.0  # [pt]


def draw_worst_place(
    figure: Figure,
    room: Box,
    flown: Sequence[tuple[Run, Outcome]],
    looks: Mapping[str, Look],
    worst: tuple[Run, Outcome],
    marked: Focus,
    near: Extent,
) -> None:
    """Draw the surroundings `near` of `marked`, a place of the `worst` case, in `room`, and frame them on the map."""
    draw_frame(figure.axes[0], near)
    axes = place(figure, room.left, room.top, room.width, room.height)
    draw_ground(axes, worst[1], near)
    for run, outcome in reversed(flown):
        draw_planned(axes, [one.path for one in members_of(outcome)], near, looks[run.source])
    draw_band(axes, *worst, near, looks[worst[0].source]["color"])
    draw_driven(axes, worst[1], near, INK, 1.2)
    draw_body(axes, worst[1], marked.index)
    ring = mark_look("", "o", 12.0, "none", MARK[marked.alarm])
    axes.plot(marked.x, marked.y, **{**ring, "markeredgewidth": 1.8, "zorder": 8})
    ticks_from(axes, marked.x, marked.y)
    title = axes.set_title(marked.title, pad=_TITLE_PAD)
    told = axes.annotate(
        marked.label, (0.0, 1.0), xycoords="axes fraction", xytext=(0.0, _LABEL_PAD),
        textcoords="offset points", fontsize=7.5, va="bottom", annotation_clip=False,
    )  # fmt: skip
    for text in (title, told):
        fit(text, room.width * figure.dpi, _SMALLEST)
