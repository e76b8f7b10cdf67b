"""The body of a vehicle as seen from above."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Disc:
    """A disc of `radius` [m] about the reference point; for aircraft, half the span."""

    radius: float


@dataclass(frozen=True, slots=True)
class Rectangle:
    """An oriented rectangle, `length` x `width` [m], its centre `ahead` [m] of the reference point."""

    length: float
    width: float
    ahead: float


Footprint = Disc | Rectangle
