"""Where the parts of a scenario's figure stand, in inches from its upper left corner."""

from __future__ import annotations

from dataclasses import dataclass

from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.style import WIDTH

MOST_SHARES = 6  # maps of one source each
_FULL = WIDTH - LEFT - RIGHT
_GAP, _SMALL_GAP = 0.80, 0.52  # between maps side by side, for the labels of the right ones
_LABELS, _TITLE, _CAPTION, _BOTTOM = 0.44, 0.16, 0.40, 0.06  # under axes, and above them
_TICKS = 0.22  # under axes with others below
_ROW = 0.165  # of the legend
_LOWEST, _HIGHEST, _NEAR = 1.5, 3.3, 2.3  # heights of the map, and the least width of the near view
_WIDE = 2.4  # a map wider than this, against its height, has the near view below it
_SHARES, _FLAT = 3, 1.3  # maps of one source side by side; four of flatter ones stand in a square
_SHARE_HIGHEST = (2.6, 1.7)  # of one row of them, and of two


@dataclass(frozen=True, slots=True)
class ScenarioLayout:
    """Boxes for the map, the view of its worst place, and the maps of one source each; the figure's height.

    The legend begins at `key` from the top.
    """

    map: Box
    near: Box | None
    shares: tuple[Box, ...]
    key: float
    height: float


def scenario_layout(aspect: float, top: float, near: bool, shares: int, rows: int) -> ScenarioLayout:
    """Place a map of `aspect` (width / height) below `top` [in], a `near` view or none, `shares` maps of one source,
    and a legend of `rows`.
    """
    world, close = _maps(aspect, top + _CAPTION, near)
    key = max(world.bottom, close.bottom if close else 0.0) + _LABELS + 0.08
    below = key + rows * _ROW + 0.1
    small = _small(aspect, below + _CAPTION, shares)
    bottom = small[-1].bottom + _LABELS if small else below - 0.1
    return ScenarioLayout(world, close, small, key, bottom + _BOTTOM)


def _maps(aspect: float, top: float, near: bool) -> tuple[Box, Box | None]:
    if not near:
        return Box(LEFT, top, _FULL, min(_HIGHEST, max(_LOWEST, _FULL / aspect))), None
    if aspect > _WIDE:
        world = Box(LEFT, top, _FULL, min(_HIGHEST, max(_LOWEST, _FULL / aspect)))
        return world, Box(LEFT, world.bottom + _LABELS + _CAPTION, _FULL, 1.7)
    room = _FULL - _GAP
    width = min(room - _NEAR, max(0.45 * room, _HIGHEST * aspect))
    high = min(_HIGHEST, max(2.2, width / aspect))
    return Box(LEFT, top, width, high), Box(LEFT + width + _GAP, top, room - width, high)


def _small(aspect: float, top: float, count: int) -> tuple[Box, ...]:
    columns = (2 if aspect > _FLAT else 4) if count == 4 else min(_SHARES, count) or 1
    rows = -(-count // columns)
    width = (_FULL - (columns - 1) * _SMALL_GAP) / columns
    high = min(_SHARE_HIGHEST[rows > 1], max(0.8, width / aspect))
    wide = min(width, high * max(aspect, 0.8))
    step = high + _TICKS + _CAPTION
    return tuple(
        Box(LEFT + (i % columns) * (width + _SMALL_GAP), top + (i // columns) * step, wide, high) for i in range(count)
    )
