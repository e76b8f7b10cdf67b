"""What several cases asked of the same vehicle, side by side: a column a case, a row a quantity against its limit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from matplotlib.figure import Figure

from reports.figures.fitted import fit, shortened
from reports.figures.layout import LEFT, RIGHT
from reports.figures.panels import Panel, panels
from reports.figures.scenario_cases import Run
from reports.figures.series_panel import draw_panel, mark_unreached
from reports.figures.style import MUTED, WIDTH, place
from reports.figures.ticks import BROAD, HIGH, length_unit, ticks
from tracking.outcome import Outcome

_COLUMNS = 3
_TITLES = ("Lateral accel.", "Curvature", "Bank", "Steering")  # of those panels that say what was asked
_ROWS = 2
_GAP, _HIGH, _BETWEEN, _HEAD, _LABELS = 0.5, 0.72, 0.36, 0.62, 0.44  # [in]
_NAMED = 60  # characters


def side_by_side(groups: Mapping[str, Sequence[tuple[Run, Outcome]]]) -> list[tuple[str, Outcome]]:
    """The cases of the grid by name, worst first: the worst of each group, or of one group the worst, as far as they
    have the vehicle of the first.
    """
    firsts = [own[0] for own in groups.values()] if len(groups) > 1 else list(next(iter(groups.values())))
    vehicle = firsts[0][1].vehicle
    alike = [(run.result.case.name, outcome) for run, outcome in firsts if outcome.vehicle == vehicle]
    return [one for one in alike if _asked(one[1])][:_COLUMNS]


def grid_height(shown: Sequence[tuple[str, Outcome]]) -> float:
    """The height of the grid of the cases `shown` [in]."""
    if not shown:
        return 0.0
    rows = len(_asked(shown[0][1]))
    return _HEAD + rows * _HIGH + (rows - 1) * _BETWEEN + _LABELS


def draw_efforts(figure: Figure, top: float, shown: Sequence[tuple[str, Outcome]]) -> None:
    """Draw the cases `shown` from `top` [in] down; every row has one scale."""
    count = len(shown)
    width = (WIDTH - LEFT - RIGHT - (count - 1) * _GAP) / count
    for row in range(len(_asked(shown[0][1]))):
        line = []
        for column, (name, outcome) in enumerate(shown):
            left, here = LEFT + column * (width + _GAP), top + _HEAD + row * (_HIGH + _BETWEEN)
            axes = place(figure, left, here, width, _HIGH)
            panel = _asked(outcome)[row]
            draw_panel(axes, outcome, panel, None, legend=False)
            mark_unreached(axes, outcome)
            scale, unit = length_unit(outcome.path.length)
            axes.set_xlim(-0.01 * outcome.path.length, 1.01 * outcome.path.length)
            ticks(axes.xaxis, width / BROAD, scale)
            last = row == len(_asked(shown[0][1])) - 1
            axes.tick_params(labelbottom=last)
            if last:
                axes.set_xlabel(f"distance along the path [{unit}]")
            if row == 0:
                place_of = (left / WIDTH, 1.0 - (here - 0.25) / figure.get_size_inches()[1])
                told = figure.text(*place_of, shortened(name, _NAMED), fontsize=7.5, color=MUTED, va="bottom")
                fit(told, width * figure.dpi, 7.0)
            line.append(axes)
        ceiling = max(axes.get_ylim()[1] for axes in line)
        for axes in line:
            axes.set_ylim(-ceiling, ceiling)
            ticks(axes.yaxis, _HIGH / HIGH)
    _draw_key(figure, top)


def _draw_key(figure: Figure, top: float) -> None:
    """What the lines of the grid are, beside its title, each once."""
    entries: dict[str, Any] = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            entries.setdefault(label, handle)
    height = figure.get_size_inches()[1]
    figure.text(LEFT / WIDTH, 1.0 - (top + 0.2) / height, "Asked of the vehicle", fontsize=8.5, fontweight="bold")
    figure.legend(
        list(entries.values()), list(entries), loc="lower right", ncols=6, borderpad=0.0,
        borderaxespad=0.0, handlelength=1.4, columnspacing=1.0, handletextpad=0.4,
        bbox_to_anchor=(1.0 - RIGHT / WIDTH, 1.0 - (top + 0.21) / height),
    )  # fmt: skip


def _asked(outcome: Outcome) -> list[Panel]:
    return [panel for panel in panels(outcome) if panel.title in _TITLES and panel.symmetric][:_ROWS]
