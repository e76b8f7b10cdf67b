"""The seam of the planners: a scenario and a seed in, paths and what the search was like out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np

from planners.errors import InputError
from planners.kernel import Bools, Floats, Ints
from planners.path import Path
from planners.scenario import Scenario

NO_PATH, NOT_FOUND = "no path", "not found"  # the map allows none; the search found none, which proves nothing


@dataclass(frozen=True, slots=True, eq=False)
class Swarm:
    """Where everyone was in one iteration: the ways `points` (N, 2) [m] one after the other.

    That of individual i is `points[first[i]:first[i + 1]]`; `alive` (A,) says whether it arrived.
    """

    points: Floats
    first: Ints
    alive: Bools


@dataclass(frozen=True, slots=True, eq=False)
class History:
    """A search by iteration: `best` and `mean` (I,) length of the ways that arrived then [m], NaN where none did.

    `survivors` (I,) counts those, of `population`; `swarms` holds their ways.

    Of swarms that search for a fleet, `best` and `mean` are summed over the aircraft, `best` is that of the cheapest so
    far, and `survivors` are the pigeons that keep to all limits. `evaluations` (I,) counts the paths given a cost by
    then, and `cost` (I,) [m] is the least one so far, which also counts what breaks a limit; None for colonies.
    """

    best: Floats
    mean: Floats
    survivors: Ints
    population: int
    swarms: tuple[Swarm, ...] = ()
    evaluations: Ints | None = None
    cost: Floats | None = None

    @property
    def converged(self) -> int | None:
        """The first iteration, from 1, whose best is within 1 % of the best of all; None where nothing arrived."""
        if not np.isfinite(self.best).any():
            return None
        return int(np.argmax(self.best <= 1.01 * np.nanmin(self.best))) + 1


@dataclass(frozen=True, slots=True, eq=False)
class Stage:
    """The paths as they were after one step of planning, called `name`."""

    name: str
    paths: tuple[Path, ...]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Plan:
    """What a planner gave.

    `paths` holds one for each start that has a goal, in the order of the starts; none where there is none, and then
    `outcome` is `NO_PATH` or `NOT_FOUND` and `reason` says why in one line. `stages` are how they came to be, in order,
    for planners that work in steps; without `paths`, how far it came. `polylines` are the paths before they were
    smoothed, `notes` one line each on what the user should know. `smallest_radius` [m] is that of the tightest curve,
    None for a path with corners.
    """

    paths: tuple[Path, ...] = ()
    polylines: tuple[Path, ...] = ()
    outcome: str = ""
    reason: str = ""
    notes: tuple[str, ...] = ()
    smallest_radius: float | None = None
    history: History | None = None
    stages: tuple[Stage, ...] = ()


class Planner(Protocol):
    """A frozen struct of settings, each with a default: lengths that belong to the map in map units, those that belong
    to the vehicle in metres. `summary` is what `trackworthy list planners` says.

    `clearance` [m] is how far its paths keep from all that is forbidden.
    """

    name: ClassVar[str]
    summary: ClassVar[str]

    @property
    def clearance(self) -> float:
        """How far [m] from obstacles; 0 for a point."""

    def plan(self, scenario: Scenario, rng: np.random.Generator) -> Plan:
        """Plan. Raises `InputError` for a scenario that cannot be planned on, as with a start in an obstacle."""


def only_pair(scenario: Scenario, planner: str) -> tuple[Floats, Floats]:
    """Start and goal (2,) [m] of a scenario that has one of each, in two places; raises `InputError` for any other."""
    starts, goals = len(scenario.starts), len(scenario.goals)
    if starts != 1 or goals != 1:
        what = f"it has {starts} starts and {goals} goals, and {planner} plans from one to one"
        raise InputError(scenario.name, what, "leave one of each")
    if (scenario.starts[0] == scenario.goals[0]).all():
        raise InputError(scenario.name, "its start is its goal", "move one of them")
    return scenario.starts[0], scenario.goals[0]
