"""Round ticks, as many as there is room for, labelled in metres or kilometres."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.ticker import FuncFormatter, MaxNLocator

from reports.quantity import KILO, number
from reports.style import ROUND_TICKS

if TYPE_CHECKING:
    from matplotlib.axis import Axis

BROAD, HIGH = 0.7, 0.3  # [in] between the ticks of an x and of a y axis
_IN_KM = 3000.0  # [m] a longer axis is labelled in km


def length_unit(length: float) -> tuple[float, str]:
    """What an axis of `length` [m] is labelled in: how many metres it has, and its name."""
    return (KILO, "km") if length >= _IN_KM else (1.0, "m")


def ticks(axis: Axis, room: float, scale: float = 1.0) -> None:
    """At most as many round ticks as `room` says, labelled in `scale` of the axis' unit."""
    axis.set_major_locator(MaxNLocator(nbins=max(2, min(8, int(room))), steps=list(ROUND_TICKS)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: number(value / scale, 4)))
