"""The picture of what all cases on a scenario did: each one's error, and what the worst asked of the vehicle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from reports.figures.decimate import bins_of, envelope
from reports.figures.effort_grid import draw_efforts, grid_height, side_by_side
from reports.figures.fitted import fit, shortened
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.scenario_cases import Run, ScenarioRuns, within_group
from reports.figures.scenario_head import draw_scenario_head, scenario_head_height
from reports.figures.scenario_map import LOOKS, OTHERS, looks_of
from reports.figures.style import CORRIDOR, MUTED, WIDTH, Look, new_figure, place
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from reports.words.quantity import number, text
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_PANELS = 6  # of the worst sources
_FULL = WIDTH - LEFT - RIGHT
_GAP, _TITLE, _LABELS, _BETWEEN, _ROW, _BOTTOM = 0.62, 0.26, 0.44, 0.48, 0.165, 0.06  # [in]
_HIGH, _HIGHEST = 1.0, 1.6  # [in] of a panel of several, and of one alone
_NEAR, _FAR = 0.4, 3.0  # corridors up to which the axis leaves the corridor out, and up to which it is linear
_ROOM = 1.15  # how far the axis goes beyond what it holds
_NAMED, _LEGEND_NAME = 60, 34  # characters


def errors_figure(runs: ScenarioRuns) -> Figure:
    """The figure of `runs`, of which at least one was flown; to be called, and saved, within `style.style()`.

    Above, the errors of the worst trial of each case over the distance along its path, a panel a group of cases and all
    on one scale; below, side by side, what the worst case of each group asked of the same vehicle.
    """
    groups = {name: runs.groups[name] for name in list(runs.groups)[:MOST_PANELS]}
    looks = looks_of(dict.fromkeys(within_group(run, name) for name, own in groups.items() for run, _ in own))
    efforts = side_by_side(groups)
    top = scenario_head_height(runs)
    columns = 1 if len(groups) == 1 else 2
    high, rows = _HIGHEST if columns == 1 else _HIGH, -(-len(groups) // columns)
    key_rows = -(-(min(len(looks), len(LOOKS) + 1) + 2) // 3)
    key = top + 0.08
    first = key + key_rows * _ROW + _TITLE + 0.12
    bottom = first + rows * high + (rows - 1) * _BETWEEN + _LABELS
    figure = new_figure(bottom + grid_height(efforts) + _BOTTOM)
    draw_scenario_head(figure, runs)
    shown = [outcome for own in groups.values() for _, outcome in own]
    corridor = max(outcome.corridor for outcome in shown)
    ceiling, longest = _ceiling(groups), max(outcome.path.length for outcome in shown)
    wide = (_FULL - (columns - 1) * _GAP) / columns
    for i, (name, own) in enumerate(groups.items()):
        box = Box(LEFT + i % columns * (wide + _GAP), first + i // columns * (high + _BETWEEN), wide, high)
        axes = place(figure, box.left, box.top, box.width, box.height)
        _draw_errors(axes, name, own, looks)
        _scale(axes, corridor, ceiling, high)
        _label(axes, box, longest, lowest=i + columns >= len(groups))
    _draw_key(figure, looks, key, shown, ceiling, runs.banded)
    if efforts:
        draw_efforts(figure, bottom, efforts)
    return figure


def _ceiling(groups: Mapping[str, Sequence[tuple[Run, Outcome]]]) -> float:
    """Where the axis of all errors ends [m]: it holds them all with their bands, and the corridor where they come near
    it.
    """
    runs = [one for own in groups.values() for one in own]
    corridor = max(outcome.corridor for _, outcome in runs)
    bands = [run.result.statistics.band for run, _ in runs]
    edges = [float(np.abs(edge).max()) for band in bands if band is not None for edge in (band.p5, band.p95)]
    largest = max([*(_largest(outcome) for _, outcome in runs), *edges])
    if largest < _NEAR * corridor:
        return _ROOM * largest or corridor
    return _ROOM * max(largest, corridor) if largest <= _FAR * corridor else 2.0 * largest


def _scale(axes: Axes, corridor: float, ceiling: float, high: float) -> None:
    """An axis up to `ceiling` [m], which beyond the `corridor` is logarithmic where it goes far beyond it."""
    if ceiling <= _ROOM * _FAR * corridor:
        axes.set_ylim(-ceiling, ceiling)
        ticks(axes.yaxis, high / HIGH)
        return
    axes.set_yscale("symlog", linthresh=corridor, linscale=0.7)
    axes.set_ylim(-ceiling, ceiling)
    decades = [corridor * 10.0**power for power in range(1 + int(np.log10(ceiling / corridor)))]
    shown = decades[:: max(1, round(len(decades) / 2))]
    places = [*(-one for one in reversed(shown)), 0.0, *shown]
    axes.set_yticks(places, labels=[number(one) for one in places])
    axes.minorticks_off()


def _largest(outcome: Outcome) -> float:
    return float(np.nanmax(np.abs(outcome.track["cross_track"]), initial=0.0))


def _draw_errors(axes: Axes, name: str, own: Sequence[tuple[Run, Outcome]], looks: Mapping[str, Look]) -> None:
    """The errors of one group's cases, the worst on top, with the band of their trials."""
    corridor = max(outcome.corridor for _, outcome in own)
    axes.axhspan(-corridor, corridor, color=CORRIDOR, alpha=0.22, linewidth=0)
    axes.axhline(0.0, color="#aab4be", linewidth=0.7, zorder=1.5)
    for run, outcome in reversed(own):
        look = looks[within_group(run, name)]
        s, error = outcome.track["s"], outcome.track["cross_track"]
        kept = envelope(s, error, bins_of(axes))
        axes.plot(s[kept], error[kept], linewidth=1.1, zorder=2.4 if look is OTHERS else 3.0, **look)
        band = run.result.statistics.band
        if band is not None and look is not OTHERS:
            middles = (np.arange(len(band.p5)) + 0.5) * outcome.path.length / len(band.p5)
            fill: Look = {"color": look["color"], "alpha": 0.22, "linewidth": 0, "zorder": 2.0}
            axes.fill_between(middles, band.p5, band.p95, **fill)
    largest = max(_largest(outcome) for _, outcome in own)
    told = axes.set_title(f"max {text(largest, 'm')}", loc="right", fontsize=7.5, fontweight="normal", color=MUTED)
    title = axes.set_title(shortened(name, _NAMED))
    fit(title, axes.bbox.width - told.get_window_extent().width - 24.0, 7.0)


def _label(axes: Axes, box: Box, longest: float, lowest: bool) -> None:
    scale, unit = length_unit(longest)
    axes.set_xlim(-0.01 * longest, 1.01 * longest)
    ticks(axes.xaxis, box.width / BROAD, scale)
    axes.tick_params(labelbottom=lowest)
    if lowest:
        axes.set_xlabel(f"distance along the path [{unit}]")
    if box.left == LEFT:
        axes.set_ylabel("error [m]")


def _draw_key(
    figure: Figure, looks: Mapping[str, Look], top: float, outcomes: Sequence[Outcome], ceiling: float, banded: bool
) -> None:
    """Whose line is which, the corridor and the band."""
    own = {name: look for name, look in looks.items() if look is not OTHERS}
    entries: list[Line2D | Patch] = [
        Line2D([], [], linewidth=1.4, label=shortened(name, _LEGEND_NAME), **look) for name, look in own.items()
    ]
    if len(looks) > len(own):
        entries.append(Line2D([], [], linewidth=1.4, label=f"{len(looks) - len(own)} more settings", **OTHERS))
    corridors = sorted({outcome.corridor for outcome in outcomes})
    width = " to ".join(text(one, "m") for one in {corridors[0]: 0, corridors[-1]: 0})
    wider = ", wider than the axis" if corridors[0] > ceiling else ""
    wider = ", beyond it the axis is logarithmic" if ceiling > _ROOM * _FAR * corridors[-1] else wider
    entries.append(Patch(facecolor=CORRIDOR, alpha=0.3, label=f"corridor ± {width}{wider}"))
    if banded:
        entries.append(Patch(facecolor=MUTED, alpha=0.35, label="90 % of the trials"))
    figure.legend(
        handles=entries, loc="upper left", ncols=min(3, len(entries)), columnspacing=1.2, handletextpad=0.5,
        labelspacing=0.45, borderaxespad=0.0, handlelength=2.4,
        bbox_to_anchor=(LEFT / WIDTH, 1.0 - top / figure.get_size_inches()[1]),
    )  # fmt: skip


def unshown_groups(runs: ScenarioRuns) -> int:
    """How many groups of cases have no panel."""
    return max(0, len(runs.groups) - MOST_PANELS)
