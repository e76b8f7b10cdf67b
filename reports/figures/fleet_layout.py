"""Where the parts of a fleet's figure stand, in inches from its upper left corner."""

from __future__ import annotations

from dataclasses import dataclass

from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.style import WIDTH

_FULL = WIDTH - LEFT - RIGHT
_LABELS, _TITLE, _KEY, _BOTTOM = 0.44, 0.24, 0.26, 0.06  # under and above axes, legend of the map, margin
_GAP, _BETWEEN = 0.72, 0.22  # between columns; between errors, which share an axis and have a title each
_MAP, _LOWEST, _HIGHEST = 3.75, 2.2, 4.0  # width of the map, and its height
_PAGE_MAP, _PAGE_LOWEST = 2.9, 2.2
_SEPARATION, _PAGE_SEPARATION = 1.45, 0.85


@dataclass(frozen=True, slots=True)
class FleetLayout:
    """Boxes for the map, for the error of each aircraft shown, and for the separations; the figure's height.

    The legend of the map begins at `key` from the top.
    """

    map: Box
    errors: tuple[Box, ...]
    separation: Box
    key: float
    height: float


def fleet_layout(aspect: float, count: int, top: float) -> FleetLayout:
    """Place a map of `aspect` (width / height), `count` errors beside it and the separations below both, from `top`."""
    high = min(_HIGHEST, max(_LOWEST, _MAP / aspect))
    world = Box(LEFT, top + _TITLE, _MAP, high)
    left = LEFT + _MAP + _GAP
    errors = _stacked(Box(left, world.top, WIDTH - RIGHT - left, high), count)
    key = world.bottom + _LABELS
    separation = Box(LEFT, key + _KEY + _TITLE + 0.06, _FULL, _SEPARATION)
    return FleetLayout(world, errors, separation, key, separation.bottom + _LABELS + _BOTTOM)


def fleet_page_layout(aspect: float, count: int, top: float) -> FleetLayout:
    """As low as can be read: the separations stand beside the map too, under the errors."""
    high = max(_PAGE_LOWEST, min(_PAGE_MAP, 1.3 * _PAGE_MAP / aspect))
    world = Box(LEFT, top + _TITLE, min(1.3 * _PAGE_MAP, max(0.9 * _PAGE_MAP, high * aspect)), high)
    left = LEFT + world.width + _GAP
    right = Box(left, world.top, WIDTH - RIGHT - left, high)
    separation = Box(left, right.bottom - _PAGE_SEPARATION, right.width, _PAGE_SEPARATION)
    above = separation.top - _TITLE - _LABELS
    errors = _stacked(Box(left, right.top, right.width, above - right.top), count)
    key = world.bottom + _LABELS
    return FleetLayout(world, errors, separation, key, key + _KEY + _BOTTOM)


def _stacked(room: Box, count: int) -> tuple[Box, ...]:
    """`count` boxes of the same height, one below the other."""
    high = (room.height - (count - 1) * _BETWEEN) / count
    return tuple(Box(room.left, room.top + i * (high + _BETWEEN), room.width, high) for i in range(count))
