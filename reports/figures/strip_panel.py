"""Dots of every trial for some metrics, each as the share of its limit: what is left to 100 % is the margin."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import PercentFormatter

from campaigns.summary import CaseResult
from planners.kernel import Floats
from reports.figures.style import BLUE, INK, LIMIT, MUTED, VERMILION
from reports.figures.trials_data import Strip
from reports.words.names import listed
from reports.words.quantity import text
from reports.words.trials_words import worst_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LABELS = 2.1  # [in] left of the axes, for the metrics' names
_ROW = 0.34  # [in]
_FARTHEST = 2.0  # share of the limit up to which dots stand at their place; the others at the edge
_NARROWEST = 1.12
_MANY = 500  # trials, beyond which the dots are an image in a vector file
_ASIDE = 9  # [pt] right of the axes
_GOLDEN = 0.6180339887498949  # steps of it spread dots evenly over a row's height, the same way every time


def strips_height(count: int) -> float:
    """Height of a panel of `count` metrics [in]."""
    return _ROW * max(1, count)


def scattered(count: int, height: float) -> Floats:
    """Heights for `count` dots in a row, spread evenly over `height` about 0, the same every time."""
    return np.asarray(height * (_GOLDEN * np.arange(1, count + 1) % 1.0 - 0.5))


def draw_strips(axes: Axes, result: CaseResult, shown: list[Strip]) -> None:
    """Draw one row of dots for each of `shown`; the worst trial is ringed, the median a bar."""
    used = [one.used[np.isfinite(one.used)] for one in shown]
    largest = max((float(values.max()) for values in used if len(values)), default=1.0)
    end = min(_FARTHEST, max(_NARROWEST, 1.04 * largest))
    axes.set_xlim(0.0, end)
    axes.set_ylim(len(shown) - 0.5, -0.5)
    axes.axvspan(1.0, end, color=LIMIT, alpha=0.09, linewidth=0)
    axes.axvline(1.0, color=LIMIT, linewidth=0.9, linestyle=(0, (5, 2)))
    axes.grid(False, axis="y")
    axes.tick_params(axis="y", length=0)
    axes.xaxis.set_major_formatter(PercentFormatter(1.0, decimals=0, symbol=" %"))
    axes.set_yticks(range(len(shown)), labels=[_label(one) for one in shown])
    worst = _worst(result)
    for row, one in enumerate(shown):
        _draw_row(axes, row, one, worst, end)
    beyond = f"; ▸ beyond {end:.0%}".replace("%", " %") if largest > end else ""
    ring = f"; ring: {worst_name(result)}" if worst is not None else ""
    axes.set_xlabel(f"share of the limit used; dot: a trial{ring}; bar: median{beyond}")
    axes.set_title("Margins of the trials")
    axes.annotate(
        "missed by", (1.0, 1.0), xycoords="axes fraction", xytext=(_ASIDE, 6), textcoords="offset points", fontsize=7.5,
        color=MUTED,
    )  # fmt: skip


def _draw_row(axes: Axes, row: int, one: Strip, worst: int | None, end: float) -> None:
    heights = row + scattered(len(one.used), 0.6)
    x = np.clip(one.used, 0.0, end)
    dense = len(x) > _MANY
    for chosen, colour in ((one.used <= 1.0, BLUE), (one.used > 1.0, VERMILION)):
        for beyond, shape in ((False, "o"), (True, ">")):
            here = chosen & ((one.used > end) == beyond)
            if here.any():
                axes.scatter(
                    x[here], heights[here], s=4 if dense else 14, marker=shape, color=colour,
                    alpha=0.25 if dense else 0.6, linewidths=0, clip_on=False, rasterized=dense, zorder=3,
                )  # fmt: skip
    if worst is not None and np.isfinite(x[worst]):
        axes.plot(
            x[worst], heights[worst], "o", markersize=6.0, markerfacecolor="none", markeredgecolor=INK,
            markeredgewidth=1.0, clip_on=False, zorder=5,
        )  # fmt: skip
    if len(known := one.used[np.isfinite(one.used)]):
        axes.plot([min(float(np.median(known)), end)] * 2, [row - 0.36, row + 0.36], color=INK, linewidth=1.6, zorder=4)
    if not one.stated:
        return
    axes.annotate(
        str(one.missed), (1.0, row), xycoords=("axes fraction", "data"), xytext=(_ASIDE, 0),
        textcoords="offset points", va="center", fontsize=7.5, color=VERMILION if one.missed else MUTED,
    )  # fmt: skip


def _label(one: Strip) -> str:
    return f"{listed(one.metric)} {f'≤ {text(one.limit, one.unit)}' if one.stated else 'of the corridor'}"


def _worst(result: CaseResult) -> int | None:
    """Index of the worst trial among those that were flown."""
    found, worst = result.statistics, result.worst
    flown = [trial for trial, one in zip(found.trials, found.flown, strict=True) if one]
    return flown.index(worst.trial) if worst is not None and worst.trial in flown else None
