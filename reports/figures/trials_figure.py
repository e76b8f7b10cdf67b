"""The picture of many trials: error along the path with its bootstrap band, bias and spread, margins of every trial."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from campaigns.statistics import Band
from campaigns.summary import CaseResult
from planners.kernel import Floats
from reports.figures.decimate import bins_of, envelope
from reports.figures.header import Head, draw_header, header_height
from reports.figures.layout import LEFT, RIGHT
from reports.figures.strip_panel import LABELS, draw_strips, strips_height
from reports.figures.style import BLUE, CORRIDOR, INK, LIMIT, MUTED, ORANGE, WIDTH, new_figure, place
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from reports.figures.trials_data import strips
from reports.words.campaign_words import case_verdict_words
from reports.words.quantity import text
from reports.words.trials_words import case_setting, headline_words, verdict_reason, worst_name
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TITLE, _LABELS, _BOTTOM = 0.24, 0.44, 0.08  # [in] above and below axes
_SIZE, _BIAS = 1.75, 1.0  # [in] heights of the panels


def trials_figure(result: CaseResult, outcome: Outcome) -> Figure:
    """The figure of all trials of a case, to be called, and saved, within `style.style()`.

    `outcome` is the worst one's. The case must have a band: two trials or more without error.
    """
    band, shown = result.statistics.band, strips(result.statistics, outcome)
    if band is None:
        raise ValueError(f"{result.case.name}: one trial has no band")
    head = trials_head(result, outcome)
    top = header_height(head) + _TITLE
    bias_top = top + _SIZE + _TITLE + 0.1
    strips_top = bias_top + _BIAS + _LABELS + _TITLE + 0.04
    figure = new_figure(strips_top + strips_height(len(shown)) + _LABELS + _BOTTOM)
    draw_header(figure, head)
    width = WIDTH - LEFT - RIGHT
    size, bias = place(figure, LEFT, top, width, _SIZE), place(figure, LEFT, bias_top, width, _BIAS)
    _draw_size(size, result, outcome, band)
    _draw_bias(bias, outcome, band)
    scale, unit = length_unit(outcome.path.length)
    for axes, height in ((size, _SIZE), (bias, _BIAS)):
        axes.set_xlim(-0.01 * outcome.path.length, 1.01 * outcome.path.length)
        ticks(axes.yaxis, height / HIGH)
        ticks(axes.xaxis, width / BROAD, scale)
        axes.legend(
            loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=4, borderaxespad=0.15, handlelength=1.4,
            columnspacing=1.0, handletextpad=0.5,
        )  # fmt: skip
    size.tick_params(labelbottom=False)
    whose = "path of the worst trial" if result.case.replan else "path"
    bias.set_xlabel(f"distance along the {whose} [{unit}], left is positive")
    left = LABELS + 0.2
    draw_strips(place(figure, left, strips_top, WIDTH - 0.8 - left, strips_height(len(shown))), result, shown)
    return figure


def trials_head(result: CaseResult, outcome: Outcome) -> Head:
    """The head of the figure."""
    told = [verdict_reason(result), headline_words(result)]
    return Head(
        result.case.name,
        result.verdict == TRACKWORTHY,
        case_verdict_words(result),
        case_setting(result, outcome),
        "; ".join(filter(None, told)),
    )


def _draw_size(axes: Axes, result: CaseResult, outcome: Outcome, band: Band) -> None:
    """The size of the error: of the trials' median with its band, and of the worst trial."""
    places, corridor = _places(outcome, band), outcome.corridor
    s, error = outcome.track["s"], np.abs(outcome.track["cross_track"])
    largest = float(np.max(error[np.isfinite(error)], initial=float(np.max(band.high))))
    ceiling = max(1.12 * corridor, 1.05 * largest)
    axes.set_ylim(0.0, ceiling)
    axes.axhspan(corridor, ceiling, color=LIMIT, alpha=0.09, linewidth=0)
    axes.axhline(corridor, color=LIMIT, linewidth=0.9, linestyle=(0, (5, 2)), label=f"corridor {text(corridor, 'm')}")
    kept = envelope(s, error, bins_of(axes))
    axes.plot(s[kept], error[kept], color=ORANGE, linewidth=0.9, label=worst_name(result), zorder=2.5)
    axes.plot(places, band.median, color=BLUE, linewidth=1.4, label="median", zorder=3)
    axes.fill_between(
        places, band.low, band.high, color=BLUE, alpha=0.25, linewidth=0, label="95 % bootstrap band", zorder=2
    )
    axes.set_title("Size of the cross-track error [m]")


def _draw_bias(axes: Axes, outcome: Outcome, band: Band) -> None:
    """The signed mean over the trials, and how far they scatter about it; on a scale of its own."""
    places, corridor = _places(outcome, band), outcome.corridor
    ceiling = 1.25 * float(np.max(np.abs(band.bias) + band.spread)) or 1.0
    axes.set_ylim(-ceiling, ceiling)
    if corridor < ceiling:
        axes.axhspan(-corridor, corridor, color=CORRIDOR, alpha=0.22, linewidth=0, label="corridor")
    axes.axhline(0.0, color="#aab4be", linewidth=0.7, zorder=1.5)
    low, high = band.bias - band.spread, band.bias + band.spread
    axes.fill_between(places, low, high, color=MUTED, alpha=0.3, linewidth=0, label="± spread of the trials", zorder=2)
    axes.plot(places, band.bias, color=INK, linewidth=1.2, label="bias: mean of the trials", zorder=3)
    axes.set_title("Bias and spread of the cross-track error [m]")


def _places(outcome: Outcome, band: Band) -> Floats:
    """The middles of the band's pieces of arc length [m]."""
    count = len(band.median)
    return (np.arange(count) + 0.5) * outcome.path.length / count
