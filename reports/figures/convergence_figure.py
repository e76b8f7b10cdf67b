"""The picture of how searches converge over many seeds: the best sum by cost evaluations, median and band."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from planners.facts import PlanFacts
from planners.kernel import Floats
from reports.figures.layout import LEFT, RIGHT
from reports.figures.plan_map import colours_of
from reports.figures.style import INK, MUTED, WIDTH, new_figure, place
from reports.figures.ticks import BROAD, HIGH, ticks
from reports.words.quantity import KILO, counted, number

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TOP, _HIGH, _BETWEEN, _FOUND, _LABELS, _BOTTOM = 0.56, 1.9, 0.34, 0.6, 0.44, 0.06  # [in]
LOW, HIGHEST = 10.0, 90.0  # [%] of the seeds between which the band lies
_STEPS = 400  # along the axis
_THOUSANDS = 20_000  # evaluations, from which on the axis counts thousands


def convergence_figure(searches: Mapping[str, Sequence[PlanFacts]], exact: float | None = None) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    colours, width = colours_of(searches), WIDTH - LEFT - RIGHT
    figure = new_figure(_TOP + _HIGH + _BETWEEN + _FOUND + _LABELS + _BOTTOM)
    figure.legend(
        handles=[Line2D([], [], color=colours[name], linewidth=1.8, label=_name(name, searches)) for name in searches],
        loc="upper left", bbox_to_anchor=(LEFT / WIDTH, 1.0 - 0.1 / figure.get_size_inches()[1]), ncols=len(searches),
        fontsize=8.5, borderaxespad=0.0, borderpad=0.0, handlelength=1.4, columnspacing=1.6,
    )  # fmt: skip
    best = place(figure, LEFT, _TOP, width, _HIGH)
    found = place(figure, LEFT, _TOP + _HIGH + _BETWEEN, width, _FOUND)
    last = max(one.evaluations[-1] for facts in searches.values() for one in facts)
    unit = next(one.map_unit for facts in searches.values() for one in facts)
    for name, facts in searches.items():
        at = np.linspace(0.0, max(one.evaluations[-1] for one in facts), _STEPS)
        _draw(best, found, at, np.array([best_at(one, at) for one in facts]) / unit, colours[name])
    if exact is not None:
        best.axhline(exact / unit, color=INK, linewidth=0.7, zorder=2)
    scale = KILO if last >= _THOUSANDS else 1.0
    for axes in (best, found):
        axes.set_xlim(0.0, last)
        ticks(axes.xaxis, width / BROAD, scale)
    ticks(best.yaxis, _HIGH / HIGH)
    best.tick_params(labelbottom=False)
    best.set_title("Best sum so far [map units]")
    found.set(ylim=(-8.0, 108.0), yticks=[0.0, 50.0, 100.0])
    found.set_title("Seeds with paths within all limits [%]")
    found.set_xlabel(f"cost evaluations, all aircraft together{' [thousands]' if scale > 1.0 else ''}")
    _draw_key(best, exact)
    return figure


def best_at(facts: PlanFacts, evaluations: Floats) -> Floats:
    """The best length (N,) [m] that a search had after so many `evaluations` (N,); NaN before it had any.

    After its last one a search stays where it is.
    """
    values = np.array([np.nan if value is None else value for value in facts.best])
    done = np.searchsorted(np.array(facts.evaluations), evaluations, side="right") - 1
    reached: Floats = np.where(done < 0, np.nan, values[np.maximum(done, 0)])
    return reached


def spread(best: Floats) -> tuple[Floats, Floats, Floats]:
    """Low end of the band, median and high end (N,) over seeds (S, N); a seed without a path counts as infinite."""
    ranked = np.where(np.isnan(best), np.inf, best)
    low, middle, high = np.percentile(ranked, [LOW, 50.0, HIGHEST], axis=0, method="nearest")
    return low, middle, high


def _draw(best: Axes, found: Axes, at: Floats, values: Floats, colour: str) -> None:
    low, middle, high = (np.where(np.isfinite(line), line, np.nan) for line in spread(values))
    best.fill_between(at, low, high, color=colour, alpha=0.2, linewidth=0)
    best.plot(at, middle, color=colour, linewidth=1.6, zorder=3)
    found.plot(at, 100.0 * np.isfinite(values).mean(axis=0), color=colour, linewidth=1.6, zorder=3)


def _name(name: str, searches: Mapping[str, Sequence[PlanFacts]]) -> str:
    return f"{name}, {counted(len(searches[name]), 'seed')}"


def _draw_key(axes: Axes, exact: float | None) -> None:
    entries = [
        Line2D([], [], color=MUTED, linewidth=1.6, label="median"),
        Line2D([], [], color=MUTED, linewidth=6.0, alpha=0.25, label=f"{number(LOW)} to {number(HIGHEST)} % of seeds"),
    ]
    if exact is not None:
        entries.append(Line2D([], [], color=INK, linewidth=0.7, label="exact shortest"))
    axes.legend(
        handles=entries, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, borderaxespad=0.15, handlelength=1.8,
        columnspacing=1.0, handletextpad=0.5,
    )  # fmt: skip
