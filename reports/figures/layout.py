"""Where the parts of a figure stand, in inches from its upper left corner."""

from __future__ import annotations

from dataclasses import dataclass, replace

from reports.figures.style import WIDTH

LEFT, RIGHT = 0.72, 0.16  # margins; the labels of y axes stand in the left one
_GAP = 0.80  # between axes side by side, for the labels of the right ones
_NARROW_GAP = 0.62  # the same between narrow ones
_FULL = WIDTH - LEFT - RIGHT
_WIDE = 2.2  # a map wider than this, against its height, takes the full width
_LABELS = 0.44  # under axes, for ticks and label
_TICKS = 0.20  # the same for ticks alone
_TITLE = 0.22  # above axes
_CAPTION = 0.38  # above the near view, for two lines
_KEY = 0.46  # colour bar and legend under the map
_PAGE_KEY = 1.5  # the same beside it
_SHORT_KEY = 0.72  # without what a map has
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

    def lower(self, by: float) -> Box:
        """The same `by` inches farther down."""
        return replace(self, top=self.top + by)


@dataclass(frozen=True, slots=True)
class Layout:
    """Boxes for the map, the view of the worst point, the key, and the series in their order; the figure's height.

    There is no map where another figure has it. `key_columns` is how many columns the legend has; `lowest` tells which
    series have nothing below them, `lead` whether the first has the whole width and the others share the row below it.
    """

    map: Box | None
    near: Box
    key: Box
    key_columns: int
    series: tuple[Box, ...]
    height: float
    lead: bool = False

    def lower(self, by: float) -> Layout:
        """The same `by` inches farther down."""
        return replace(
            self, map=self.map and self.map.lower(by), near=self.near.lower(by), key=self.key.lower(by),
            series=tuple(box.lower(by) for box in self.series), height=self.height + by,
        )  # fmt: skip

    @property
    def labelled(self) -> tuple[bool, ...]:
        """Whether each series has the name of the axis under it: in a shared row only the middle one has room."""
        if not self.lead:
            return self.lowest
        return tuple(i == len(self.series) // 2 for i in range(len(self.series)))

    @property
    def lowest(self) -> tuple[bool, ...]:
        """Whether each series is the last in its column, and so has the labels of the axis that it shares."""
        return tuple(not any(_under(other, box) for other in self.series) for box in self.series)


@dataclass(frozen=True, slots=True)
class _Sizes:
    """Heights of a map, of a flat map at least and at most, of series and the room above their titles.

    `lead` is of a series with the whole width, `shared` of those in the row below it.
    """

    map: float
    flat: tuple[float, float]
    near: float
    panel: float
    flat_panel: float
    between: float
    lead: float
    shared: float


_ALONE = _Sizes(3.0, (1.5, 3.0), 2.35, 0.86, 0.86, 0.32, 1.25, 0.86)
_ON_PAGE = _Sizes(2.3, (0.9, 1.7), 1.55, 0.70, 0.46, 0.29, 0.70, 0.58)


def layout(aspect: float, count: int, top: float, lead: bool = False) -> Layout:
    """Place a map of `aspect` (width / height) and `count` series below the header, which ends at `top` [in].

    `lead` gives the first series the whole width, where the map does not have it.
    """
    return _wide(aspect, count, top, _ALONE) if aspect > _WIDE else _compact(aspect, count, top, lead)


def page_layout(aspect: float, count: int, lead: bool = False) -> Layout:
    """Like `layout` without a header, and as low as can be read, for a page that has other things to say."""
    return _wide(aspect, count, _BOTTOM, _ON_PAGE) if aspect > _WIDE else _low(aspect, count, lead)


def member_layout(count: int) -> Layout:
    """Like `page_layout`, of a member of a fleet, whose own figure has the map."""
    return _below(None, _CAPTION, count, _ON_PAGE, _SHORT_KEY)


def _wide(aspect: float, count: int, top: float, sizes: _Sizes) -> Layout:
    """The map over the full width, the rest below it."""
    lowest, highest = sizes.flat
    world = Box(LEFT, top, _FULL, min(highest, max(lowest, _FULL / aspect)))
    return _below(world, world.bottom + _LABELS + _CAPTION, count, sizes)


def _below(world: Box | None, below: float, count: int, sizes: _Sizes, key_height: float = 1.0) -> Layout:
    """Under the map the near view, with the key under it, and the series beside."""
    near = Box(LEFT, below, max(sizes.near, 1.9), sizes.near)
    key = Box(0.2, near.bottom + _LABELS + 0.22, near.width + LEFT - 0.2, key_height)
    left, step = LEFT + near.width + _GAP, sizes.flat_panel + sizes.between
    series = tuple(Box(left, below + i * step, WIDTH - RIGHT - left, sizes.flat_panel) for i in range(count))
    return Layout(world, near, key, 2, series, max(series[-1].bottom + _LABELS, key.bottom) + _BOTTOM)


def _compact(aspect: float, count: int, top: float, lead: bool) -> Layout:
    """Map and near view side by side, the key under them, then the series."""
    world = Box(LEFT, top + _CAPTION, min(4.0, max(2.7, _ALONE.map * aspect)), _ALONE.map)
    near = Box(LEFT + world.width + _GAP, world.top, _FULL - world.width - _GAP, world.height)
    key = Box(LEFT, world.bottom + _LABELS + 0.2, _FULL, _KEY)
    series = (_led if lead else _pairs)(key.bottom + _TITLE, count, _ALONE)
    return Layout(world, near, key, 4, series, series[-1].bottom + _LABELS + _BOTTOM, lead)


def _low(aspect: float, count: int, lead: bool) -> Layout:
    """Map, near view and key side by side, then the series."""
    room = _FULL - _GAP - _PAGE_KEY - 0.2  # for map and near view
    world = Box(LEFT, _CAPTION, min(0.62 * room, max(0.5 * room, _ON_PAGE.map * aspect)), _ON_PAGE.map)
    near = Box(LEFT + world.width + _GAP, world.top, room - world.width, world.height)
    key = Box(WIDTH - RIGHT - _PAGE_KEY, world.top + 0.2, _PAGE_KEY, world.height)
    series = (_led if lead else _pairs)(world.bottom + _LABELS + _TITLE + 0.04, count, _ON_PAGE)
    return Layout(world, near, key, 1, series, series[-1].bottom + _LABELS + _BOTTOM, lead)


def _pairs(top: float, count: int, sizes: _Sizes) -> tuple[Box, ...]:
    """`count` boxes two in a row, from `top` on; an odd one has the first row, and an axis of its own, alone."""
    half, step = (_FULL - _GAP) / 2, sizes.panel + sizes.between
    boxes = [Box(LEFT, top, _FULL, sizes.panel)] * (count % 2)
    if boxes:
        top += sizes.panel + _LABELS + _TITLE
    for row in range(count // 2):
        boxes += [Box(left, top + row * step, half, sizes.panel) for left in (LEFT, LEFT + half + _GAP)]
    return tuple(boxes)


def _led(top: float, count: int, sizes: _Sizes) -> tuple[Box, ...]:
    """The first of `count` boxes over the full width, with an axis of its own, the others side by side below it."""
    width = (_FULL - (count - 2) * _NARROW_GAP) / (count - 1)
    below = top + sizes.lead + _TICKS + _TITLE
    row = (Box(LEFT + i * (width + _NARROW_GAP), below, width, sizes.shared) for i in range(count - 1))
    return (Box(LEFT, top, _FULL, sizes.lead), *row)


def _under(lower: Box, upper: Box) -> bool:
    overlaps = lower.left < upper.left + upper.width and upper.left < lower.left + lower.width
    return overlaps and lower.top > upper.top and lower.width == upper.width
