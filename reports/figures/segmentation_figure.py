"""The picture of a segmentation: the aerial image, the map found in it, and the clearance on it (paper 004, Fig. 4)."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from planners.kernel import Bools
from planners.map import Raster
from planners.occupancy import clearance_field
from planners.segmentation.aerial import Aerial
from planners.segmentation.facts import SegmentationFacts
from reports.figures.extent import Extent
from reports.figures.layout import LEFT, RIGHT, Box
from reports.figures.plan_map import label_ground
from reports.figures.style import INK, MUTED, OBSTACLE, PAPER, SKY, VERMILION, WIDTH, new_figure, place, save, style
from reports.terminal.segmentation_table import iou_words, size_words
from reports.words.quantity import number, text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_HEAD, _TITLE, _LABELS, _KEY, _GAP, _BOTTOM = 0.62, 0.24, 0.44, 0.50, 0.16, 0.08  # [in]
_HIGHEST = 6.0  # [in] of a panel
_STACKED = 2.2  # an image wider than this, against its height, has the panels below each other
_FINEST = 1000  # pixels a side that a panel shows at most; of several, one obstacle is shown
_BAR = 0.09  # [in] height of the colour bar


def save_segmentation_figure(
    aerial: Aerial, blocked: Bools, facts: SegmentationFacts, file: str | Path, truth: Bools | None = None
) -> None:
    """Write the picture as PNG (1600 pixels wide) or SVG, by the suffix of `file`.

    `blocked` (rows, cols) is what was found, `truth` what should have been; where they differ is marked. The same
    segmentation gives the same bytes. Raises `InputError` where the folder does not exist.
    """
    with style():
        save(segmentation_figure(aerial, blocked, facts, truth), file)


def segmentation_figure(aerial: Aerial, blocked: Bools, facts: SegmentationFacts, truth: Bools | None = None) -> Figure:
    """The figure itself; to be called, and saved, within `style.style()`."""
    boxes = _boxes(facts.size[0] / facts.size[1])
    stacked = boxes[1].left == boxes[0].left
    figure = new_figure(boxes[-1].bottom + _LABELS + _KEY + _BOTTOM)
    _draw_head(figure, facts)
    step = max(1, -(-max(blocked.shape) // _FINEST))
    raster = Raster(_coarse(blocked, step), facts.cell * step)
    view = Extent(0.0, 0.0, *facts.size)
    panels = [place(figure, box.left, box.top, box.width, box.height) for box in boxes]
    for i, (axes, title) in enumerate(zip(panels, ("Image", "Map", "Clearance"), strict=True)):
        axes.set(xlim=(0.0, view.width), ylim=(0.0, view.height))
        axes.set_title(title)
        axes.grid(visible=False)
        axes.spines[:].set_visible(True)
        label_ground(axes, boxes[i], view, east=not stacked or i == 2, north=stacked or i == 0)
    _show(panels[0], aerial.colours[::step, ::step], facts.cell * step)
    _draw_map(panels[1], blocked, truth, step, facts.cell)
    _draw_clearance(figure, panels[2], boxes[2], boxes[2].width / (2 if stacked else 1), raster)
    _draw_key(figure, boxes[0], boxes[-1].bottom, truth is not None)
    return figure


def _boxes(aspect: float) -> list[Box]:
    """Where the three panels of that `aspect` (width / height) stand."""
    full = WIDTH - LEFT - RIGHT
    if aspect > _STACKED:
        high = full / aspect
        return [Box(LEFT, _HEAD + _TITLE + i * (high + _TITLE + _GAP), full, high) for i in range(3)]
    wide = min((full - 2 * _GAP) / 3, _HIGHEST * aspect)
    return [Box(LEFT + i * (wide + _GAP), _HEAD + _TITLE, wide, wide / aspect) for i in range(3)]


def _coarse(cells: Bools, step: int) -> Bools:
    """Squares of `step` x `step` cells (rows, cols), true where any of them is."""
    if step == 1:
        return cells
    rows, columns = (-side % step for side in cells.shape)
    whole = np.pad(cells, ((0, rows), (0, columns)))
    return np.asarray(
        whole.reshape(whole.shape[0] // step, step, whole.shape[1] // step, step).any(axis=(1, 3)), dtype=bool
    )


def _show(axes: Axes, cells: NDArray[Any], cell: float, **look: Any) -> Any:
    """Draw the cells (rows, cols[, 3]), row 0 in the south, from the origin on."""
    limits = axes.get_xlim(), axes.get_ylim()  # imshow would change them
    rows, columns = cells.shape[:2]
    shown = axes.imshow(
        cells, extent=(0.0, columns * cell, 0.0, rows * cell), origin="lower", aspect="auto", zorder=1.0, **look
    )
    axes.set(xlim=limits[0], ylim=limits[1])
    return shown


def _draw_map(axes: Axes, blocked: Bools, truth: Bools | None, step: int, cell: float) -> None:
    """Drivable ground white and obstacles dark, as in the paper; errors in colour, even where they are small."""
    shown = _coarse(blocked, step).astype(int)
    if truth is not None:
        shown[_coarse(blocked & ~truth, step)] = 2
        shown[_coarse(truth & ~blocked, step)] = 3
    colours = ListedColormap([PAPER, INK, SKY, VERMILION])
    _show(axes, shown, cell * step, cmap=colours, vmin=0, vmax=3, interpolation="nearest")


def _draw_clearance(figure: Figure, axes: Axes, box: Box, width: float, raster: Raster) -> None:
    """How far from the nearest obstacle each place is, with a colour bar of `width` [in] under it."""
    field = np.ma.masked_where(raster.blocked, clearance_field(raster))
    axes.set_facecolor(OBSTACLE)
    if not np.isfinite(field).all():
        axes.text(0.5, 0.5, "no obstacle", transform=axes.transAxes, ha="center", va="center")
        return
    shown = _show(axes, field, raster.cell, cmap=mpl.colormaps["cividis"], vmin=0.0, interpolation="nearest")
    bar = place(figure, box.left + box.width - width, box.bottom + _LABELS + 0.06, width, _BAR)
    figure.colorbar(shown, cax=bar, orientation="horizontal")
    bar.grid(visible=False)
    bar.tick_params(length=2.0)
    bar.set_xlabel("to the nearest obstacle, the edge open [m]", labelpad=1.5)


def _draw_head(figure: Figure, facts: SegmentationFacts) -> None:
    height = figure.get_size_inches()[1]
    told = [
        f"{size_words(facts)}, {text(facts.cell, 'm')} a pixel",
        f"{text(facts.drivable, 'share')} drivable",
        f"{facts.method}, threshold {number(facts.threshold)}",
    ]
    if facts.iou is not None:
        told.append(f"IoU of obstacles {iou_words(facts)}")
    figure.text(0.2 / WIDTH, 1.0 - 0.22 / height, facts.image, fontsize=12.5, fontweight="bold", va="center")
    figure.text(0.2 / WIDTH, 1.0 - 0.46 / height, " · ".join(told), fontsize=8.5, va="center", color=MUTED)


def _draw_key(figure: Figure, box: Box, bottom: float, known: bool) -> None:
    """What the colours of the map mean, in a row under it."""
    entries = [
        Patch(facecolor=PAPER, edgecolor=MUTED, linewidth=0.6, label="drivable"),
        Patch(facecolor=INK, label="obstacle"),
    ]
    if known:
        entries += [Patch(facecolor=VERMILION, label="missed"), Patch(facecolor=SKY, label="false obstacle")]
    top = 1.0 - (bottom + _LABELS + 0.04) / figure.get_size_inches()[1]
    figure.legend(
        handles=entries, loc="upper left", ncols=2, borderaxespad=0.0, columnspacing=1.2, handlelength=1.2,
        handletextpad=0.5, bbox_to_anchor=(box.left / WIDTH, top),
    )  # fmt: skip
