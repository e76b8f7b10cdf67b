"""What the marks on a map mean."""

from __future__ import annotations

from matplotlib.lines import Line2D

from reports.figures.focus import Focus
from reports.figures.style import CORRIDOR, DASHES, FENCE, FENCE_DASHES, INK, MARK, MUTED, PAPER, TIGHT, Look
from reports.words.quantity import text
from tracking.outcome import Outcome


def legend_entries(outcome: Outcome, marked: Focus | None, near_only: bool = False) -> list[Line2D]:
    """One entry for every kind of mark that the map of `outcome` has; `near_only` for the view of the marked point."""
    looks: list[Look] = [
        {"label": "planned", "color": INK, "linewidth": 1.0, "linestyle": DASHES},
        {"label": f"corridor ± {text(outcome.corridor, 'm')}", "color": CORRIDOR, "linewidth": 5.0, "alpha": 0.4},
    ]
    if not near_only:
        looks += [mark_look("start", "o", 6.0, INK, PAPER), mark_look("goal", "s", 6.0, INK, PAPER)]
    if marked is not None:
        ring = mark_look(marked.title.lower(), "o", 8.0, "none", MARK[marked.alarm])
        looks.append({**ring, "markeredgewidth": 1.6})
    if outcome.feasibility.tight:
        bar: Look = {"linestyle": "-", "linewidth": 5.0, "color": TIGHT, "solid_capstyle": "butt"}
        looks.append({**mark_look("turn too tight", "v", 6.0, TIGHT, INK), **bar})
    area = None if near_only else outcome.obstacles
    if area is not None and (area.keep_in or area.keep_in_circles):
        looks.append({"label": "fence", "color": FENCE, "linewidth": 1.4, "linestyle": FENCE_DASHES})
    if area is not None and area.bounds is not None:
        looks.append({"label": "map edge", "color": MUTED, "linewidth": 1.2})
    return [Line2D([], [], **look) for look in looks]


def mark_look(label: str, shape: object, size: float, face: str, edge: str) -> Look:
    """A single mark, for a legend or a map."""
    return {
        "label": label, "marker": shape, "markersize": size, "markerfacecolor": face, "markeredgecolor": edge,
        "markeredgewidth": 0.8, "linestyle": "none",
    }  # fmt: skip
