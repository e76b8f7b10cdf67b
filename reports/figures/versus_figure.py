"""The picture of cases side by side: a row for each controller or planner, a column for each metric."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from campaigns.difference import BETTER, WORSE
from campaigns.versus import Group
from reports.figures.style import BLUE, INK, LIMIT, MUTED, PASS_BADGE, VERMILION, WIDTH, Look, new_figure, place
from reports.figures.ticks import BROAD, ticks
from reports.figures.versus_layout import Column, columns
from reports.words.names import listed
from reports.words.quantity import number
from reports.words.versus_words import Family, share_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LEFT, _NAMES, _GAP, _RIGHT = 0.14, 1.45, 0.22, 0.12  # [in]
_SHARES, _ANSWERS = 1.25, 0.62  # [in] of the last column: "18 of 20 (68 to 99 %)", "yes"
_ABOVE, _LINE, _TITLE, _AXIS, _ROW, _HEAD, _KEY = 0.33, 0.15, 0.14, 0.46, 0.22, 0.26, 0.22  # [in] heights
_UNNAMED = 0.08  # [in] above a group that needs no name
_LETTERS, _ABOUT = 20, 118  # of a row's name, of a line below the title
_DECADE = 0.42  # [in] between the ticks of a logarithmic axis
_DASHES = (0, (5, 2))
_REFERENCE, _ALIKE = "reference", "alike"
# The marks, told apart by their shapes as well
_MARKS: dict[str, Look] = {
    _REFERENCE: {"marker": "s", "color": BLUE, "markerfacecolor": BLUE},
    BETTER: {"marker": "D", "color": PASS_BADGE, "markerfacecolor": PASS_BADGE},
    WORSE: {"marker": "o", "color": VERMILION, "markerfacecolor": "white"},
    _ALIKE: {"marker": "o", "color": INK, "markerfacecolor": INK},
}
_KEYS = {
    _REFERENCE: "best of its group, the reference",
    BETTER: "better",
    WORSE: "worse",
    _ALIKE: "no difference that counts, or no direction",
}


def head_of(family: Family) -> float:
    """The height of the title and what stands below it [in], which a page may say itself."""
    return _ABOVE + _LINE * len(_about(family))


def versus_figure(family: Family) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    shown = columns(family.groups)
    about, start = _about(family), _TITLE + head_of(family)
    blocks = list(zip(family.groups, family.names, strict=True))
    tall = sum(_head(name) + _ROW * len(group.members) for group, name in blocks)
    figure = new_figure(start + tall + _AXIS + _KEY)
    _write(figure, _LEFT, 0.18, _cut(family.title, 90), fontsize=11, fontweight="bold")
    for i, line in enumerate(about):
        _write(figure, _LEFT, 0.4 + i * _LINE, line, color=MUTED, fontsize=8)
    _write(figure, WIDTH - _RIGHT, start - 0.02, "trackworthy", color=MUTED, fontsize=8, ha="right")
    top = start
    for group, name in blocks:
        _write(figure, _LEFT, top + 0.17, _cut(name, 120), fontsize=8, fontweight="bold")
        top += _head(name)
        _draw_rows(figure, group, top)
        lowest = group is family.groups[-1]
        _draw_columns(figure, group, shown, top, _last_column(family.groups), lowest)
        top += _ROW * len(group.members)
    _draw_key(figure, family.groups, shown)
    return figure


def _draw_rows(figure: Figure, group: Group, top: float) -> None:
    """The names of the rows, and how many of their trials are trackworthy."""
    for i, member in enumerate(group.members):
        y = top + (i + 0.5) * _ROW
        weight = "bold" if i == group.reference else "normal"
        _write(figure, _NAMES - 0.08, y, _cut(member.label, _LETTERS), fontsize=7.5, fontweight=weight, ha="right")
        _write(figure, WIDTH - _RIGHT, y, share_text(member.result), fontsize=7, ha="right")


def _draw_columns(figure: Figure, group: Group, shown: Sequence[Column], top: float, last: float, lowest: bool) -> None:
    """The values of a group, each metric in axes of its own, the `lowest` with ticks and names; `last` [in] wide is
    what stands on the right.
    """
    width = (WIDTH - _NAMES - last - _RIGHT - _GAP * len(shown)) / max(1, len(shown))
    for i, column in enumerate(shown):
        axes = place(figure, _NAMES + i * (width + _GAP), top, width, _ROW * len(group.members))
        _scale(axes, column, width)
        axes.set_ylim(len(group.members) - 0.5, -0.5)
        axes.set_yticks(range(len(group.members)), labels=[""] * len(group.members))
        axes.tick_params(axis="y", length=0)
        axes.tick_params(axis="x", labelbottom=lowest)
        limit = _corridor(group, column)
        if limit is not None:
            axes.axvline(limit, color=LIMIT, linewidth=0.9, linestyle=_DASHES, zorder=1.5)
        for row in range(len(group.members)):
            _draw_value(axes, group, row, column)
        if lowest:
            told = f"[{column.unit}]" if column.unit else ""
            axes.set_xlabel(f"{listed(column.metric)} {told}{', log' if column.logarithmic else ''}", fontsize=7)


def _scale(axes: Axes, column: Column, width: float) -> None:
    if column.logarithmic:
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator(numticks=max(3, int(width / _DECADE))))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: number(value, 3)))
        axes.xaxis.set_minor_locator(NullLocator())
    else:
        ticks(axes.xaxis, width / BROAD)
    axes.set_xlim(column.low, column.high)


def _draw_value(axes: Axes, group: Group, row: int, column: Column) -> None:
    """Where 90 % of the trials are, and their median."""
    spread = group.members[row].spreads.get(column.metric)
    if spread is None:
        axes.annotate("n/a", (0.02, row), xycoords=("axes fraction", "data"), va="center", color=MUTED, fontsize=7)
        return
    look = _MARKS[_kind(group, row, column.metric)]
    values = (column.factor * value for value in (spread.p5, spread.median, spread.p95))
    low, median, high = (max(column.low, value) for value in values)
    axes.plot([low, high], [row, row], color=look["color"], linewidth=1.6, zorder=3)
    axes.plot(median, row, markersize=5, markeredgewidth=1.2, linestyle="none", zorder=4, clip_on=False, **look)


def _draw_key(figure: Figure, groups: Sequence[Group], shown: Sequence[Column]) -> None:
    """What the marks mean, at the foot: those that occur."""
    there = {_kind(group, i, one.metric) for group in groups for i in range(len(group.members)) for one in shown}
    handles = [
        Line2D([], [], linestyle="none", markersize=5, markeredgewidth=1.2, label=_KEYS[kind], **look)
        for kind, look in _MARKS.items()
        if kind in there
    ]
    if any(one.count > 1 for group in groups for member in group.members for one in member.spreads.values()):
        handles.append(Line2D([], [], color=INK, linewidth=1.6, label="90 % of trials, mark: median"))
    if any(_corridor(group, one) is not None for group in groups for one in shown):
        handles.append(Line2D([], [], color=LIMIT, linewidth=0.9, linestyle=_DASHES, label="corridor"))
    figure.legend(
        handles=handles, loc="lower center", bbox_to_anchor=(0.5, 0.03 / figure.get_size_inches()[1]),
        ncols=len(handles), fontsize=7, borderaxespad=0.0, borderpad=0.0, handlelength=1.2, columnspacing=1.3,
        handletextpad=0.5,
    )  # fmt: skip


def _kind(group: Group, row: int, metric: str) -> str:
    """Which mark a value has."""
    if row == group.reference:
        return _REFERENCE
    one = group.members[row].differences.get(metric)
    return one.outcome if one and one.outcome in (BETTER, WORSE) else _ALIKE


def _corridor(group: Group, column: Column) -> float | None:
    """Its half-width [m] where a cross-track error's axis reaches it, and all of the group have the same."""
    found = {member.result.case.corridor for member in group.members}
    limit = found.pop() if len(found) == 1 and column.metric.startswith("cross_track") else None
    if not isinstance(limit, float):
        return None
    return column.factor * limit if column.low < column.factor * limit < column.high else None


def _last_column(groups: Sequence[Group]) -> float:
    several = any(member.result.statistics.tried > 1 for group in groups for member in group.members)
    return _SHARES if several else _ANSWERS


def _about(family: Family) -> list[str]:
    """Broken between the settings, not within."""
    kept = family.about.replace(" ", "\N{NO-BREAK SPACE}").replace("\N{NO-BREAK SPACE}·\N{NO-BREAK SPACE}", " · ")
    return textwrap.wrap(kept, _ABOUT, max_lines=2, placeholder=" …")


def _head(name: str) -> float:
    return _HEAD if name else _UNNAMED


def _write(figure: Figure, x: float, y: float, words: str, **look: object) -> None:
    """Words at inches from the left and from the top."""
    text = figure.text(x / WIDTH, 1.0 - y / figure.get_size_inches()[1], words, va="center")
    text.set(**look)


def _cut(words: str, most: int) -> str:
    """In one line, cut in the middle."""
    words = " ".join(words.split())
    half = (most - 1) // 2
    return words if len(words) <= most else f"{words[:half]}…{words[-half:]}"
