"""The picture of cases side by side: a row for each controller or planner, a column for each metric."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from campaigns.difference import BETTER, UNLIKE, WORSE
from campaigns.versus import TRACKWORTHY_SHARE, Group, Member, unit_of
from planners.units import degrees
from reports.names import listed
from reports.quantity import number
from reports.style import BLUE, INK, LIMIT, MUTED, PASS_BADGE, VERMILION, WIDTH, Look, new_figure, place, save, style
from reports.ticks import BROAD, ticks
from reports.versus_words import Family, share_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_ROWS = 32  # of a page, a block's head being worth two
MOST_METRICS = 3
_SHOWN = (  # which metrics have a column, the first there are
    "cross_track_p95", "clearance_min", "separation_min", "completion", "track_length", "bank_max",
    "lateral_acceleration_max", "cross_track_max",
)  # fmt: skip
_NAMES, _SHARES, _GAP, _RIGHT = 1.45, 1.25, 0.22, 0.12  # [in]
_TITLE, _AXIS, _ROW, _HEAD, _KEY = 0.62, 0.46, 0.22, 0.26, 0.22  # [in] heights
_LONGEST = 22  # characters of a name
_HUGE = 30.0  # the largest value against the smallest, from which an axis is logarithmic
_REFERENCE, _ALIKE = "reference", "alike"
# The marks, told apart by shape as well: as matplotlib draws them
_MARKS: dict[str, Look] = {
    _REFERENCE: {"marker": "s", "color": BLUE, "markerfacecolor": BLUE},
    BETTER: {"marker": "D", "color": PASS_BADGE, "markerfacecolor": PASS_BADGE},
    WORSE: {"marker": "o", "color": VERMILION, "markerfacecolor": "white"},
    _ALIKE: {"marker": "o", "color": INK, "markerfacecolor": INK},
}
_KEYS = {
    _REFERENCE: "best of its group, the reference", BETTER: "better", WORSE: "worse",
    _ALIKE: "no difference that counts, or no direction",
}  # fmt: skip


def save_versus_figure(family: Family, file: str | Path) -> None:
    """Write the picture of a family, one that `pages` gives, as PNG or SVG, by the suffix of `file`.

    The same family gives the same bytes. Raises `InputError` where the folder does not exist.
    """
    with style():
        save(versus_figure(family), file)


def pages(family: Family) -> list[Family]:
    """The family in parts that fit on a page each; a group with more members than that stays whole."""
    parts: list[list[int]] = [[]]
    used = 0
    for i, group in enumerate(family.groups):
        rows = len(group.members) + 2
        if parts[-1] and used + rows > MOST_ROWS:
            parts.append([])
            used = 0
        parts[-1].append(i)
        used += rows
    return [
        Family(family.title, family.about, tuple(family.groups[i] for i in part), tuple(family.names[i] for i in part))
        for part in parts
    ]


def versus_figure(family: Family) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    metrics = shown_metrics(family.groups)
    heights = [(_HEAD if name else 0.08) + _ROW * len(group.members) for group, name in _blocks(family)]
    figure = new_figure(_TITLE + sum(heights) + _AXIS + _KEY)
    height = figure.get_size_inches()[1]

    def write(x: float, y: float, words: str, **look: object) -> None:
        figure.text(x / WIDTH, 1.0 - y / height, words, va="center", **look)  # type: ignore[arg-type]

    write(0.14, 0.18, _cut(family.title, 90), fontsize=11, fontweight="bold")
    write(0.14, 0.4, _cut(family.about, 130), color=MUTED, fontsize=8.5)
    width = (WIDTH - _NAMES - _SHARES - _RIGHT - _GAP * len(metrics)) / max(1, len(metrics))
    boxes = [_NAMES + i * (width + _GAP) for i in range(len(metrics))]
    write(WIDTH - _RIGHT, _TITLE - 0.02, "trackworthy", ha="right", fontsize=8, color=MUTED)
    ranges = [_range(family.groups, metric) for metric in metrics]
    top = _TITLE
    for (group, name), tall in zip(_blocks(family), heights, strict=True):
        head = _HEAD if name else 0.08
        if name:
            write(0.14, top + 0.17, _cut(name, 120), fontsize=8, fontweight="bold")
        rows = tall - head
        for i, member in enumerate(group.members):
            y = top + head + (i + 0.5) * _ROW
            bold = "bold" if i == group.reference else "normal"
            write(_NAMES - 0.08, y, _cut(member.label), ha="right", fontsize=7.5, fontweight=bold)
            write(WIDTH - _RIGHT, y, share_text(member.result), ha="right", fontsize=7)
        last = top + tall >= _TITLE + sum(heights) - 1e-9
        for metric, left, ends in zip(metrics, boxes, ranges, strict=True):
            axes = place(figure, left, top + head, width, rows)
            _draw(axes, group, metric, ends, width, last)
        top += tall
    _legend(figure, family, height)
    return figure


def shown_metrics(groups: Sequence[Group]) -> list[str]:
    """The metrics that have a column, of those that any group compares."""
    there = {metric for group in groups for metric in group.metrics if metric != TRACKWORTHY_SHARE}
    telling = [metric for metric in _SHOWN if metric in there and _tells(groups, metric)]
    rest = [metric for metric in _SHOWN if metric in there and metric not in telling]
    return (telling + rest)[:MOST_METRICS]


def _tells(groups: Sequence[Group], metric: str) -> bool:
    """Whether any two values of it differ."""
    found = {(one.p5, one.p95) for group in groups for m in group.members if (one := m.spreads.get(metric))}
    return len(found) > 1


def _blocks(family: Family) -> list[tuple[Group, str]]:
    return list(zip(family.groups, family.names, strict=True))


def _range(groups: Sequence[Group], metric: str) -> tuple[float, float, bool]:
    """From the lowest to the highest value in the shown unit, with a margin, and whether it is logarithmic."""
    spreads = [m.spreads[metric] for group in groups for m in group.members if metric in m.spreads]
    factor = _unit(groups[0].members, metric)[0]
    low, high = factor * min(one.p5 for one in spreads), factor * max(one.p95 for one in spreads)
    if low > 0.0 and high / low > _HUGE:
        return low / 1.3, high * 1.3, True
    room = 0.06 * (high - low) or 0.05 * abs(high) or 1.0
    start = 0.0 if 0.0 <= low < 0.5 * high else low - room
    return start, high + room, False


def _draw(axes: Axes, group: Group, metric: str, ends: tuple[float, float, bool], width: float, last: bool) -> None:
    """The values of one metric in one group, the names of its rows standing beside."""
    low, high, logarithmic = ends
    factor, unit = _unit(group.members, metric)
    if logarithmic:
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator(numticks=5))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: number(value, 3)))
        axes.xaxis.set_minor_locator(NullLocator())
    else:
        ticks(axes.xaxis, width / BROAD)
    axes.set_xlim(low, high)
    axes.set_ylim(len(group.members) - 0.5, -0.5)
    axes.set_yticks(range(len(group.members)), labels=[""] * len(group.members))
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", labelbottom=last)
    corridor = {member.result.case.corridor for member in group.members}
    limit = next(iter(corridor)) if metric.startswith("cross_track") and len(corridor) == 1 else None
    if isinstance(limit, float) and low < limit < high:
        axes.axvline(limit, color=LIMIT, linewidth=0.9, linestyle=(0, (5, 2)), zorder=1.5)
    for row, member in enumerate(group.members):
        spread = member.spreads.get(metric)
        if spread is None:
            axes.annotate("n/a", (0.02, row), xycoords=("axes fraction", "data"), va="center", color=MUTED, fontsize=7)
            continue
        look = _MARKS[_kind(group, row, metric)]
        axes.plot([factor * spread.p5, factor * spread.p95], [row, row], color=look["color"], linewidth=1.6, zorder=3)
        axes.plot(factor * spread.median, row, markersize=5, markeredgewidth=1.2, linestyle="none", zorder=4, **look)
    if last:
        scale = ", log" if logarithmic else ""
        axes.set_xlabel(f"{listed(metric)}{f' [{unit}]' if unit else ''}{scale}", fontsize=7.5)


def _kind(group: Group, row: int, metric: str) -> str:
    if row == group.reference:
        return _REFERENCE
    one = group.members[row].differences.get(metric)
    return one.outcome if one and one.outcome in UNLIKE and one.outcome in _MARKS else _ALIKE


def _legend(figure: Figure, family: Family, height: float) -> None:
    """What the marks mean, at the foot."""
    several = any(one.count > 1 for g in family.groups for m in g.members for one in m.spreads.values())
    handles = [
        Line2D([], [], linestyle="none", markersize=5, markeredgewidth=1.2, label=_KEYS[kind], **look)
        for kind, look in _MARKS.items()
    ]
    if several:
        handles.append(Line2D([], [], color=INK, linewidth=1.6, label="median; 90 % of trials"))
    figure.legend(
        handles=handles, loc="lower center", bbox_to_anchor=(0.5, 0.02 / height), ncols=len(handles), fontsize=7,
        borderaxespad=0.0, borderpad=0.0, handlelength=1.2, columnspacing=1.4, handletextpad=0.5,
    )  # fmt: skip


def _unit(members: Sequence[Member], metric: str) -> tuple[float, str]:
    """What SI values are multiplied by to be shown, and the unit then."""
    unit = next(unit_of(member.result, metric)[0] for member in members if metric in member.spreads)
    if unit == "share":
        return 100.0, "%"
    factor, name = degrees(1.0, unit)
    return factor, "" if name == "1" else name.replace("deg", "°").replace("^2", "²")


def _cut(words: str, most: int = _LONGEST) -> str:
    """In one line, cut in the middle."""
    words = " ".join(words.split())
    half = (most - 1) // 2
    return words if len(words) <= most else f"{words[:half]}…{words[-half:]}"
