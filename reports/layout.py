"""Where the parts of a figure stand, in inches from its upper left corner."""

from __future__ import annotations

from dataclasses import dataclass

from reports.style import WIDTH

LEFT, RIGHT = 0.72, 0.16  # margins; the labels of y axes stand in the left one
_GAP = 0.80  # between map and near view, for the labels of the latter
_FULL = WIDTH - LEFT - RIGHT
_WIDE = 2.2  # a map wider than this, against its height, takes the full width
_PANEL, _BETWEEN = 0.86, 0.32  # height of a series panel, and the room for its title
_LABELS = 0.44  # under axes, for ticks and label
_TITLE = 0.22  # above axes
_KEY = 0.46  # colour bar and legend under the map
_BOTTOM = 0.06


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle, `left` and `top` its upper left corner."""

    left: float
    top: float
    width: float
    height: float

    @property
    def bottom(self) -> float:
        """Its lower edge."""
        return self.top + self.height


@dataclass(frozen=True, slots=True)
class Layout:
    """Boxes for the map, the view of the worst point, the key, and the series in their order; the figure's height.

    `key_columns` is how many columns the legend has; `lowest` tells which series have nothing below them.
    """

    map: Box
    near: Box
    key: Box
    key_columns: int
    series: tuple[Box, ...]
    height: float

    @property
    def lowest(self) -> tuple[bool, ...]:
        """Whether each series is the last in its column."""
        return tuple(not any(_under(other, box) for other in self.series) for box in self.series)


def layout(aspect: float, count: int, top: float) -> Layout:
    """Place a map of `aspect` (width / height) and `count` series below the header, which ends at `top` [in]."""
    return _wide(aspect, count, top) if aspect > _WIDE else _compact(aspect, count, top)


def _wide(aspect: float, count: int, top: float) -> Layout:
    """The map over the full width; below it the near view, with the key under it, and the series beside."""
    world = Box(LEFT, top, _FULL, min(3.0, max(1.5, _FULL / aspect)))
    below = world.bottom + _LABELS + _TITLE + 0.1
    near = Box(LEFT, below, 2.35, 2.35)
    key = Box(0.2, near.bottom + _LABELS + 0.22, near.width + LEFT - 0.2, 1.0)
    left = LEFT + near.width + _GAP
    series = tuple(Box(left, below + i * (_PANEL + _BETWEEN), WIDTH - RIGHT - left, _PANEL) for i in range(count))
    return Layout(world, near, key, 2, series, max(series[-1].bottom + _LABELS, key.bottom) + _BOTTOM)


def _compact(aspect: float, count: int, top: float) -> Layout:
    """Map and near view side by side, the key under them, then the series two in a row; an odd one has a row alone."""
    height = 3.0
    world = Box(LEFT, top + _TITLE, min(4.0, max(2.7, height * aspect)), height)
    near = Box(LEFT + world.width + _GAP, world.top, _FULL - world.width - _GAP, height)
    key = Box(LEFT, world.bottom + _LABELS + 0.2, _FULL, _KEY)
    half = (_FULL - _GAP) / 2
    series, row = [], key.bottom + _TITLE
    if count % 2:
        series.append(Box(LEFT, row, _FULL, _PANEL))
        row += _PANEL + _BETWEEN
    for i in range(count // 2):
        for left in (LEFT, LEFT + half + _GAP):
            series.append(Box(left, row + i * (_PANEL + _BETWEEN), half, _PANEL))
    return Layout(world, near, key, 4, tuple(series), series[-1].bottom + _LABELS + _BOTTOM)


def _under(lower: Box, upper: Box) -> bool:
    overlaps = lower.left < upper.left + upper.width and upper.left < lower.left + lower.width
    return overlaps and lower.top > upper.top
