"""The picture of a fleet's run: the map with every aircraft, their separation over time, and each one's error."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from planners.errors import TrackworthyError
from reports.figures.decimate import bins_of, envelope
from reports.figures.extent import whole_fleet
from reports.figures.fleet_layout import FleetLayout, fleet_layout, fleet_page_layout
from reports.figures.fleet_map import draw_fleet, fleet_entries, member_colours
from reports.figures.focus import focus
from reports.figures.header import draw_header, head_of, header_height
from reports.figures.layout import LEFT, Box
from reports.figures.separation_panel import draw_separation
from reports.figures.series_panel import mark_unreached
from reports.figures.style import CORRIDOR, ROUND_TICKS, WIDTH, new_figure, place, save, style
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from reports.figures.wind_mark import draw_wind
from reports.words.fleet_words import called
from reports.words.quantity import text
from tracking.outcome import Fleet, Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MOST_ERRORS = 4  # aircraft whose errors are shown: those with the largest
_HEADROOM = 1.25
_TWO_TICKS = 0.5  # [in] a lower panel has room for two labels


def save_fleet_figure(outcome: Outcome, file: str | Path) -> None:
    """Write the picture of the fleet of `outcome` as PNG (1600 pixels wide) or SVG, by the suffix of `file`.

    The same outcome gives the same bytes. Raises `InputError` where the folder does not exist.
    """
    with style():
        save(fleet_figure(outcome), file)


def fleet_figure(outcome: Outcome, page: bool = False, trial: str = "") -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`.

    `page` makes it lower, for a page that has other things to say; `trial` says which trial of its case it is, where
    there are several.
    """
    fleet = outcome.fleet
    if fleet is None:
        raise TrackworthyError(f"{outcome.name}: it is no fleet; this is a fault of trackworthy")
    colours, shown = member_colours(len(fleet.members)), _shown(fleet)
    head, view = head_of(outcome, trial), whole_fleet(fleet.members)
    aspect = view.width / view.height
    plan = (fleet_page_layout if page else fleet_layout)(aspect, len(shown), header_height(head))
    figure = new_figure(plan.height)
    draw_header(figure, head)
    _draw_world(figure, outcome, fleet, colours, plan)
    longest = max(fleet.members[i].path.length for i in shown)
    for i, box in zip(shown, plan.errors, strict=True):
        _draw_error(_axes(figure, box), fleet.members[i], i, colours[i], longest, box)
    _label_errors(figure.axes[1 : 1 + len(shown)], longest, len(shown) < len(fleet.members))
    draw_separation(_axes(figure, plan.separation), outcome, fleet, colours)
    return figure


def _shown(fleet: Fleet) -> list[int]:
    """The members whose errors are shown, in their order."""
    largest = [float(np.nanmax(np.abs(member.track["cross_track"]), initial=0.0)) for member in fleet.members]
    order = np.argsort(largest, kind="stable")[::-1]
    return sorted(int(i) for i in order[:_MOST_ERRORS])


def _draw_world(figure: Figure, outcome: Outcome, fleet: Fleet, colours: Sequence[str], plan: FleetLayout) -> None:
    axes, marked = _axes(figure, plan.map), focus(outcome)
    view = whole_fleet(fleet.members).filled(plan.map.width / plan.map.height)
    draw_fleet(axes, outcome, fleet, colours, view, marked)
    scale, unit = length_unit(view.larger)
    ticks(axes.xaxis, plan.map.width / BROAD, scale)
    ticks(axes.yaxis, plan.map.height / HIGH, scale)
    axes.set(xlabel=f"east [{unit}]", ylabel=f"north [{unit}]")
    if outcome.conditions.wind.speed > 0.0:
        draw_wind(axes, outcome, view)
    entries = fleet_entries(outcome, fleet, marked)
    figure.legend(
        handles=entries, loc="upper left", ncols=len(entries), borderaxespad=0.0, columnspacing=1.3, handletextpad=0.5,
        bbox_to_anchor=(LEFT / WIDTH, 1.0 - plan.key / plan.height),
    )  # fmt: skip


def _draw_error(axes: Axes, member: Outcome, index: int, colour: str, longest: float, box: Box) -> None:
    """The cross-track error of one member along its path, the corridor shaded."""
    s, error = member.track["s"], member.track["cross_track"]
    largest = float(np.nanmax(np.abs(error), initial=0.0))
    ceiling = _HEADROOM * max(member.corridor, largest)
    axes.set(xlim=(-0.01 * longest, 1.01 * longest), ylim=(-ceiling, ceiling))
    axes.axhspan(-member.corridor, member.corridor, color=CORRIDOR, alpha=0.22, linewidth=0)
    kept = envelope(s, error, bins_of(axes))
    axes.plot(s[kept], error[kept], color=colour, linewidth=1.5, zorder=3)
    mark_unreached(axes, member)
    ticks(axes.yaxis, min(2.0, box.height / HIGH))
    if box.height < _TWO_TICKS:
        decade = 10.0 ** np.floor(np.log10(ceiling))
        end = max(step * decade for step in ROUND_TICKS if step * decade <= ceiling)
        axes.set_yticks([-end, end])
    told = f"{called(str(index + 1), member.limits.kind)}: max {text(round(largest, 2), 'm')}"
    axes.set_title(told, loc="right", fontsize=7.5, fontweight="normal", pad=3.5)


def _label_errors(shown: Sequence[Axes], longest: float, some: bool) -> None:
    """Title above the first, and the axis that all share under the last."""
    scale, unit = length_unit(longest)
    for axes in shown:
        ticks(axes.xaxis, axes.bbox.width / axes.figure.dpi / BROAD, scale)
        axes.tick_params(labelbottom=axes is shown[-1])
    shown[0].set_title("Largest errors [m]" if some else "Cross-track error [m]", pad=3.5)
    shown[-1].set_xlabel(f"distance along the path [{unit}], left is positive")


def _axes(figure: Figure, box: Box) -> Axes:
    return place(figure, box.left, box.top, box.width, box.height)
