"""The figures of a report: told first, then drawn by as many processes as there are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from campaigns.lanes import Lanes
from reports.figures.style import save, style


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """A figure called `stem`: what `draw` makes of `arguments`, which other processes can be sent.

    Its `caption` stands under it in a report. Its upper `head` inches, with name, verdict and reason, are for those who
    see it alone: a page that says this itself leaves them out.
    """

    stem: str
    draw: Callable[..., Figure]
    arguments: tuple[Any, ...]
    caption: str = ""
    head: float = 0.0

    @property
    def svg(self) -> str:
        """The name of its file."""
        return f"{self.stem}.svg"


def draw_all(drawings: Sequence[Drawing], folder: Path, lanes: Lanes) -> None:
    """Draw each as PNG (1600 pixels wide) and as SVG into `folder`; raises what goes wrong with one."""

    def send(executor: Executor, one: Drawing) -> Future[None]:
        return executor.submit(_draw, one.draw, one.arguments, folder / one.stem)

    for _, future in lanes.each(drawings, send):
        future.result()


def _draw(draw: Callable[..., Figure], arguments: tuple[Any, ...], stem: Path) -> None:
    with style():
        figure = draw(*arguments)
        save(figure, f"{stem}.svg", f"{stem}.png")
