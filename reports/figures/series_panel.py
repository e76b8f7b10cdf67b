"""What a run did over the distance along its path: its error, and what it asked of the vehicle against its limits."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from planners.kernel import Floats
from reports.figures.decimate import bins_of, envelope
from reports.figures.focus import Focus
from reports.figures.needed_line import draw_needed
from reports.figures.panels import Panel
from reports.figures.style import BLUE, CORRIDOR, LIMIT, MARK, MUTED, ORANGE, PAPER, TIGHT
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_THINNEST_BAR = 0.006  # of the path's length
_BAR, _HEADROOM = 0.93, 1.25  # where the bar begins, of the panel's height, and how far the axis goes beyond the values
_BROAD = 0.4  # of the path, what holds "not reached" even in a small panel
_MOST_NEEDED = 3.0  # times the limit, up to which the axis goes for what a path needs: a corner may need any


def draw_panel(axes: Axes, outcome: Outcome, panel: Panel, marked: Focus | None, legend: bool = True) -> None:
    """Draw `panel` on `axes`, with a `legend` above; the x axis is the arc length along the path [m]."""
    s = outcome.track["s"]
    ceiling = _span(axes, panel)
    if panel.corridor is not None:
        axes.axhspan(-panel.corridor, panel.corridor, color=CORRIDOR, alpha=0.22, linewidth=0, label="corridor")
    if panel.symmetric:
        axes.axhline(0.0, color="#aab4be", linewidth=0.7, zorder=1.5)
    if panel.limit is not None:
        _limit(axes, s, panel.limit, ceiling)
    if panel.grip is not None:
        _grip(axes, panel.grip)
    if panel.needed is not None:
        draw_needed(axes, *panel.needed)
    if panel.command is not None:
        _line(axes, s, panel.command, ORANGE, 1.0, "commanded")
    _line(axes, s, panel.values, BLUE, 1.4, "driven" if outcome.limits.kind == "ground" else "flown")
    _tight(axes, outcome)
    if marked is not None:
        _mark(axes, marked, panel.values)
    axes.set_title(f"{panel.title} [{panel.unit}]")
    if legend:
        axes.legend(
            loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=5, borderpad=0.0, borderaxespad=0.5, handlelength=1.1,
            columnspacing=0.55, handletextpad=0.3,
        )  # fmt: skip


def _span(axes: Axes, panel: Panel) -> float:
    """Set the y axis so that limits and values are seen but a single spike rules nothing; returns its upper end."""
    if not panel.symmetric:
        return math.nan
    finite = np.abs(panel.values[np.isfinite(panel.values)])
    limit = panel.limit[np.isfinite(panel.limit)] if panel.limit is not None else np.empty(0)
    wanted = [1.3 * float(np.median(limit))] if len(limit) else []
    wanted += [1.3 * panel.corridor] if panel.corridor is not None else []
    wanted += [1.3 * panel.grip] if panel.grip is not None else []
    wanted += [_HEADROOM * float(finite.max())] if len(finite) else []
    if panel.needed is not None and len(limit):
        wanted.append(_HEADROOM * min(float(np.abs(panel.needed[1]).max()), _MOST_NEEDED * float(np.median(limit))))
    ceiling = max(wanted, default=1.0) or 1.0
    axes.set_ylim(-ceiling, ceiling)
    return ceiling


def _limit(axes: Axes, s: Floats, limit: Floats, ceiling: float) -> None:
    kept = envelope(s, limit, bins_of(axes))
    for sign in (1.0, -1.0):
        axes.fill_between(s[kept], sign * limit[kept], sign * ceiling, color=LIMIT, alpha=0.09, linewidth=0)
        label = "limit" if sign > 0.0 else None
        axes.plot(s[kept], sign * limit[kept], color=LIMIT, linewidth=0.9, linestyle=(0, (5, 2)), label=label)


def _grip(axes: Axes, grip: float) -> None:
    for sign in (1.0, -1.0):
        label = "grip" if sign > 0.0 else None
        axes.axhline(sign * grip, color=MUTED, linewidth=0.9, linestyle=(0, (1, 1.5)), label=label)


def _line(axes: Axes, s: Floats, y: Floats, colour: str, width: float, label: str) -> None:
    kept = envelope(s, y, bins_of(axes))
    axes.plot(s[kept], y[kept], color=colour, linewidth=width, label=label, zorder=3)


def _tight(axes: Axes, outcome: Outcome) -> None:
    """A bar at the top, and a tint below it, over every stretch that is too tight."""
    widened = _THINNEST_BAR * outcome.path.length / 2
    for stretch in outcome.feasibility.stretches:
        start, end = stretch.s - widened, stretch.s_end + widened
        axes.axvspan(start, end, color=TIGHT, alpha=0.13, linewidth=0, zorder=0.6)
        axes.axvspan(start, end, _BAR, 1.0, color=TIGHT, linewidth=0, zorder=6)


def _mark(axes: Axes, marked: Focus, y: Floats) -> None:
    axes.axvline(marked.s, color=MARK[marked.alarm], linewidth=0.8, alpha=0.7, zorder=2)
    if marked.index is not None:
        axes.plot(
            marked.s, y[marked.index], "o", markersize=6.5, markerfacecolor=PAPER, markeredgecolor=MARK[marked.alarm],
            markeredgewidth=1.6, zorder=7,
        )  # fmt: skip


def mark_unreached(axes: Axes, outcome: Outcome) -> None:
    """Hatch the part of the path that was never reached."""
    s = outcome.track["s"][np.isfinite(outcome.track["s"])]
    reached = float(s.max()) if len(s) else 0.0
    if reached < outcome.path.length - max(outcome.corridor, 0.005 * outcome.path.length):
        axes.axvspan(
            reached,
            outcome.path.length,
            facecolor="none",
            edgecolor="#c8d0d8",
            hatch="////",
            linewidth=0,
            zorder=0.5,
        )
        # Where there is no room in the middle of it, before its end.
        broad = outcome.path.length - reached > _BROAD * outcome.path.length
        axes.text(
            (reached + outcome.path.length) / 2 if broad else outcome.path.length, 0.08, "not reached",
            transform=axes.get_xaxis_transform(), ha="center" if broad else "right", va="bottom",
            color=MUTED, fontsize=7.5,
            bbox={"facecolor": PAPER, "edgecolor": "none", "pad": 1.5},
        )  # fmt: skip
