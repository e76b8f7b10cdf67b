"""GCCPIO and PIO against opytimizer's PIO and pyswarms' PSO: the same cost, the same number of evaluations.

pip install --no-deps 'opytimizer==3.1.4' pyswarms dill networkx opytimark tqdm attrs future pyyaml
python tests/benchmarks/pigeon_against_peers.py [SEEDS]

Cost is the length and what breaks a limit, as while searching, summed over the three aircraft. PSO starts from our
first pigeons; opytimizer draws its own, evenly from the box around ours.
"""

from __future__ import annotations

import logging
import sys
import time
from collections.abc import Callable

import numpy as np

from planners.all_planners import make_planner
from planners.kernel import Floats
from planners.pio.course import Course
from planners.pio.search import search
from planners.pio.vdp import VdpPio
from planners.scenario import Scenario, load_scenario
from planners.voronoi.planned import Planned, planned

FIRST_SEED = 100
PIGEONS = 300


def ours(name: str, pigeons: int) -> Callable[[Course, Floats, int], tuple[float, int]]:
    """One of our planners' searches: best cost and evaluations."""
    planner = make_planner(name, {"pigeons": pigeons})
    assert isinstance(planner, VdpPio)

    def run(course: Course, path: Floats, seed: int) -> tuple[float, int]:
        rng = np.random.default_rng(seed)
        seen = search(course, *planner.flock(course, path, rng), rng, planner)
        return seen.best_cost, seen.evaluated

    return run


def pso(course: Course, path: Floats, seed: int, evaluations: int) -> float:
    """The global-best PSO of pyswarms, with its textbook factors."""
    import pyswarms

    np.random.seed(seed)  # noqa: NPY002, pyswarms has no other
    first = VdpPio(pigeons=PIGEONS).flock(course, path, np.random.default_rng(seed))[0]
    swarm = pyswarms.single.GlobalBestPSO(
        PIGEONS, course.dimensions, {"c1": 1.49618, "c2": 1.49618, "w": 0.7298}, init_pos=first
    )
    return float(swarm.optimize(lambda x: course.judge(x).cost, round(evaluations / PIGEONS), verbose=False)[0])


def opytimizer_pio(course: Course, path: Floats, seed: int, evaluations: int) -> float:
    """The PIO of opytimizer, with its own factors; four fifths of the iterations by the compass, as in the paper."""
    from opytimizer import Opytimizer
    from opytimizer.core import Function
    from opytimizer.optimizers.swarm import PIO
    from opytimizer.spaces import SearchSpace

    np.random.seed(seed)  # noqa: NPY002, opytimizer has no other
    first = VdpPio(pigeons=PIGEONS).flock(course, path, np.random.default_rng(seed))[0]
    low, high = first.min(axis=0).tolist(), first.max(axis=0).tolist()
    iterations = round(evaluations / PIGEONS)
    space = SearchSpace(PIGEONS, course.dimensions, low, high)
    cost = Function(lambda x: float(course.judge(np.ascontiguousarray(x.reshape(1, -1))).cost[0]))
    search_with = PIO({"n_c1": round(0.8 * iterations), "n_c2": iterations, "R": 0.5})
    task = Opytimizer(space, search_with, cost)
    task.start(n_iterations=iterations)
    return float(space.best_agent.fit)


def main(seeds: int) -> None:
    """Print time and cost of each over those of GCCPIO."""
    logging.disable(logging.CRITICAL)
    for name in ("mars-hazards-15", "mars-hazards-25"):
        compare(name, load_scenario(name), seeds)


def compare(name: str, scenario: Scenario, seeds: int) -> None:
    """The table of one scenario."""
    planner = VdpPio()
    found = planned(scenario, planner, "vdp", keep_turns=False)
    assert isinstance(found, Planned)
    pairs = list(zip(planner.courses(found, scenario.unit), (one.short for one in found.chosen), strict=True))
    gccpio = ours("vdp", PIGEONS)
    spent = gccpio(*pairs[0], 0)[1]
    pigeons = round(PIGEONS * spent / ours("vdp-pio", PIGEONS)(*pairs[0], 0)[1])
    pio = ours("vdp-pio", pigeons)
    runs: dict[str, Callable[[Course, Floats, int], float]] = {
        "GCCPIO": lambda *one: gccpio(*one)[0],
        "PIO": lambda *one: pio(*one)[0],
        "pyswarms' PSO": lambda *one: pso(*one, spent),
        "opytimizer's PIO": lambda *one: opytimizer_pio(*one, spent),
    }
    print(f"\n{name}: {spent} evaluations an aircraft, {seeds} seeds from {FIRST_SEED}")
    print(f"{'':<20}{'cost, median':>14}{'of GCCPIO':>11}{'(worst)':>10}{'time [s]':>10}{'of GCCPIO':>11}")
    first: tuple[Floats, float] | None = None
    for label, run in runs.items():
        costs, took = np.empty(seeds), np.empty(seeds)
        for i in range(seeds):
            start = time.perf_counter()
            costs[i] = sum(run(course, path, FIRST_SEED + i) for course, path in pairs)
            took[i] = time.perf_counter() - start
        first = first or (costs, float(np.median(took)))
        ratio = costs / first[0]
        print(
            f"{label:<20}{np.median(costs):>14.2f}{np.median(ratio):>11.4f}{ratio.max():>10.4f}"
            f"{np.median(took):>10.2f}{np.median(took) / first[1]:>11.1f}"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
