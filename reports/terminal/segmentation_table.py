"""What a segmentation found, as the terminal shows it and as one JSON object."""

from __future__ import annotations

import msgspec
from rich import box
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from planners.segmentation.facts import SegmentationFacts
from reports.words.quantity import number, text


def print_segmentation(facts: SegmentationFacts, console: Console | None = None) -> None:
    """Print the facts; without a `console`, on standard output."""
    console = console or Console(highlight=False)
    table = Table(
        padding=(0, 2, 0, 0), show_edge=False, title=escape(facts.image), title_justify="left", title_style="bold",
        box=box.SIMPLE_HEAD, pad_edge=False,
    )  # fmt: skip
    table.add_column("segmentation", no_wrap=True)
    table.add_column("value", justify="right", no_wrap=True)
    for row in _rows(facts):
        table.add_row(*row)
    console.print(table)


def segmentation_json(facts: SegmentationFacts, mask: str, figure: str) -> str:
    """The facts, and the files that were saved; null where no truth is known."""
    told = {**msgspec.to_builtins(facts), "mask": mask, "figure": figure}
    return msgspec.json.format(msgspec.json.encode(told), indent=2).decode()


def size_words(facts: SegmentationFacts) -> str:
    """ "640 m × 1.2 km": width and height of the image."""
    return " × ".join(text(side, "m", 4) for side in facts.size)


def iou_words(facts: SegmentationFacts) -> str:
    """The intersection over union with four digits, for it is near 1; "" where no truth is known."""
    return "" if facts.iou is None else number(facts.iou, 4)


def _rows(facts: SegmentationFacts) -> list[tuple[str, str]]:
    columns, rows = facts.pixels
    told = [
        ("size", size_words(facts)),
        ("pixels", f"{columns} × {rows}"),
        ("scale, a pixel", text(facts.cell, "m", 4)),
        ("drivable", text(facts.drivable, "share")),
        ("method", facts.method),
        ("threshold", number(facts.threshold)),
        ("separability", number(facts.separability)),
    ]
    if facts.missed is None or facts.false is None:
        return told
    return [
        *told,
        ("IoU of obstacles", iou_words(facts)),
        ("obstacle missed", f"{number(facts.missed)} m²"),
        ("ground forbidden", f"{number(facts.false)} m²"),
    ]
