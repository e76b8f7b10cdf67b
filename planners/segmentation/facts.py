"""What is to be said of a segmentation."""

from __future__ import annotations

import msgspec

from planners.kernel import Bools
from planners.segmentation.segment import Segmented, overlap
from planners.segmentation.settings import Segmentation


class SegmentationFacts(msgspec.Struct, frozen=True, kw_only=True):
    """`size` [m] is the width and height of the image, `pixels` its columns and rows, `cell` [m] the side of a pixel.

    `threshold` and `separability` are those of `Segmented`, `drivable` is the share of the ground that is. Where the
    truth is known, `iou` is the intersection over union of the obstacles, `missed` the area [m^2] of obstacle that was
    taken for ground, `false` that of ground taken for obstacle.
    """

    image: str
    size: tuple[float, float]
    pixels: tuple[int, int]
    cell: float
    method: str
    threshold: float
    separability: float
    drivable: float
    iou: float | None = None
    missed: float | None = None
    false: float | None = None


def facts_of(
    image: str, found: Segmented, cell: float, settings: Segmentation, truth: Bools | None = None
) -> SegmentationFacts:
    """The facts about what was `found` in an `image` with pixels of `cell` [m]; `truth` (rows, cols) is obstacle."""
    rows, columns = found.blocked.shape
    facts = SegmentationFacts(
        image=image,
        size=(columns * cell, rows * cell),
        pixels=(columns, rows),
        cell=cell,
        method=settings.method,
        threshold=found.threshold,
        separability=found.separability,
        drivable=1.0 - float(found.blocked.mean()),
    )
    if truth is None:
        return facts
    return msgspec.structs.replace(
        facts,
        iou=overlap(found.blocked, truth),
        missed=float((truth & ~found.blocked).sum() * cell**2),
        false=float((found.blocked & ~truth).sum() * cell**2),
    )
