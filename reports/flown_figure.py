"""The picture of several runs one below the other: each one's map, and its cross-track error along the path."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from pathlib import Path

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from reports.extent import whole
from reports.fitted import fit
from reports.focus import focus
from reports.layout import LEFT, RIGHT, Box
from reports.legend import legend_entries
from reports.map_panel import draw_map
from reports.panels import error_panel
from reports.series_panel import draw_panel, mark_unreached
from reports.style import (
    FAIL_BADGE,
    MUTED,
    PASS_BADGE,
    VERMILION,
    WIDTH,
    Look,
    error_colours,
    new_figure,
    place,
    save,
    style,
)
from reports.ticks import BROAD, HIGH, length_unit, ticks
from reports.words import reason, setting, verdict_words
from tracking.outcome import Outcome

_HEAD, _MAP, _LABELS, _KEY, _BOTTOM = 0.86, 2.1, 0.44, 0.42, 0.06  # [in]
_WIDE, _GAP = 3.3, 0.7  # [in] of a map, and from it to the series
_COLUMNS, _LINES = 122, 2  # characters in a line of the reason, and lines at most


def save_flown_figure(outcomes: Sequence[Outcome], file: str | Path) -> None:
    """Write the picture of `outcomes` in their order as PNG (1600 pixels wide) or SVG, by the suffix of `file`.

    Each error is on a scale that holds it and the corridor, so that runs within one corridor have the same. The same
    outcomes give the same bytes. Raises `InputError` where the folder does not exist.
    """
    with style():
        save(flown_figure(outcomes), file)


def flown_figure(outcomes: Sequence[Outcome]) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    step = _HEAD + _MAP + _LABELS
    figure = new_figure(len(outcomes) * step + _KEY + _BOTTOM)
    for i, outcome in enumerate(outcomes):
        top = i * step + _HEAD
        _draw_head(figure, outcome, i * step)
        _draw_world(figure, outcome, Box(LEFT, top, _WIDE, _MAP))
        left = LEFT + _WIDE + _GAP
        _draw_error(figure, outcome, Box(left, top, WIDTH - RIGHT - left, _MAP))
    _draw_key(figure, outcomes)
    return figure


def _draw_key(figure: Figure, outcomes: Sequence[Outcome]) -> None:
    """What the marks of the maps mean; what several have, once."""
    grounded = all(outcome.limits.kind == "ground" for outcome in outcomes)
    driven = "driven" if grounded else "flown"
    flown = [
        Line2D([], [], color=error_colours()(0.0), linewidth=2.4, label=f"{driven}, paler with the error"),
        Line2D([], [], color=VERMILION, linewidth=2.4, label="beyond the corridor"),
    ]
    marks = [entry for outcome in outcomes for entry in legend_entries(outcome, focus(outcome))]
    entries = {entry.get_label(): entry for entry in [*flown, *marks]}
    figure.legend(
        handles=list(entries.values()), loc="lower left", ncols=5, borderaxespad=0.0, columnspacing=1.4,
        handletextpad=0.6, bbox_to_anchor=(LEFT / WIDTH, _BOTTOM / figure.get_size_inches()[1]),
    )  # fmt: skip


def _draw_head(figure: Figure, outcome: Outcome, top: float) -> None:
    """Name, verdict and what decided it."""
    height, good = figure.get_size_inches()[1], outcome.verdict.trackworthy
    line = 1.0 - (top + 0.2) / height
    setting_of = figure.text(1.0 - RIGHT / WIDTH, line, setting(outcome), color=MUTED, ha="right", va="center")
    verdict = f"{'✓' if good else '✗'} {verdict_words(outcome)}"
    look: Look = {"fontsize": 8.5, "fontweight": "bold", "color": PASS_BADGE if good else FAIL_BADGE, "va": "center"}
    told = figure.text(0.0, line, verdict, **look)
    name = figure.text(LEFT / WIDTH, line, outcome.name, fontsize=9.5, fontweight="bold", va="center")
    room = setting_of.get_window_extent().x0 - told.get_window_extent().width - name.get_window_extent().x0
    fit(name, room - 0.3 * figure.dpi, 8.0)
    end = name.get_window_extent().x1 / figure.bbox.width + 0.12 / WIDTH
    told.set_x(end)
    lines = textwrap.wrap(reason(outcome), _COLUMNS, max_lines=_LINES, placeholder=" …")
    figure.text(LEFT / WIDTH, 1.0 - (top + 0.31) / height, "\n".join(lines), fontsize=7.5, va="top", linespacing=1.3)


def _draw_world(figure: Figure, outcome: Outcome, box: Box) -> None:
    view = whole(outcome).filled(box.width / box.height)
    axes = place(figure, box.left, box.top, box.width, box.height)
    draw_map(axes, outcome, view, focus(outcome))
    scale, unit = length_unit(view.larger)
    ticks(axes.xaxis, box.width / BROAD, scale)
    ticks(axes.yaxis, box.height / HIGH, scale)
    axes.set(xlabel=f"east [{unit}]", ylabel=f"north [{unit}]")


def _draw_error(figure: Figure, outcome: Outcome, box: Box) -> None:
    axes = place(figure, box.left, box.top, box.width, box.height)
    scale, unit = length_unit(outcome.path.length)
    axes.set_xlim(-0.01 * outcome.path.length, 1.01 * outcome.path.length)
    draw_panel(axes, outcome, error_panel(outcome), focus(outcome))
    mark_unreached(axes, outcome)
    ticks(axes.yaxis, box.height / HIGH)
    ticks(axes.xaxis, box.width / BROAD, scale)
    axes.set_xlabel(f"distance along the path [{unit}], left is positive")
