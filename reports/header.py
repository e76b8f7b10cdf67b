"""The head of a figure: name, verdict, setting and reason, whatever their lengths."""

from __future__ import annotations

import textwrap

from matplotlib.figure import Figure

from reports.style import FAIL_BADGE, MUTED, PAPER, PASS_BADGE, WIDTH
from reports.words import reason, setting, verdict_words
from tracking.outcome import Outcome

_LEFT, _RIGHT = 0.2, 0.16  # [in]
_LINE = 0.155  # [in] of the reason
_COLUMNS = 112  # characters in a line of the reason
_NAME, _SMALLEST_NAME = 12.5, 8.5  # [pt]


def header_height(outcome: Outcome) -> float:
    """The height of the head [in]."""
    return 0.62 + _LINE * len(_lines(outcome))


def draw_header(figure: Figure, outcome: Outcome) -> None:
    """Draw the head at the top of `figure`."""
    height = figure.get_size_inches()[1]
    good = outcome.verdict.trackworthy
    line = 1.0 - 0.22 / height
    badge = figure.text(
        1.0 - (_RIGHT + 0.06) / WIDTH, line, f"{'✓' if good else '✗'} {verdict_words(outcome)}", color=PAPER,
        fontsize=8.5, fontweight="bold", ha="right", va="center",
        bbox={"boxstyle": "round,pad=0.45", "facecolor": PASS_BADGE if good else FAIL_BADGE, "edgecolor": "none"},
    )  # fmt: skip
    _draw_name(
        figure, " ".join(outcome.name.split()), badge.get_window_extent().x0 / figure.bbox.width - 0.25 / WIDTH, line
    )
    figure.text(_LEFT / WIDTH, 1.0 - 0.45 / height, setting(outcome), color=MUTED, fontsize=8.5, va="center")
    figure.text(
        _LEFT / WIDTH,
        1.0 - 0.56 / height,
        "\n".join(_lines(outcome)),
        fontsize=8.0,
        va="top",
        linespacing=1.35,
    )


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


def _lines(outcome: Outcome) -> list[str]:
    return textwrap.wrap(reason(outcome), _COLUMNS, max_lines=4, placeholder=" …")
