"""The picture of all trials of many cases: a row a case, a dot a trial, a column a metric in its own unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, NullLocator

from planners.kernel import Floats
from reports.figures.fitted import fit, shortened
from reports.figures.layout import RIGHT
from reports.figures.scenario_cases import Run, ScenarioRuns
from reports.figures.scenario_head import draw_scenario_head, scenario_head_height
from reports.figures.strip_panel import scattered
from reports.figures.style import BLUE, INK, LIMIT, MUTED, VERMILION, WIDTH, Look, new_figure, place
from reports.figures.ticks import FLOOR, ticks
from reports.figures.trials_data import column
from reports.words.names import listed
from reports.words.quantity import KILO, number, shown_in

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_ROWS = 24  # cases, the worst
_ALWAYS = ("cross_track_p95", "cross_track_max", "clearance_min")
_SHORT = {"cross-track error": "error", "lateral acceleration, max": "lat. accel.", "bank, max": "bank"}
_EFFORTS = ("lateral_acceleration_max", "bank_max")  # the first that any case has
_NAMES, _GAP, _TITLE, _LABELS, _KEY, _BOTTOM = 2.15, 0.22, 0.30, 0.30, 0.30, 0.06  # [in]
_ROW, _FEW_ROWS = 0.27, 0.40  # [in] of a case, and of one of a few
_FEW, _NAMED = 8, 80
_DECADES = 1.5  # a metric that varies by more has a logarithmic axis
_MANY = 500  # trials, beyond which the dots are an image in a vector file


@dataclass(frozen=True, slots=True)
class _Column:
    """A metric in the unit shown, of each case the values (F,) of the trials flown and the limit, NaN for none."""

    title: str
    values: list[Floats]
    limits: list[float]
    at_least: bool


def distribution_figure(runs: ScenarioRuns) -> Figure:
    """The figure of `runs`, of which at least one was flown; to be called, and saved, within `style.style()`."""
    cases = [run for run, _ in runs.flown][:MOST_ROWS]
    shown = _columns(cases)
    top = scenario_head_height(runs) + _KEY + _TITLE
    high = (_FEW_ROWS if len(cases) <= _FEW else _ROW) * len(cases)
    figure = new_figure(top + high + _LABELS + _BOTTOM)
    draw_scenario_head(figure, runs)
    width = (WIDTH - _NAMES - RIGHT - (len(shown) - 1) * _GAP) / len(shown)
    for i, one in enumerate(shown):
        axes = place(figure, _NAMES + i * (width + _GAP), top, width, high)
        axes.set_ylim(len(cases) - 0.5, -0.5)
        _scale(axes, one, width)
        for row, (values, limit) in enumerate(zip(one.values, one.limits, strict=True)):
            _draw_row(axes, row, values, limit, one.at_least)
        fit(axes.set_title(one.title), (width + _GAP - 0.06) * figure.dpi, 7.0)
        axes.grid(False, axis="y")
        axes.tick_params(axis="y", length=0, labelleft=False)
        axes.set_yticks(range(len(cases)))
    _draw_names(figure.axes[0], cases)
    _draw_key(figure, top - _TITLE - _KEY + 0.08)
    return figure


def _columns(cases: Sequence[Run]) -> list[_Column]:
    """The errors, the clearance where there are obstacles, and what was asked of the vehicle."""
    known = {name for run in cases for name in run.result.statistics.metrics}
    effort = [name for name in _EFFORTS if name in known][:1]
    columns = []
    for name in (*(one for one in _ALWAYS if one in known), *effort):
        unit = next(run.result.units[name][0] for run in cases if name in run.result.units)
        values = [_values(run, name) for run in cases]
        limits = [_limit(run, name) for run in cases]
        largest = max((float(np.abs(one).max()) for one in values if len(one)), default=0.0)
        factor, told = (1.0 / KILO, "km") if unit == "m" and largest >= 3.0 * KILO else shown_in(unit)
        title = f"{listed(name)} [{told}]"
        for long, short in _SHORT.items():
            title = title.replace(long, short)
        scaled = [factor * one for one in values], [factor * limit for limit in limits]
        columns.append(_Column(title, *scaled, at_least=name == "clearance_min"))
    return columns


def _values(run: Run, metric: str) -> Floats:
    found = run.result.statistics
    values = column(found, metric) if metric in found.names else np.empty(0)
    return values[np.isfinite(values)]


def _limit(run: Run, metric: str) -> float:
    """What is required of the metric, the corridor for errors; NaN for nothing."""
    if run.outcome is None:
        return np.nan
    stated = {one.requirement.metric: one.requirement.limit for one in run.outcome.verdict.margins}
    return stated.get(metric, run.outcome.corridor if metric.startswith("cross_track") else np.nan)


def _scale(axes: Axes, one: _Column, width: float) -> None:
    """One axis for all cases, with their limits on it."""
    known = np.concatenate([*one.values, [limit for limit in one.limits if np.isfinite(limit)]])
    low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)
    if low > 0.0 and np.log10(high / low) > _DECADES:
        low = max(low, high / FLOOR)
        axes.set_xscale("log")
        axes.set_xlim(low / 1.4, high * 1.4)
        axes.xaxis.set_major_locator(LogLocator(numticks=max(3, int(width / 0.4))))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: number(value, 4)))
        return
    low = min(low, 0.0)
    room = 0.06 * (high - low) or 1.0
    axes.set_xlim(low - (room if low < 0.0 else 0.3 * room), high + room)
    ticks(axes.xaxis, width / 0.45)


def _draw_row(axes: Axes, row: int, values: Floats, limit: float, at_least: bool) -> None:
    """The dots of one case, their median and from where to where 90 % of them lie, and its limit."""
    if np.isfinite(limit):
        axes.plot([limit, limit], [row - 0.5, row + 0.5], color=LIMIT, linewidth=1.0, linestyle=(0, (5, 2)), zorder=2)
    if not len(values):
        return
    values = np.maximum(values, axes.get_xlim()[0])  # what is less than a logarithmic axis shows stands at its start
    missed = (values < limit) if at_least else (values > limit)
    heights = row + scattered(len(values), 0.56 if len(values) > 1 else 0.0)
    dense = len(values) > _MANY
    look: Look = {"s": 3 if dense else 9, "alpha": 0.25 if dense else 0.6, "linewidths": 0, "rasterized": dense}
    for chosen, colour, shape in ((~missed, BLUE, "o"), (missed, VERMILION, "^")):
        axes.scatter(values[chosen], heights[chosen], color=colour, marker=shape, zorder=5, **look)
    if len(values) > 1:
        low, middle, high = np.percentile(values, [5, 50, 95])
        axes.plot([low, high], [row, row], color=INK, linewidth=1.0, zorder=4)
        axes.plot([middle, middle], [row - 0.3, row + 0.3], color=INK, linewidth=1.8, zorder=4)


def _draw_names(axes: Axes, cases: Sequence[Run]) -> None:
    """The cases at the left, each with its share of trackworthy trials."""
    for row, run in enumerate(cases):
        found = run.result.statistics
        share = f"  {found.trackworthy}/{found.tried}"
        look: Look = {
            "xycoords": ("axes fraction", "data"), "textcoords": "offset points", "va": "center", "ha": "right",
            "fontsize": 7.0, "annotation_clip": False,
        }  # fmt: skip
        told = axes.annotate(share, (0.0, row), (-5.0, 0.0), color=MUTED, **look)
        left = told.get_window_extent().x0
        name = axes.annotate(
            shortened(run.result.case.name, _NAMED),
            (0.0, row),
            ((left - axes.bbox.x0) * 72.0 / axes.figure.dpi, 0.0),
            **look,
        )
        fit(name, left - 0.12 * axes.figure.dpi)


def _draw_key(figure: Figure, top: float) -> None:
    """What dots and bars mean."""
    dot: Look = {"linestyle": "none", "markersize": 4.0, "markeredgewidth": 0.0}
    entries = [
        Line2D([], [], color=BLUE, marker="o", label="a trial", **dot),
        Line2D([], [], color=VERMILION, marker="^", label="beyond the limit", **dot),
        Line2D([], [], color=INK, linewidth=1.0, label="90 % of the trials"),
        Line2D([], [], color=INK, linestyle="none", marker="|", markersize=9.0, markeredgewidth=1.8, label="median"),
        Line2D([], [], color=LIMIT, linewidth=1.0, linestyle=(0, (5, 2)), label="limit, or the corridor"),
    ]
    figure.legend(
        handles=entries, loc="upper left", ncols=len(entries), columnspacing=1.2, handletextpad=0.5, borderaxespad=0.0,
        bbox_to_anchor=(0.2 / WIDTH, 1.0 - top / figure.get_size_inches()[1]),
    )  # fmt: skip
