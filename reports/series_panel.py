"""What a run did over the distance along its path: error, curvature, and what the vehicle gave for it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from planners.frame import WGS84_A
from planners.kernel import Floats
from planners.units import STANDARD_GRAVITY
from reports.decimate import envelope
from reports.focus import Focus
from reports.quantity import KILO
from reports.style import BLUE, CORRIDOR, INK, LIMIT, MUTED, ORANGE, PAPER, TIGHT, WORST
from tracking.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_BINS = 1100  # about the pixels of a panel
_EARTHLY = 0.05  # a frame whose planet differs in size from the Earth by less than this has the Earth's gravity


@dataclass(frozen=True, slots=True)
class Panel:
    """What a panel shows: `column` times `factor`, under a `limit` (N,) in the unit shown; None where there is none."""

    title: str
    label: str
    column: str
    factor: float
    limit: Floats | None
    limit_name: str = "limit"
    command: str | None = None
    corridor: float | None = None
    symmetric: bool = True


def panels(outcome: Outcome) -> list[Panel]:
    """The panels that the track's columns allow: error and curvature always, then height and the vehicle's own."""
    makers: list[Callable[[Outcome], Panel | None]] = [
        _error,
        _curvature,
        _height,
        _bank,
        _steering,
        _lateral,
    ]
    return [panel for maker in makers if (panel := maker(outcome)) is not None]


def _error(outcome: Outcome) -> Panel:
    stated = _stated(outcome, "cross_track_max")
    limit = None if stated is None or stated == outcome.corridor else _constant(outcome, stated)
    return Panel("Cross-track error", "error [m]", "cross_track", 1.0, limit, corridor=outcome.corridor)


def _curvature(outcome: Outcome) -> Panel:
    with np.errstate(divide="ignore"):
        limit = outcome.limits.lateral_acceleration / outcome.track["ground_speed"] ** 2
    limit = np.minimum(limit, outcome.limits.curvature_max)
    tightest = outcome.limits.lateral_acceleration / outcome.speed**2
    factor, unit = (KILO, "1/km") if tightest < 0.02 else (1.0, "1/m")
    return Panel("Curvature", f"curvature [{unit}]", "curvature", factor, factor * limit, command="curvature_command")


def _height(outcome: Outcome) -> Panel | None:
    if outcome.path.z is None:
        return None
    return Panel("Height", "height [m]", "z", 1.0, None, command="altitude_command", symmetric=False)


def _bank(outcome: Outcome) -> Panel | None:
    frame = outcome.track.frame or outcome.path.frame
    earth = frame is None or abs(frame.a / WGS84_A - 1.0) < _EARTHLY
    able = math.atan(outcome.limits.lateral_acceleration / STANDARD_GRAVITY) if earth else math.inf
    limit = min(able, _stated(outcome, "bank_max") or math.inf)
    return _own(outcome, "Bank", "bank [°]", "bank", math.degrees(1.0), limit if math.isfinite(limit) else None)


def _steering(outcome: Outcome) -> Panel | None:
    limit = _stated(outcome, "steering_max")
    if limit is None and math.isfinite(outcome.limits.curvature_max):
        limit = math.atan(outcome.limits.curvature_max * outcome.limits.equivalent_length)
    return _own(outcome, "Steering", "steering [°]", "steering", math.degrees(1.0), limit)


def _lateral(outcome: Outcome) -> Panel | None:
    limit = _stated(outcome, "lateral_acceleration_max") or outcome.limits.lateral_acceleration
    return _own(outcome, "Lateral acceleration", "a [m/s²]", "lateral_acceleration", 1.0, limit)


def _own(outcome: Outcome, title: str, label: str, column: str, factor: float, limit: float | None) -> Panel | None:
    if column not in outcome.track:
        return None
    line = None if limit is None else _constant(outcome, factor * limit)
    return Panel(title, label, column, factor, line)


def _stated(outcome: Outcome, metric: str) -> float | None:
    found = (margin.requirement.limit for margin in outcome.verdict.margins if margin.requirement.metric == metric)
    return next(found, None)


def _constant(outcome: Outcome, value: float) -> Floats:
    return np.full(len(outcome.track), value)


def draw_panel(axes: Axes, outcome: Outcome, panel: Panel, marked: Focus | None) -> None:
    """Draw `panel` on `axes`; the x axis is the arc length along the path [m]."""
    s, y = outcome.track["s"], panel.factor * outcome.track[panel.column]
    ceiling = _span(axes, outcome, panel, y)
    if panel.corridor is not None:
        axes.axhspan(-panel.corridor, panel.corridor, color=CORRIDOR, alpha=0.22, linewidth=0, label="corridor")
    if panel.symmetric:
        axes.axhline(0.0, color="#aab4be", linewidth=0.7, zorder=1.5)
    if panel.limit is not None:
        _limit(axes, s, panel, ceiling)
    if panel.command is not None:
        _line(axes, s, panel.factor * outcome.track[panel.command], ORANGE, 1.0, "commanded")
    _line(
        axes,
        s,
        y,
        BLUE,
        1.4,
        "achieved" if panel.command else "flown" if outcome.limits.kind != "ground" else "driven",
    )
    for turn in outcome.feasibility.tight:
        axes.plot(
            turn.s, 1.0, "v", transform=axes.get_xaxis_transform(), markersize=5.0, markerfacecolor=TIGHT,
            markeredgecolor=INK, markeredgewidth=0.6, zorder=6, clip_on=False,
        )  # fmt: skip
    if marked is not None:
        _mark(axes, marked, y)
    axes.set_title(panel.title)
    axes.set_ylabel(panel.label)
    axes.legend(
        loc="lower right",
        bbox_to_anchor=(1.0, 1.0),
        ncols=4,
        borderaxespad=0.15,
        handlelength=1.3,
        columnspacing=1.0,
        handletextpad=0.5,
    )


def _span(axes: Axes, outcome: Outcome, panel: Panel, y: Floats) -> float:
    """Set the y axis so that limit and values are seen but a single spike rules nothing; returns its upper end."""
    finite = np.abs(y[np.isfinite(y)])
    if not panel.symmetric:
        return math.nan
    limit = panel.limit[np.isfinite(panel.limit)] if panel.limit is not None else np.empty(0)
    wanted = [1.3 * float(np.median(limit))] if len(limit) else []
    wanted += [1.3 * panel.corridor] if panel.corridor is not None else []
    wanted += [1.15 * float(finite.max())] if len(finite) else []
    ceiling = max(wanted, default=1.0) or 1.0
    axes.set_ylim(-ceiling, ceiling)
    return ceiling


def _limit(axes: Axes, s: Floats, panel: Panel, ceiling: float) -> None:
    assert panel.limit is not None
    kept = envelope(s, panel.limit, _BINS)
    for sign in (1.0, -1.0):
        axes.fill_between(s[kept], sign * panel.limit[kept], sign * ceiling, color=LIMIT, alpha=0.09, linewidth=0)
        label = panel.limit_name if sign > 0.0 else None
        axes.plot(s[kept], sign * panel.limit[kept], color=LIMIT, linewidth=0.9, linestyle=(0, (5, 2)), label=label)


def _line(axes: Axes, s: Floats, y: Floats, colour: str, width: float, label: str) -> None:
    kept = envelope(s, y, _BINS)
    axes.plot(s[kept], y[kept], color=colour, linewidth=width, label=label, zorder=3)


def _mark(axes: Axes, marked: Focus, y: Floats) -> None:
    axes.axvline(marked.s, color=WORST, linewidth=0.8, alpha=0.7, zorder=2)
    if marked.index is not None:
        axes.plot(
            marked.s, y[marked.index], "o", markersize=6.5, markerfacecolor=PAPER, markeredgecolor=WORST,
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
        axes.text(
            (reached + outcome.path.length) / 2, 0.08, "not reached", transform=axes.get_xaxis_transform(),
            ha="center", va="bottom", color=MUTED, fontsize=7.5,
            bbox={"facecolor": PAPER, "edgecolor": "none", "pad": 1.5},
        )  # fmt: skip
