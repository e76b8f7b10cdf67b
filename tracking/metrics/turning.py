"""Turns, planned and flown: angles, radii, corners cut and overshot."""

from __future__ import annotations

import math

import numpy as np

from planners.kernel import Floats
from tracking.metric import Metric
from tracking.run import Run


def turn_angles(run: Run) -> list[Metric]:
    """Largest turn angle [rad]: planned at the path's vertices (the papers' metric), flown over its median leg."""
    vertex = int(np.argmax(np.abs(run.path.turns)))
    planned = Metric("turn_angle_max_planned", float(abs(run.path.turns[vertex])), "rad", s=float(run.path.s[vertex]))
    leg = float(np.median(np.diff(run.path.s)))
    distance, course = run.track.distance, np.unwrap(run.track["course"])
    if distance[-1] < leg or len(distance) < 2:
        note = "the track is shorter than the path's median leg"
        return [planned, Metric("turn_angle_max_flown", math.nan, "rad", valid=False, note=note)]
    start = distance[distance <= distance[-1] - leg]
    change = np.abs(np.interp(start + leg, distance, course) - np.interp(start, distance, course))
    worst = int(np.argmax(change))
    note = f"course change over {leg:.3g} m"
    where = run.where(worst)
    return [planned, Metric("turn_angle_max_flown", float(change[worst]), "rad", note=note, **where)]


def turn_radii(run: Run) -> list[Metric]:
    """Smallest available radius [m], and the radius required and the margin at the turn with the smallest margin."""
    tightest = run.feasibility.tightest
    if tightest is None:
        note = "the path has no turns"
        return [
            Metric("turn_radius_min", math.nan, "m", "higher", valid=False, note=note),
            Metric("turn_radius_required", math.nan, "m", valid=False, note=note),
            Metric("turn_margin", math.nan, "m", "higher", valid=False, note=note),
        ]
    smallest = min(run.feasibility.turns, key=lambda turn: turn.available)
    return [
        Metric("turn_radius_min", smallest.available, "m", "higher", s=smallest.s),
        Metric("turn_radius_required", tightest.required, "m", s=tightest.s),
        Metric("turn_margin", tightest.margin, "m", "higher", s=tightest.s),
    ]


def corners(run: Run) -> list[Metric]:
    """Largest error [m] inside (cut) and outside (overshoot) of a turn, up to the middle of its simplified legs."""
    e, s, t = run.track["cross_track"], run.track["s"], run.track["t"]
    turns = run.feasibility.turns
    if not turns:
        note = "the path has no turns"
        return [Metric(name, math.nan, "m", valid=False, note=note) for name in ("corner_cut_max", "overshoot_max")]
    at = np.array([0.0, *(turn.s for turn in turns), run.path.length])
    middles = (at[:-1] + at[1:]) / 2
    middles[0], middles[-1] = -np.inf, np.inf
    side = np.array([math.copysign(1.0, turn.angle) for turn in turns])
    inside = e * side[np.clip(np.searchsorted(middles, s) - 1, 0, len(turns) - 1)]
    return [_largest("corner_cut_max", inside, s, t), _largest("overshoot_max", -inside, s, t)]


def _largest(name: str, error: Floats, s: Floats, t: Floats) -> Metric:
    worst = int(np.argmax(error))
    return Metric(name, max(float(error[worst]), 0.0), "m", s=float(s[worst]), t=float(t[worst]))
