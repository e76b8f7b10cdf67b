"""Round ticks, as many as there is room for, labelled in metres or kilometres."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import FuncFormatter, MaxNLocator

from reports.figures.style import ROUND_TICKS
from reports.words.quantity import KILO, number

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

BROAD, HIGH = 0.7, 0.3  # [in] between the ticks of an x and of a y axis
FLOOR = 1e4  # the largest value against the least that a logarithmic axis tells apart: less is rounding
_IN_KM = 3000.0  # [m] a longer axis is labelled in km


def length_unit(length: float) -> tuple[float, str]:
    """What an axis of `length` [m] is labelled in: how many metres it has, and its name."""
    return (KILO, "km") if length >= _IN_KM else (1.0, "m")


def ticks(axis: Axis, room: float, scale: float = 1.0) -> None:
    """At most as many round ticks as `room` says, labelled in `scale` of the axis' unit."""
    axis.set_major_locator(MaxNLocator(nbins=max(2, min(8, int(room))), steps=list(ROUND_TICKS)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: number(value / scale, 4)))


def ticks_from(axes: Axes, x: float, y: float) -> None:
    """A few round ticks on both axes, labelled with the distance from `x`, `y`; and which axis it is."""
    scale, unit = length_unit(max(float(np.ptp(axis.get_view_interval())) for axis in (axes.xaxis, axes.yaxis)))
    for axis, zero in ((axes.xaxis, x), (axes.yaxis, y)):
        low, high = (float(end) - zero for end in axis.get_view_interval())
        places = MaxNLocator(nbins=4, steps=list(ROUND_TICKS)).tick_values(low, high)
        shown = [float(tick) for tick in places if low <= tick <= high]
        axis.set_ticks([zero + tick for tick in shown], [number(tick / scale, 4) for tick in shown])
    axes.set(xlabel=f"east of it [{unit}]", ylabel=f"north of it [{unit}]")
