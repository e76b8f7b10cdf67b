"""Whether a figure can be read: all its texts lie inside it, none lies on another, and none is too small."""

from __future__ import annotations

from collections.abc import Iterator

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Annotation, Text
from matplotlib.transforms import Bbox

SMALLEST = 7.0  # [pt]
_TOUCH = 1.5  # pixels by which two boxes may overlap: an em box is larger than its ink


def texts_of(figure: Figure) -> list[tuple[str, float, Bbox]]:
    """What is written on `figure` as it is drawn: text, size [pt] and the box [pixels] of each."""
    canvas = FigureCanvasAgg(figure)
    renderer = canvas.get_renderer()
    canvas.draw()
    unseen = set(_unseen(figure))
    found = []
    for text in figure.findobj(lambda artist: isinstance(artist, Text)):
        assert isinstance(text, Text)
        hidden = not text.get_visible() or not text.get_text().strip() or id(text) in unseen
        if not hidden and not (isinstance(text, Annotation) and not text._check_xy(renderer)):
            # The ink of a box around the text is no text
            found.append((text.get_text(), float(text.get_fontsize()), Text.get_window_extent(text, renderer)))
    return found


def _unseen(figure: Figure) -> Iterator[int]:
    """The ids of the labels of ticks that are not on their axis."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            slack = 1e-9 * (high - low)
            for tick in [*axis.majorTicks, *axis.minorTicks]:
                if not (tick.get_visible() and low - slack <= tick.get_loc() <= high + slack):
                    yield from (id(tick.label1), id(tick.label2))


def faults(figure: Figure) -> list[str]:
    """What is wrong with the texts of `figure`, nothing where all can be read."""
    texts, edge = texts_of(figure), figure.bbox
    wrong = [f"{text!r} is of {size:.1f} pt" for text, size, _ in texts if size < SMALLEST - 1e-6]
    for i, (text, _, box) in enumerate(texts):
        if box.x0 < edge.x0 - 1 or box.y0 < edge.y0 - 1 or box.x1 > edge.x1 + 1 or box.y1 > edge.y1 + 1:
            wrong.append(f"{text!r} leaves the figure")
        for other, _, second in texts[i + 1 :]:
            wide = min(box.x1, second.x1) - max(box.x0, second.x0)
            high = min(box.y1, second.y1) - max(box.y0, second.y0)
            if wide > _TOUCH and high > _TOUCH:
                wrong.append(f"{text!r} lies on {other!r}")
    return wrong
