"""The picture of one run: the map, its worst point from near, and errors and effort over the distance."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from reports.figures.extent import Extent, around, whole
from reports.figures.focus import Focus, focus
from reports.figures.frame import draw_frame
from reports.figures.header import draw_header, head_of, header_height
from reports.figures.layout import Box, Layout, layout, member_layout, page_layout
from reports.figures.legend import legend_entries
from reports.figures.map_panel import colour_top, draw_map
from reports.figures.near_panel import draw_near
from reports.figures.panels import panels
from reports.figures.series_panel import draw_panel, mark_unreached
from reports.figures.style import MUTED, WIDTH, error_colours, new_figure, place, save, style
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from reports.figures.wind_mark import draw_wind
from reports.words.fleet_words import member_name
from reports.words.quantity import number
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_NARROW = 2.5  # [in] a narrower series has no room for a legend, and its neighbour's


def save_track_figure(outcome: Outcome, file: str | Path) -> None:
    """Write the picture of `outcome` as PNG (1600 pixels wide) or SVG, by the suffix of `file`.

    Of a fleet it shows the member that decides. The same outcome gives the same bytes. Raises `InputError` where the
    folder does not exist.
    """
    with style():
        save(track_figure(outcome), file)


def track_figure(outcome: Outcome, page: bool = False, trial: str = "") -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`.

    `page` makes it lower, for a page that has other things to say, and leaves the map of a fleet to the fleet's own
    figure; `trial` says which trial of its case it is, where there are several.
    """
    view, shown, marked = whole(outcome), panels(outcome), focus(outcome)
    aspect, count, lead = view.width / view.height, len(shown), shown[0].needed is not None
    head = head_of(outcome, trial, member_name(outcome))
    top = header_height(head)
    if page:
        plan = (member_layout(count) if outcome.fleet else page_layout(aspect, count, lead)).lower(top)
    else:
        plan = layout(aspect, count, top, lead)
    figure = new_figure(plan.height)
    draw_header(figure, head)
    if plan.map is not None:
        view = _draw_map(figure, outcome, marked, view, plan.map)
    if marked is not None:
        near = around(outcome, marked, view).filled(plan.near.width / plan.near.height)
        if plan.map is not None:
            draw_frame(figure.axes[0], near)
        draw_near(_axes(figure, plan.near), outcome, marked, near)
    _draw_key(figure, outcome, marked, plan)
    scale, unit = length_unit(outcome.path.length)
    for panel, box, lowest, labelled in zip(shown, plan.series, plan.lowest, plan.labelled, strict=True):
        axes = _axes(figure, box)
        axes.set_xlim(-0.01 * outcome.path.length, 1.01 * outcome.path.length)
        draw_panel(axes, outcome, panel, marked, legend=box.width > _NARROW)
        mark_unreached(axes, outcome)
        ticks(axes.yaxis, box.height / HIGH)
        ticks(axes.xaxis, box.width / BROAD, scale)
        axes.tick_params(labelbottom=lowest)
        if labelled:
            axes.set_xlabel(f"distance along the path [{unit}], left is positive")
    return figure


def _draw_map(figure: Figure, outcome: Outcome, marked: Focus | None, view: Extent, room: Box) -> Extent:
    """Draw the map in `room`; returns what it shows."""
    axes, view = _axes(figure, room), view.filled(room.width / room.height)
    draw_map(axes, outcome, view, marked)
    scale, unit = length_unit(view.larger)
    ticks(axes.xaxis, room.width / BROAD, scale)
    ticks(axes.yaxis, room.height / HIGH, scale)
    axes.set(xlabel=f"east [{unit}]", ylabel=f"north [{unit}]")
    if outcome.conditions.wind.speed > 0.0:
        draw_wind(axes, outcome, view)
    return view


def _draw_key(figure: Figure, outcome: Outcome, marked: Focus | None, plan: Layout) -> None:
    """What the map's colours and marks mean."""
    error = np.abs(outcome.track["cross_track"])
    beyond = bool(np.any(error[np.isfinite(error)] > outcome.corridor))
    box = plan.key
    beside = plan.key_columns > 2
    bar = place(figure, box.left if beside else box.left + 0.1, box.top + 0.06, min(1.75, box.width - 0.2), 0.09)
    top = colour_top(outcome)
    scale = ScalarMappable(Normalize(0.0, top), error_colours())
    colours = figure.colorbar(scale, cax=bar, orientation="horizontal", extend="max" if beyond else "neither")
    colours.outline.set_linewidth(0.0)
    colours.set_ticks([0.0, top / 2, top], labels=[number(share * top) for share in (0, 0.5, 1)])
    bar.tick_params(length=0, pad=2)
    bar.set_title("distance from the path [m]", loc="left", fontsize=7.5, color=MUTED, fontweight="normal", pad=3)
    left, top = (box.left + 2.1, box.top - 0.14) if beside else (box.left, box.top + 0.38)
    figure.legend(
        handles=legend_entries(outcome, marked, near_only=plan.map is None), loc="upper left", ncols=plan.key_columns,
        columnspacing=1.4, handletextpad=0.6, labelspacing=0.45, borderaxespad=0.0,
        bbox_to_anchor=(left / WIDTH, 1.0 - top / plan.height),
    )  # fmt: skip


def _axes(figure: Figure, box: Box) -> Axes:
    return place(figure, box.left, box.top, box.width, box.height)
