"""Feasibility of a plan before it is flown: what its turns and climbs ask of the vehicle."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Turn:
    """A vertex of the simplified path: at `s` [m], (`x`, `y`) [m], it turns by `angle` [rad, left positive].

    `available` [m] is the largest radius the corridor and the adjoining legs leave, `required` [m] the vehicle's
    smallest there, at its speed and in the wind.
    """

    s: float
    x: float
    y: float
    angle: float
    available: float
    required: float

    @property
    def margin(self) -> float:
        """Available minus required radius [m]."""
        return self.available - self.required


@dataclass(frozen=True, slots=True)
class Slope:
    """A leg from `s` to `s_end` [m] that climbs (or descends, negative) by `gradient`; the vehicle's `limit` is signed."""

    s: float
    s_end: float
    gradient: float
    limit: float


@dataclass(frozen=True, slots=True)
class Feasibility:
    """Every turn of the simplified path, and the ones and the legs that the vehicle cannot follow."""

    turns: tuple[Turn, ...]
    tight: tuple[Turn, ...]
    steep: tuple[Slope, ...]

    @property
    def tightest(self) -> Turn | None:
        """The turn with the smallest margin, or None for a straight path."""
        return min(self.turns, key=lambda turn: turn.margin, default=None)
