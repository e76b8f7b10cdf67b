"""The head of a figure: name, verdict, setting and reason, whatever their lengths."""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

from matplotlib.figure import Figure

from reports.figures.style import FAIL_BADGE, MUTED, PAPER, PASS_BADGE, WIDTH
from reports.words.words import planet_words, reason, setting, verdict_words
from tracking.outcome import Outcome

_LEFT, _RIGHT = 0.2, 0.16  # [in]
_LINE = 0.155  # [in] of the reason
_COLUMNS = 112  # characters in a line of the reason
_NAME, _SMALLEST_NAME = 12.5, 8.5  # [pt]


@dataclass(frozen=True, slots=True)
class Head:
    """What is said above a figure; `good` colours the verdict."""

    name: str
    good: bool
    verdict: str
    setting: str
    reason: str


def head_of(outcome: Outcome, trial: str = "", member: str = "") -> Head:
    """The head of one run; `trial` says which of several it is, `member` which vehicle of a fleet is shown."""
    parts = [which for which in (trial, member) if which]
    return Head(
        outcome.name,
        outcome.verdict.trackworthy,
        verdict_words(outcome),
        " · ".join([*parts, setting(outcome), *planet_words(outcome)]),
        reason(outcome),
    )


def header_height(head: Head) -> float:
    """The height of the head [in]."""
    return 0.62 + _LINE * len(_lines(head))


def draw_header(figure: Figure, head: Head) -> None:
    """Draw the head at the top of `figure`."""
    height = figure.get_size_inches()[1]
    line = 1.0 - 0.22 / height
    badge = figure.text(
        1.0 - (_RIGHT + 0.06) / WIDTH, line, f"{'✓' if head.good else '✗'} {head.verdict}", color=PAPER,
        fontsize=8.5, fontweight="bold", ha="right", va="center",
        bbox={"boxstyle": "round,pad=0.45", "facecolor": PASS_BADGE if head.good else FAIL_BADGE, "edgecolor": "none"},
    )  # fmt: skip
    room = badge.get_window_extent().x0 / figure.bbox.width - 0.25 / WIDTH
    _draw_name(figure, " ".join(head.name.split()), room, line)
    figure.text(_LEFT / WIDTH, 1.0 - 0.45 / height, head.setting, color=MUTED, fontsize=8.5, va="center")
    figure.text(_LEFT / WIDTH, 1.0 - 0.56 / height, "\n".join(_lines(head)), fontsize=8.0, va="top", linespacing=1.35)


def _draw_name(figure: Figure, name: str, room: float, y: float) -> None:
    """The name in bold, smaller and at last cut in the middle, so that it ends before `room`, a share of the width."""
    text = figure.text(_LEFT / WIDTH, y, name, fontsize=_NAME, fontweight="bold", va="center")
    left, right = (edge / figure.bbox.width for edge in text.get_window_extent().intervalx)
    if right <= room:
        return
    text.set_fontsize(max(_SMALLEST_NAME, _NAME * (room - left) / (right - left)))
    kept = len(name)
    while text.get_window_extent().x1 / figure.bbox.width > room and kept > 8:
        kept -= 2
        text.set_text(f"{name[: kept // 2]}…{name[-(kept // 2) :]}")


def _lines(head: Head) -> list[str]:
    return textwrap.wrap(head.reason, _COLUMNS, max_lines=4, placeholder=" …")
