"""A map: obstacles, keep-in areas and an edge in a local frame."""

from __future__ import annotations

from dataclasses import dataclass

from planners.kernel import Floats
from planners.frame import Frame


@dataclass(frozen=True, slots=True)
class Circle:
    """A round obstacle, centre (`x`, `y`) and `radius` [m]."""

    x: float
    y: float
    radius: float


@dataclass(frozen=True, slots=True)
class Map:
    """Obstacles in a local frame [m]."""

    polygons: tuple[Floats, ...] = ()
    circles: tuple[Circle, ...] = ()
    frame: Frame | None = None
