"""The distances between the vehicles of a fleet over time, against the separation that they should keep."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D

from planners.kernel import Floats
from reports.figures.decimate import bins_of, envelope
from reports.figures.style import INK, LIMIT, MARK, MUTED, PAPER, Look
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from reports.words.fleet_words import called
from reports.words.quantity import text
from tracking.outcome import Fleet, Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MOST_PAIRS = 6  # the closest ones are shown, fewer where the panel is narrow
_TITLE, _ENTRY = 1.2, 0.55  # [in] of the title, and of a pair in the legend beside it
_LONG, _MINUTE = 600.0, 60.0  # [s] a longer axis is labelled in minutes
_STEP = 5.0  # [pt] of the two colours of a pair
_WIDTH = 1.5  # [pt]


def draw_separation(axes: Axes, outcome: Outcome, fleet: Fleet, colours: Sequence[str]) -> None:
    """Draw those of the closest pairs of `fleet`, each in the `colours` of both; departures stand on the time axis."""
    width, height = (side / axes.figure.dpi for side in axes.bbox.size)
    apart, shown = fleet.apart, closest_pairs(fleet, min(_MOST_PAIRS, int((width - _TITLE) / _ENTRY)))
    known = apart.distances[:, shown][np.isfinite(apart.distances[:, shown])]
    top = 1.08 * max(float(known.max(initial=0.0)), 1.6 * fleet.required) or 1.0
    axes.set(xlim=(0.0, float(apart.t[-1])), ylim=(0.0, top))
    if fleet.required > 0.0:
        axes.axhspan(0.0, fleet.required, color=LIMIT, alpha=0.12, linewidth=0)
        axes.axhline(fleet.required, color=LIMIT, linewidth=0.9, linestyle=(0, (5, 2)))
        _name_limit(axes, outcome, fleet)
    for column in shown:
        _draw_pair(axes, apart.t, apart.distances[:, column], *(colours[i] for i in apart.pairs[column]))
    _mark_closest(axes, outcome, fleet)
    if any(fleet.departures):
        _draw_departures(axes, fleet, colours)
    scale, unit = length_unit(top)
    ticks(axes.yaxis, height / HIGH, scale)
    late = float(apart.t[-1]) > _LONG
    ticks(axes.xaxis, width / BROAD, _MINUTE if late else 1.0)
    axes.set_xlabel(f"time [{'min' if late else 's'}]{_closest_words(outcome)}")
    axes.set_title(f"Separation [{unit}]")
    entries: list[tuple[Any, str]] = [_pair_entry(apart.pairs[column], colours) for column in shown]
    axes.legend(
        [mark for mark, _ in entries], [label for _, label in entries], loc="lower right", bbox_to_anchor=(1.0, 1.0),
        ncols=len(entries), borderaxespad=0.15, handlelength=1.6, columnspacing=0.9, handletextpad=0.5,
    )  # fmt: skip


def closest_pairs(fleet: Fleet, most: int) -> list[int]:
    """The columns of the pairs that come closest, `most` at the most, in their order."""
    least = np.where(np.isnan(fleet.apart.distances), np.inf, fleet.apart.distances).min(axis=0)
    met = [int(column) for column in np.argsort(least, kind="stable") if np.isfinite(least[column])]
    return sorted(met[:most])


def _draw_pair(axes: Axes, t: Floats, distance: Floats, first: str, second: str) -> None:
    """A line in two colours by turns."""
    kept = envelope(t, distance, bins_of(axes))
    axes.plot(t[kept], distance[kept], color=first, linewidth=_WIDTH, zorder=3)
    axes.plot(t[kept], distance[kept], color=second, linewidth=_WIDTH, linestyle=_by_turns(), zorder=3.1)


def _by_turns() -> tuple[float, tuple[float, float]]:
    """A line pattern of `_STEP`; matplotlib counts in line widths."""
    return 0.0, (_STEP / _WIDTH, _STEP / _WIDTH)


def _mark_closest(axes: Axes, outcome: Outcome, fleet: Fleet) -> None:
    nearest = outcome.metrics["separation_min"]
    if not np.isfinite(nearest.value):
        axes.text(0.5, 0.5, nearest.note, transform=axes.transAxes, ha="center", va="center", color=MUTED)
        return
    missed = nearest.value < fleet.required
    axes.plot(
        nearest.t, nearest.value, "o", markersize=6.5, markerfacecolor=PAPER, markeredgecolor=MARK[missed],
        markeredgewidth=1.6, zorder=7, clip_on=False,
    )  # fmt: skip


def _name_limit(axes: Axes, outcome: Outcome, fleet: Fleet) -> None:
    """On the side where the ring of the closest approach is not."""
    right = not outcome.metrics["separation_min"].t > 0.5 * float(fleet.apart.t[-1])
    aside = -3.0 if right else 16.0 if any(fleet.departures) else 3.0
    axes.annotate(
        f"≥ {text(fleet.required, 'm')}", (float(right), fleet.required), xycoords=axes.get_yaxis_transform(),
        xytext=(aside, 2.0), textcoords="offset points", ha="right" if right else "left", va="bottom", fontsize=7.0,
        color=LIMIT,
    )  # fmt: skip


def _closest_words(outcome: Outcome) -> str:
    nearest = outcome.metrics["separation_min"]
    if not nearest.who:
        return ""
    whose = called(nearest.who, outcome.limits.kind)
    return f"; ring: {whose}, {text(nearest.value, 'm')} apart at {text(nearest.t, 's')}"


def _draw_departures(axes: Axes, fleet: Fleet, colours: Sequence[str]) -> None:
    """A mark on the time axis where each one leaves; those that leave together stand above each other."""
    for i, departure in enumerate(fleet.departures):
        below = sum(other == departure for other in fleet.departures[:i])
        axes.annotate(
            str(i + 1), (departure, 0.0), xytext=(2.0, 2.0 + 9.0 * below), textcoords="offset points", fontsize=6.5,
            color=PAPER, fontweight="bold", zorder=9, va="bottom", annotation_clip=False,
            bbox={"boxstyle": "square,pad=0.15", "facecolor": colours[i], "edgecolor": "none"},
        )  # fmt: skip
        axes.plot([departure, departure], [0.0, 0.12], transform=axes.get_xaxis_transform(), color=INK, linewidth=0.9)


def _pair_entry(pair: tuple[int, int], colours: Sequence[str]) -> tuple[tuple[Line2D, Line2D], str]:
    first, second = pair
    look: Look = {"linewidth": _WIDTH + 0.5}
    lines = (
        Line2D([], [], color=colours[first], **look),
        Line2D([], [], color=colours[second], linestyle=(0, (2.2, 2.2)), **look),
    )
    return lines, f"{first + 1}–{second + 1}"
