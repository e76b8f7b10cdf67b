"""aco-improved against OMPL's planners on nofly-1000x660, polyline against polyline, at equal wall time.

    python -m pip install ompl
    python tests/benchmarks/aco_against_ompl.py [SEEDS]

OMPL plans on the very cells that the ants plan on. Its collision checks come through Python, one call of our compiled
exact segment check a motion, so it is run at ten times the ants' wall time too.
"""

from __future__ import annotations

import sys
import time

import numpy as np

try:
    from ompl import base, geometric, util
except ModuleNotFoundError:
    sys.exit("this benchmark needs OMPL: python -m pip install ompl")

from planners.aco.improved import AcoImproved
from planners.ground import Ground
from planners.scenario import Scenario, load_scenario
from planners.segments import is_free

FIRST_SEED = 100
PEERS = ("RRTstar", "InformedRRTstar", "BITstar")


class Motions(base.MotionValidator):
    """Motions over the cells of a `Ground`."""

    def __init__(self, information: base.SpaceInformation, ground: Ground) -> None:
        super().__init__(information)
        self._blocked = ground.blocked

    def checkMotion(self, one: base.State, other: base.State, *_: object) -> bool:  # noqa: N802, OMPL's name
        return is_free(self._blocked, one[0], one[1], other[0], other[1])


def peer_length(name: str, ground: Ground, seconds: float) -> float:
    """Length [m] of the polyline that the planner has after so many seconds; NaN where it has none."""
    rows, columns = ground.blocked.shape
    space = base.RealVectorStateSpace(2)
    bounds = base.RealVectorBounds(2)
    for axis, size in enumerate((columns, rows)):
        bounds.setLow(axis, 0.0)
        bounds.setHigh(axis, np.nextafter(float(size), 0.0))
    space.setBounds(bounds)
    setup = geometric.SimpleSetup(space)
    information = setup.getSpaceInformation()
    setup.setStateValidityChecker(lambda state: not ground.blocked[int(state[1]), int(state[0])])
    information.setMotionValidator(Motions(information, ground))
    ends = [space.allocState(), space.allocState()]
    for state, place in zip(ends, (ground.start, ground.goal), strict=True):
        state[0], state[1] = float(place[0]), float(place[1])
    setup.setStartAndGoalStates(*ends)
    setup.setOptimizationObjective(base.PathLengthOptimizationObjective(information))
    setup.setPlanner(getattr(geometric, name)(information))
    setup.setup()
    setup.solve(seconds)
    if not setup.haveExactSolutionPath():
        return float("nan")
    return float(setup.getSolutionPath().length()) * ground.cell


def main(scenario: Scenario, seeds: int) -> None:
    """Print the ratios of our polyline to each peer's: median, least and greatest over the seeds."""
    util.noOutputHandler()
    planner = AcoImproved(smoothing=False)
    planner.plan(scenario, np.random.default_rng(0))
    ground = planner.ground(scenario)
    ratios: dict[tuple[str, int], list[float]] = {(name, times): [] for times in (1, 10) for name in PEERS}
    took = []
    for seed in range(FIRST_SEED, FIRST_SEED + seeds):
        start = time.perf_counter()
        ours = planner.plan(scenario, np.random.default_rng(seed)).polylines[0].length
        took.append(time.perf_counter() - start)
        for (name, times), found in ratios.items():
            theirs = peer_length(name, ground, times * took[-1])
            found.append(ours / theirs if theirs == theirs else 0.0)  # one without a path is infinitely long
    print(f"aco-improved: {np.median(took):.3f} s a plan in median of {seeds} seeds")
    print("polyline of aco-improved over that of OMPL's, median (least to greatest):")
    for (name, times), found in ratios.items():
        print(f"  {name:<16} {times:>2} x the time: {np.median(found):.4f} ({min(found):.4f} to {max(found):.4f})")


if __name__ == "__main__":
    main(load_scenario("nofly-1000x660"), int(sys.argv[1]) if len(sys.argv) > 1 else 20)
