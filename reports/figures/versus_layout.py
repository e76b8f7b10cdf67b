"""What a figure of cases side by side has room for: which metrics, over which ranges, and which groups on a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from campaigns.versus import TRACKWORTHY_SHARE, Group, unit_of
from planners.units import degrees
from reports.figures.ticks import FLOOR, length_unit
from reports.words.quantity import KILO
from reports.words.versus_words import Family

MOST_ROWS = 32  # of a page
MOST_COLUMNS = 3
_HEAD_ROWS = 2  # what a group's name is worth
_HUGE = 30.0  # the largest value against the smallest, from which an axis is logarithmic
_EFFORT = ("bank_max", "lateral_acceleration_max")
# Which metrics have a column, the first that there are
_SHOWN = {
    "controller": ("cross_track_p95", *_EFFORT, "completion", "cross_track_max", "clearance_min", "track_length"),
    "planner": ("cross_track_p95", "clearance_min", "track_length", "separation_min", "completion", *_EFFORT),
    "vehicle": ("cross_track_p95", "clearance_min", "completion", *_EFFORT, "track_length"),
}


@dataclass(frozen=True, slots=True)
class Column:
    """The axis of a metric, from `low` to `high` in `unit`; SI values are multiplied by `factor`."""

    metric: str
    factor: float
    unit: str
    low: float
    high: float
    logarithmic: bool


def columns(groups: Sequence[Group]) -> list[Column]:
    """The metrics shown of `groups`, those first that differ at all."""
    there = {metric for group in groups for metric in group.metrics if metric != TRACKWORTHY_SHARE}
    shown = [metric for metric in _SHOWN[groups[0].dimension] if metric in there]
    chosen = sorted(shown, key=lambda metric: not _differs(groups, metric))[:MOST_COLUMNS]
    return [_column(groups, metric) for metric in chosen]


def pages(family: Family) -> list[Family]:
    """The family in parts that fit on a page each; where a group does not, its `reference` may be on another part."""
    blocks = [block for one in zip(family.groups, family.names, strict=True) for block in _split(*one)]
    parts: list[list[tuple[Group, str]]] = [[]]
    for group, name in blocks:
        used = sum(len(one.members) + _HEAD_ROWS for one, _ in parts[-1])
        if parts[-1] and used + len(group.members) + _HEAD_ROWS > MOST_ROWS:
            parts.append([])
        parts[-1].append((group, name))
    return [
        replace(family, groups=tuple(group for group, _ in part), names=tuple(name for _, name in part))
        for part in parts
    ]


def _split(group: Group, name: str) -> list[tuple[Group, str]]:
    """A group, in pieces where it has more members than a page has rows."""
    most = MOST_ROWS - _HEAD_ROWS
    starts = range(0, len(group.members), most)
    return [
        (
            replace(group, members=group.members[start : start + most], reference=group.reference - start),
            f"{name} ({i} of {len(starts)})".strip() if len(starts) > 1 else name,
        )
        for i, start in enumerate(starts, start=1)
    ]


def _differs(groups: Sequence[Group], metric: str) -> bool:
    found = {(one.p5, one.p95) for group in groups for m in group.members if (one := m.spreads.get(metric))}
    return len(found) > 1


def _column(groups: Sequence[Group], metric: str) -> Column:
    members = [member for group in groups for member in group.members if metric in member.spreads]
    spreads = [member.spreads[metric] for member in members]
    factor, unit = _shown(unit_of(members[0].result, metric)[0], max(abs(one.p95) for one in spreads))
    low, high = factor * min(one.p5 for one in spreads), factor * max(one.p95 for one in spreads)
    if low > 0.0 and high / low > _HUGE:
        low = max(low, high / FLOOR)
        return Column(metric, factor, unit, low / 1.3, high * 1.3, True)
    room = 0.06 * (high - low) or 0.05 * abs(high) or 1.0
    start = 0.0 if 0.0 <= low < 0.5 * high else low - room
    end = min(high + room, 100.0) if unit == "%" and high <= 100.0 else high + room
    return Column(metric, factor, unit, start, end, False)


def _shown(unit: str, largest: float) -> tuple[float, str]:
    """What values in the SI `unit` are multiplied by to be shown, and the unit then."""
    if unit == "share":
        return 100.0, "%"
    if unit == "m" and length_unit(largest)[0] > 1.0:
        return 1.0 / KILO, "km"
    factor, name = degrees(1.0, unit)
    return factor, "" if name == "1" else name.replace("deg", "°").replace("^2", "²")
