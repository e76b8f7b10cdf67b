"""What each improvement of aco-improved is worth: each switched off by itself, on nofly-1000x660.

python tests/benchmarks/aco_ablation.py [SEEDS]
"""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np

from planners.all_planners import make_planner, plan_with
from planners.facts import exact_length
from planners.scenario import load_scenario

FIRST_SEED = 100
ABLATIONS: dict[str, dict[str, Any]] = {
    "as it is": {},
    "8 neighbours (step 1)": {"step": 1, "sampling": 1},
    "cells of 4 x 4": {"cell": 4.0, "step": 2},
    "no biased roulette (bias 0)": {"bias": 0.0},
    "no equivalent pheromone (radius 0)": {"observation_radius": 0},
    "pheromone on nodes only": {"pheromone_on": "nodes"},
    "no pruning": {"pruning": False},
    "no pruning, pheromone on nodes": {"pruning": False, "pheromone_on": "nodes"},
    "not pulled taut": {"taut": False},
    "no alert zone": {"alert_zone": False},
    "no smoothing": {"smoothing": False},
}


def main(seeds: int) -> None:
    """Print a row an ablation, medians over the seeds."""
    scenario = load_scenario("nofly-1000x660")
    exact = exact_length(scenario, 20.0) or np.nan
    print(f"{'':<36}{'found':>6}{'polyline':>10}{'path':>8}{'radius':>8}{'survivors':>15}{'to 1 %':>7}{'time':>8}")
    print(f"{'':<36}{'':>6}{'/ exact':>10}{'/ exact':>8}{'units':>8}{'first    last':>15}{'iter.':>7}{'s':>8}")
    for name, settings in ABLATIONS.items():
        planner = make_planner("aco-improved", settings)
        plan_with(planner, scenario, 0)
        plans, took = [], []
        for seed in range(FIRST_SEED, FIRST_SEED + seeds):
            start = time.perf_counter()
            plans.append(plan_with(planner, scenario, seed))
            took.append(time.perf_counter() - start)
        found = [plan for plan in plans if plan.paths]
        histories = [plan.history for plan in plans if plan.history]
        row = [
            _median([plan.polylines[0].length / exact for plan in found]),
            _median([plan.paths[0].length / exact for plan in found]),
            _median([(plan.smallest_radius or 0.0) / scenario.unit for plan in found]),
        ]
        first, last = (_median([history.survivors[i] for history in histories]) for i in (0, -1))
        converged = _median([history.converged or np.nan for history in histories])
        print(
            f"{name:<36}{len(found):>3}/{seeds:<2}{row[0]:>10.4f}{row[1]:>8.4f}{row[2]:>8.1f}"
            f"{first:>7.0f}{last:>8.0f}{converged:>7.0f}{np.median(took):>8.3f}"
        )


def _median(values: list[Any]) -> float:
    return float(np.nanmedian(values)) if len(values) and not np.isnan(values).all() else float("nan")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
