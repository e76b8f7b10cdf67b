"""Plans on the scenario nofly-1000x660 and searches that are made up, but look like real ones."""

from __future__ import annotations

import numpy as np

from planners.corners import fly_by
from planners.path import Path
from planners.planner import NOT_FOUND, History, Plan, Swarm

UNIT = 20.0  # [m] of a map unit there
CORNERS = [(30, 40), (90, 231), (111, 301), (252, 291), (360, 361), (470, 431), (560, 500), (685, 532), (800, 500),
           (909, 439), (945, 540), (970, 620)]  # fmt: skip


def made_up_plan(radius=400.0, iterations=30, ants=40, shift=0.0, seed=1):
    """A path around the obstacles, its corners rounded with `radius` [m], after a search of so many iterations."""
    polyline = Path(np.array(CORNERS) * UNIT + [0.0, shift])
    smooth, _ = fly_by(polyline, lambda *_: radius, 1.0)
    history = made_up_history(iterations, ants, polyline.length, seed)
    return Plan(paths=(smooth,), polylines=(polyline,), smallest_radius=radius, history=history)


def made_up_history(iterations=30, ants=40, length=25e3, seed=1):
    """Ways that get less crooked by iteration and die less often."""
    rng = np.random.default_rng(seed)
    swarms = [_swarm(rng, i / iterations, ants) for i in range(1, iterations + 1)]
    alive = [swarm.alive.sum() for swarm in swarms]
    steps = np.arange(1, iterations + 1)
    best = length * (1.0 + 0.5 / steps)
    mean = length * (1.05 + 1.5 / steps)
    mean[0] = best[0] = np.nan if iterations > 1 else length
    return History(best, mean, np.array(alive), ants, tuple(swarms))


def _swarm(rng, learned, ants):
    """Random walks about the made-up path, those that die end somewhere on it."""
    fine = Path(np.array(CORNERS) * UNIT).resample(100.0).xy
    ways, alive = [], rng.random(ants) < 0.3 + 0.69 * learned
    for lives in alive:
        walk = np.cumsum(rng.normal(0.0, 250.0 * (1.0 - 0.9 * learned), fine.shape), axis=0)
        walk -= np.linspace(0.0, 1.0, len(fine))[:, None] * walk[-1]
        ways.append((fine + walk)[: None if lives else rng.integers(5, len(fine))])
    first = np.concatenate([[0], np.cumsum([len(way) for way in ways])])
    return Swarm(np.concatenate(ways), first, alive)


def lost_plan(iterations=3, ants=5):
    """A search in which nothing arrived."""
    nothing, none = np.full(iterations, np.nan), np.zeros(iterations, dtype=np.int64)
    way = Swarm(np.full((2 * ants, 2), 600.0) + np.arange(2 * ants)[:, None], np.arange(0, 2 * ants + 1, 2),
                np.zeros(ants, dtype=bool))  # fmt: skip
    history = History(nothing, nothing, none, ants, (way,) * iterations)
    return Plan(outcome=NOT_FOUND, reason="no ant arrived in 3 iterations", history=history)
