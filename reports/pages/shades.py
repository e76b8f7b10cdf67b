"""A diverging scale for margins, told apart by every kind of colour vision: blue is good, vermilion is bad."""

from __future__ import annotations

import math

from reports.figures.style import BLUE, FAIL_BADGE, INK, PAPER

_FAINTEST = 0.18  # of a margin of nothing, so that it still has a side
_DARK = 0.55  # beyond it type is white


def shade(share: float, good: bool) -> tuple[str, str]:
    """Fill and type colour for a margin of `share` of its limit, clipped to 100 %; `good` says on which side it is.

    A case may be good although its worst trial is not, or the other way round: that is the faintest of its side.
    """
    size = 1.0 if math.isnan(share) else min(max(share if good else -share, 0.0), 1.0)
    strength = _FAINTEST + (1.0 - _FAINTEST) * math.sqrt(size)
    end = BLUE if good else FAIL_BADGE
    return _mixed(PAPER, end, strength), PAPER if strength > _DARK else INK


def _mixed(start: str, end: str, share: float) -> str:
    pairs = [(int(start[i : i + 2], 16), int(end[i : i + 2], 16)) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)
