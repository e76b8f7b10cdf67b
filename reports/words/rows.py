"""The metrics of a run as rows of text: the same in the terminal and in the PDF."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from reports.words.quantity import pair, text, text_with_g
from tracking.metric import Margin, Metric
from tracking.outcome import Outcome

REQUIREMENTS, FOLLOWING, SURROUNDINGS, VEHICLE, PLAN, OTHER = (
    "requirements", "path following", "surroundings", "vehicle", "plan", "other",
)  # fmt: skip
# A metric belongs to the first group that has a start of its name.
_GROUPS = {
    FOLLOWING: (
        "cross_track", "corridor", "completion", "heading_error", "course_error", "altitude_error", "speed_error",
        "frechet", "corner_cut", "overshoot", "turn_angle_max_flown", "track_length", "length_ratio",
    ),
    SURROUNDINGS: ("clearance", "incursion", "separation", "departure", "range"),
    VEHICLE: ("bank", "load_factor", "stall", "control_saturation", "steering", "lateral", "friction"),
    PLAN: ("path_length", "turn_"),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Row:
    """One metric as text: `at` where along the path and `when` it was worst, or "" for a metric without a place.

    `limit` and `margin` are for a requirement; elsewhere they are "" and `met` is None. `who` is which of a fleet.
    """

    group: str
    name: str
    value: str
    limit: str
    margin: str
    at: str
    when: str
    met: bool | None
    note: str
    who: str


def rows(outcome: Outcome) -> list[Row]:
    """The requirements in their order, then every other metric that could be measured, in groups."""
    margins = outcome.verdict.margins
    required = {margin.metric.name for margin in margins}
    others = [_plain(metric) for metric in outcome.metrics.values() if metric.valid and metric.name not in required]
    order = [*_GROUPS, OTHER]
    return [*map(_required, margins), *sorted(others, key=lambda row: order.index(row.group))]


def unmeasured(outcome: Outcome, called: Callable[[str], str] = str) -> list[str]:
    """What could not be measured, one line for each reason: "clearance_min: no map was given".

    `called` turns a metric's name into what is printed.
    """
    names: dict[str, list[str]] = {}
    for metric in outcome.metrics.values():
        if not metric.valid:
            names.setdefault(metric.note, []).append(called(metric.name))
    return [f"{', '.join(alike)}: {note}" if note else ", ".join(alike) for note, alike in names.items()]


def _required(margin: Margin) -> Row:
    metric, requirement = margin.metric, margin.requirement
    value, limit = pair(metric.value, requirement.limit, metric.unit, margin.met)
    if metric.unit == "m/s^2":
        limit = text_with_g(requirement.limit, metric.unit)
    comparison = "≤" if requirement.comparison == "<=" else "≥"
    return Row(
        REQUIREMENTS,
        metric.name,
        _with_g(value, metric),
        f"{comparison} {limit}",
        _signed(margin.value, metric.unit),
        *_place(metric),
        margin.met,
        metric.note,
        metric.who,
    )


def _plain(metric: Metric) -> Row:
    value = text(metric.value, metric.unit)
    return Row(
        _group(metric.name), metric.name, _with_g(value, metric), "", "", *_place(metric), None, metric.note, metric.who
    )


def _place(metric: Metric) -> tuple[str, str]:
    """Arc length and time as text, each "" where there is none."""
    at = text(metric.s, "m") if math.isfinite(metric.s) else ""
    return at, text(metric.t, "s") if math.isfinite(metric.t) else ""


def _with_g(value: str, metric: Metric) -> str:
    """The value's text, with g beside it for an acceleration."""
    in_g = text_with_g(metric.value, metric.unit)
    return value + in_g[in_g.index(" (") :] if " (" in in_g and metric.valid else value


def _signed(margin: float, unit: str) -> str:
    return "n/a" if math.isnan(margin) else ("+" if margin > 0.0 else "") + text(margin, unit)


def _group(name: str) -> str:
    return next((group for group, starts in _GROUPS.items() if name.startswith(starts)), OTHER)
