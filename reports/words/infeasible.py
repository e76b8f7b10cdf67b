"""What the plan asks and the vehicle cannot do, as rows of text: the same in the terminal and in the PDF."""

from __future__ import annotations

import math
from dataclasses import dataclass

from reports.words.quantity import span, text
from tracking.feasibility import Feasibility, Slope, Stretch


@dataclass(frozen=True, slots=True)
class TightRow:
    """A turn too tight: `where` along the path, by how much it `turn`s, and the radii that it needs and offers."""

    where: str
    turn: str
    required: str
    available: str
    missing: str


@dataclass(frozen=True, slots=True)
class SteepRow:
    """A leg too steep: `where` along the path, its gradient and the vehicle's."""

    where: str
    gradient: str
    limit: str
    missing: str


def tight_rows(feasibility: Feasibility, most: int) -> list[TightRow]:
    """The worst stretches, `most` at the most, in the order of the path."""
    worst = sorted(feasibility.stretches, key=lambda stretch: stretch.worst.margin)[:most]
    return [_tight(feasibility, stretch) for stretch in sorted(worst, key=lambda stretch: stretch.s)]


def steep_rows(feasibility: Feasibility, most: int) -> list[SteepRow]:
    """The worst legs, `most` at the most, in the order of the path."""
    worst = sorted(feasibility.steep, key=_excess, reverse=True)[:most]
    return [_steep(slope) for slope in sorted(worst, key=lambda slope: slope.s)]


def turned(feasibility: Feasibility, stretch: Stretch) -> tuple[float, float]:
    """How far `stretch` turns to the left and to the right, both positive [rad]."""
    angles = [turn.angle for turn in feasibility.turns if stretch.s <= turn.s <= stretch.s_end]
    return sum(angle for angle in angles if angle > 0.0), -sum(angle for angle in angles if angle < 0.0)


def _tight(feasibility: Feasibility, stretch: Stretch) -> TightRow:
    left, right = turned(feasibility, stretch)
    side = "both ways" if left > 0.0 and right > 0.0 else "left" if left > 0.0 else "right"
    worst = stretch.worst
    whole = text(left + right, "rad")
    to_and_fro = left > 0.0 and right > 0.0 and left + right > 2.0 * math.pi  # as a staircase does
    return TightRow(
        span(stretch.s, stretch.s_end, "m"),
        f"{whole} to and fro" if to_and_fro else f"{whole} {side}",
        text(worst.required, "m"),
        text(worst.available, "m"),
        text(-worst.margin, "m"),
    )


def _steep(slope: Slope) -> SteepRow:
    limit = math.copysign(slope.limit, slope.gradient)
    return SteepRow(
        span(slope.s, slope.s_end, "m"),
        text(slope.gradient, "share"),
        text(limit, "share"),
        text(_excess(slope), "share"),
    )


def _excess(slope: Slope) -> float:
    return abs(slope.gradient) - abs(slope.limit)
