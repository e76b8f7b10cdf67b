"""Pigeon-inspired optimisation: the map and compass operator, the landmark operator, and what GCCPIO adds to them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from planners.kernel import Floats
from planners.pio.course import Course, Joint, Judged
from planners.pio.settings import Pigeons

TINY = 1e-12


@dataclass(slots=True, eq=False)
class Search:
    """What a swarm has seen: its `best` position by cost; `found` are those that keep every limit and cost less than
    any such before, in their order, and `shortest` is the length of the last. The lists are by iteration, as in
    `History`.
    """

    course: Course | Joint
    best: Floats = field(default_factory=lambda: np.empty(0))
    best_cost: float = math.inf
    found: list[Floats] = field(default_factory=list)
    found_cost: float = math.inf
    shortest: float = math.inf
    evaluated: int = 0
    costs: list[float] = field(default_factory=list)
    lengths: list[float] = field(default_factory=list)
    means: list[float] = field(default_factory=list)
    survivors: list[int] = field(default_factory=list)
    evaluations: list[int] = field(default_factory=list)

    def look(self, positions: Floats) -> Judged:
        """Judge `positions` (N, D), and remember the best."""
        told = self.course.judge(positions)
        self.evaluated += len(positions) * self.course.paths
        least = int(np.argmin(told.cost))
        if told.cost[least] < self.best_cost:
            self.best_cost, self.best = float(told.cost[least]), positions[least].copy()
        costs = np.where(told.kept, told.cost, np.inf)
        least = int(np.argmin(costs))
        if costs[least] < self.found_cost:
            self.found_cost, self.shortest = float(costs[least]), float(told.length[least])
            self.found.append(positions[least].copy())
        return told

    def end_iteration(self, told: Judged) -> None:
        """Write down how it stands."""
        self.costs.append(self.best_cost)
        self.lengths.append(self.shortest if self.found else math.nan)
        self.means.append(float(told.length[told.kept].mean()) if told.kept.any() else math.nan)
        self.survivors.append(int(told.kept.sum()))
        self.evaluations.append(self.evaluated)


def search(
    course: Course | Joint, positions: Floats, velocities: Floats, rng: np.random.Generator, settings: Pigeons
) -> Search:
    """Let pigeons at `positions` (N, D) with `velocities` (N, D) search."""
    seen = Search(course)
    seen.look(positions)
    if settings.cauchy:
        mutate(seen, rng)
    for t in range(1, settings.compass_iterations + 1):
        velocities = steered(seen, positions, velocities, t, rng, settings)
        positions = course.clipped(positions + velocities)
        told = seen.look(positions)
        if settings.cauchy:
            mutate(seen, rng)
        seen.end_iteration(told)
    for _ in range(settings.landmark_iterations):
        positions, told = landed(seen, positions, told, rng)
        seen.end_iteration(told)
    return seen


def steered(
    seen: Search, positions: Floats, velocities: Floats, t: int, rng: np.random.Generator, settings: Pigeons
) -> Floats:
    """The velocities (N, D) of iteration `t`, from 1: eq. 7, or 14 with the communication factor, or 18 by gradient."""
    pull = rng.random(positions.shape) * (seen.best - positions)
    if settings.communication == "none":
        faster = velocities * math.exp(-settings.compass_factor * t) + pull
    else:
        inertia, communication = factors(t / settings.compass_iterations, settings)
        faster = inertia * velocities + communication * pull
    share = settings.gradient_share if settings.gradient else 0.0
    downhill = rng.permutation(len(positions))[: round(share * len(positions))]
    if len(downhill):
        slopes = seen.course.gradients(positions[downhill], settings.gradient_step)
        seen.evaluated += len(downhill) * (slopes.shape[1] + seen.course.paths)
        # eq. 18 divides by the gradient and multiplies by it again: its sign is left, and where it is 0, no velocity
        faster[downhill] = -np.sign(slopes) * np.abs(velocities[downhill])
    return np.asarray(faster)


def factors(share: float, settings: Pigeons) -> tuple[float, float]:
    """c1 and c2 (eq. 15, 16) at that share of the iterations.

    With the printed A, B, C and R, c2 runs from 0.30 to 1.26. The text says from 0 to 1: it is stretched to that.
    """

    def inertia(u: float) -> float:
        r = settings.compass_factor
        return settings.a * math.exp(-2.0 * r * u * u) + settings.b * math.exp(-r * u * u) + settings.c

    c1 = inertia(share)
    if settings.communication == "rescaled":
        c1 = (c1 - inertia(1.0)) / (inertia(0.0) - inertia(1.0))
    return c1, 1.0 - c1


def mutate(seen: Search, rng: np.random.Generator) -> None:
    """Multiply the best position by a Cauchy number, and keep what is better (eq. 12, 13).

    It scales a path about the straight line from start to goal, where all offsets are 0.
    """
    seen.look(seen.course.clipped(seen.best[None] * math.tan(math.pi * (rng.random() - 0.5))))


def landed(seen: Search, positions: Floats, told: Judged, rng: np.random.Generator) -> tuple[Floats, Judged]:
    """The better half of the pigeons, flown towards their centre (eq. 9 to 11).

    The centre is weighted by 1 / cost, as Guan et al. 2024 (Intelligence & Robotics) give it after Duan and Qiao 2014,
    where the least is sought; eq. 10 as printed weighs by the cost itself, and divides by the number of pigeons once
    more, which would pull to the straight line.
    """
    half = np.argsort(told.cost, kind="stable")[: (len(positions) + 1) // 2]
    positions, weights = positions[half], 1.0 / (told.cost[half] + TINY)
    centre = weights @ positions / weights.sum()
    positions = positions + rng.random(positions.shape) * (centre - positions)
    return positions, seen.look(positions)
