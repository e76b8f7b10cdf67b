"""Feasibility of a plan before it is flown: what its turns and climbs ask of the vehicle."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from planners.path import Path
from planners.turns import available_radii
from sim.vehicle import Limits
from sim.wind import Wind, ground_speed_on_course, heading_for_course

COURSES = 9  # at which a turn is looked at, its ends included


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

    @property
    def tangent(self) -> float:
        """How far before and after the vertex [m] the required arc begins and ends."""
        return self.required * math.tan(abs(self.angle) / 2)


@dataclass(frozen=True, slots=True)
class Stretch:
    """Neighbouring turns that are all too tight, from `s` to `s_end` [m], one of them the `worst`."""

    s: float
    s_end: float
    worst: Turn


@dataclass(frozen=True, slots=True)
class Slope:
    """A stretch from `s` to `s_end` [m] whose `gradient` through the air is beyond `limit`; descents are negative."""

    s: float
    s_end: float
    gradient: float
    limit: float


@dataclass(frozen=True, slots=True)
class Feasibility:
    """Every turn of the simplified path, and what the vehicle cannot follow: turns too `tight`, slopes too `steep`."""

    turns: tuple[Turn, ...]
    steep: tuple[Slope, ...]

    @property
    def tight(self) -> tuple[Turn, ...]:
        """The turns with a negative margin."""
        return tuple(turn for turn in self.turns if turn.margin < 0.0)

    @property
    def stretches(self) -> tuple[Stretch, ...]:
        """The turns too tight, those whose required arcs would overlap as one."""
        runs: list[list[Turn]] = []
        for turn in self.tight:
            if runs and turn.s - runs[-1][-1].s <= runs[-1][-1].tangent + turn.tangent:
                runs[-1].append(turn)
            else:
                runs.append([turn])
        return tuple(Stretch(run[0].s, run[-1].s, min(run, key=lambda turn: turn.margin)) for run in runs)

    @property
    def tightest(self) -> Turn | None:
        """The turn with the smallest margin, or None for a straight path."""
        return min(self.turns, key=lambda turn: turn.margin, default=None)


def assess(path: Path, limits: Limits, speed: float, wind: Wind, corridor: float) -> Feasibility:
    """What `path` asks of a vehicle with `limits` at `speed` [m/s] in `wind` within `corridor` [m]."""
    vertices, angles, radii = available_radii(path, corridor)
    turns = tuple(
        Turn(
            float(path.s[vertex]), float(path.xy[vertex, 0]), float(path.xy[vertex, 1]), float(angle), float(radius),
            required_radius(limits, speed, wind, float(path.headings[vertex - 1]), float(angle)),
        )
        for vertex, angle, radius in zip(vertices, angles, radii, strict=True)
    )  # fmt: skip
    return Feasibility(turns, _steep(path, limits, speed, wind))


def required_radius(limits: Limits, speed: float, wind: Wind, course: float, angle: float) -> float:
    """Smallest radius [m] that holds throughout a turn by `angle` from `course` [rad], worst case over it.

    In wind the ground speed changes through the turn, and with it Vg^2 / (g tan(bank) cos(crab)). Infinite where the
    wind is too strong for the course.
    """
    if limits.kind == "ground":
        return limits.turn_radius(speed)
    worst = 0.0
    for bearing in np.linspace(course, course + angle, COURSES).tolist():
        ground_speed = ground_speed_on_course(speed, bearing, wind)
        if math.isnan(ground_speed) or ground_speed <= 0.0:
            return math.inf
        crab = heading_for_course(speed, bearing, wind) - bearing
        worst = max(worst, limits.turn_radius(ground_speed, crab))
    return worst


def _steep(path: Path, limits: Limits, speed: float, wind: Wind) -> tuple[Slope, ...]:
    """Stretches that climb or descend beyond the limits.

    Those are gradients through the air: a tailwind makes the same path over the ground steeper.
    """
    if path.z is None or limits.kind == "ground":
        return ()
    over_ground = np.array([ground_speed_on_course(speed, float(course), wind) for course in path.headings])
    gradients = np.diff(path.z) / np.diff(path.s) * np.fmax(over_ground, 0.0) / speed
    found: list[Slope] = []
    for i, gradient in enumerate(gradients.tolist()):
        limit = limits.climb_gradient if gradient > 0.0 else -limits.descent_gradient
        if abs(gradient) <= abs(limit):
            continue
        s, s_end = float(path.s[i]), float(path.s[i + 1])
        last = found[-1] if found else None
        if last and last.s_end == s and last.limit == limit:
            rise = last.gradient * (s - last.s) + gradient * (s_end - s)
            found[-1] = Slope(last.s, s_end, rise / (s_end - last.s), limit)
        else:
            found.append(Slope(s, s_end, gradient, limit))
    return tuple(found)
