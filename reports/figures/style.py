"""The one style of every figure: colours, type, and files that are the same bytes every time.

Colours are Okabe and Ito's (2008), told apart by every kind of colour vision; error runs through cividis
(Nunez, Anderton and Renslow 2018), which also rises in lightness, so that a figure printed in grey still says
it.
"""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import Colormap, LinearSegmentedColormap
from matplotlib.figure import Figure

from planners.atomic_file import atomic

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Properties by name, as matplotlib takes them; it has no closer type for a set of them.
Look = dict[str, Any]

INK, MUTED, GRID, PAPER = "#1b2733", "#5b6875", "#e4e9ee", "#ffffff"
GROUND_COLOUR, OBSTACLE, OBSTACLE_EDGE = "#f6f8fa", "#c3cad2", "#77828e"
BLUE, SKY, GREEN, VERMILION, ORANGE, PURPLE = "#0072b2", "#56b4e9", "#009e73", "#d55e00", "#e69f00", "#cc79a7"
CORRIDOR, TIGHT, LIMIT, FENCE = SKY, PURPLE, VERMILION, GREEN
PASS_BADGE, FAIL_BADGE = "#00735a", "#b34700"  # Okabe and Ito's green and vermilion, darkened for white type
MEMBERS = (BLUE, ORANGE, GREEN, PURPLE, SKY)  # of the vehicles of a fleet, over and over; vermilion is for alarms
MARK = {True: VERMILION, False: PASS_BADGE}  # of the one point that a figure marks: is it an alarm?

DASHES, FENCE_DASHES = (0, (4, 2.5)), (0, (5, 1.5, 1, 1.5))

ROUND_TICKS = (1, 2, 2.5, 5, 10)  # what ticks are multiples of
WIDTH = 8.0  # [in] of every figure
DPI = 200  # 1600 pixels wide
# For names in scripts that the first, bundled font lacks; used glyph by glyph where the machine has one of them.
_FALLBACKS = (
    "Noto Sans CJK SC", "Noto Sans CJK JP", "Noto Sans SC", "WenQuanYi Zen Hei", "Microsoft YaHei", "PingFang SC",
)  # fmt: skip

_NOT_XML = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")  # XML 1.0, 2.2; names come along as comments

_RC: Look = {
    "font.size": 8.0,
    "axes.titlesize": 8.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlecolor": INK,
    "axes.titlepad": 5.0,
    "axes.labelsize": 8.0,
    "axes.labelcolor": MUTED,
    "axes.edgecolor": "#aab4be",
    "axes.linewidth": 0.7,
    "axes.facecolor": PAPER,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.unicode_minus": True,
    "grid.color": GRID,
    "grid.linewidth": 0.7,
    "xtick.color": "#aab4be",
    "ytick.color": "#aab4be",
    "xtick.labelcolor": MUTED,
    "ytick.labelcolor": MUTED,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "text.color": INK,
    "text.parse_math": False,  # a dollar sign in a user's name is a dollar sign
    "legend.frameon": False,
    "legend.fontsize": 7.5,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "figure.facecolor": PAPER,
    "savefig.facecolor": PAPER,
    "svg.fonttype": "path",
    "svg.hashsalt": "trackworthy",
    "path.simplify": True,
    "path.simplify_threshold": 0.2,
    "agg.path.chunksize": 20000,
}


@contextmanager
def style() -> Iterator[None]:
    """Within this context figures are made and saved in the one style, whatever the user's matplotlibrc says."""
    from matplotlib.font_manager import fontManager

    installed = set(fontManager.get_font_names())
    families = ["DejaVu Sans", *(name for name in _FALLBACKS if name in installed)]
    with mpl.rc_context(), warnings.catch_warnings():
        mpl.rcdefaults()
        for name, value in {**_RC, "font.family": families}.items():
            mpl.rcParams[name] = value  # type: ignore[index]
        # A character no font has is drawn as a box; that is no reason to warn about a user's name.
        warnings.filterwarnings("ignore", message="Glyph .* missing from")
        yield


def new_figure(height: float) -> Figure:
    """An empty figure of the one width and of `height` [in]."""
    figure = Figure(figsize=(WIDTH, height), dpi=DPI)
    FigureCanvasAgg(figure)
    return figure


def place(figure: Figure, left: float, top: float, width: float, height: float) -> Axes:
    """New axes in `figure`, their box in inches from the left and from the top."""
    w, h = figure.get_size_inches()
    return figure.add_axes((left / w, 1.0 - (top + height) / h, width / w, height / h))


def save(figure: Figure, *files: str | Path) -> None:
    """Write `figure` as PNG or SVG, by the suffix of each of `files`: whole or not at all, without date or version.

    It is drawn once, as SVG; PNG are pixels of that.
    """
    svg = _svg(figure)
    for file in map(Path, files):
        content = svg if file.suffix.lower() == ".svg" else _png(svg, *figure.get_size_inches())
        with atomic(file) as temporary:
            temporary.write_bytes(content)


def _svg(figure: Figure) -> bytes:
    buffer = io.BytesIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    return _NOT_XML.sub("", buffer.getvalue().decode()).encode()


def _png(svg: bytes, width: float, height: float) -> bytes:
    """The pixels of `svg`, `width` and `height` in inches."""
    import typst

    page = (
        f"#set page(width: {width:.6f}in, height: {height:.6f}in, margin: 0pt)\n"
        '#image(bytes(sys.inputs.svg), format: "svg", width: 100%)'
    )
    pixels = typst.compile(
        page.encode(), format="png", ppi=float(DPI), sys_inputs={"svg": svg.decode()}, ignore_system_fonts=True
    )
    return bytes(pixels)


def error_colours() -> Colormap:
    """Cividis without its palest end, which white swallows; what leaves the corridor is vermilion."""
    cividis = mpl.colormaps["cividis"]
    colours = LinearSegmentedColormap.from_list("error", [cividis(0.92 * i / 255) for i in range(256)])
    return colours.with_extremes(over=VERMILION, bad=MUTED)
