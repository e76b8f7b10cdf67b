"""The cross-track error along the path, in as many pieces for every run, so that runs can be laid over each other."""

from __future__ import annotations

import numpy as np

from planners.kernel import Floats
from tracking.metrics.errors import cross_track_errors
from tracking.outcome import Outcome
from tracking.run import Run

PIECES = 100  # of equal arc length


def error_profile(outcome: Outcome) -> Floats:
    """Mean signed cross-track error [m] of each of `PIECES` equal pieces of the path (PIECES,).

    Path that was not reached counts with its distance to what was flown. A piece between two samples takes the value
    between them. Of a fleet, each piece has the error of the vehicle that is farthest off its own path there.
    """
    if outcome.fleet is not None:
        profiles = np.array([_profile(member) for member in outcome.fleet.members])
        return np.asarray(profiles[np.abs(profiles).argmax(axis=0), np.arange(PIECES)])
    return _profile(outcome)


def _profile(outcome: Outcome) -> Floats:
    run = Run(
        outcome.path, outcome.track, outcome.limits, outcome.speed, outcome.corridor, outcome.conditions,
        outcome.feasibility,
    )  # fmt: skip
    errors = cross_track_errors(run)
    piece = np.clip(errors.s / outcome.path.length * PIECES, 0, PIECES - 1).astype(int)
    weight = np.bincount(piece, errors.weight, PIECES)
    total = np.bincount(piece, errors.weight * errors.e, PIECES)
    known = np.flatnonzero(weight > 0.0)
    if len(known) == 0:
        return np.full(PIECES, float(errors.e[0]))
    return np.interp(np.arange(PIECES), known, total[known] / weight[known])
