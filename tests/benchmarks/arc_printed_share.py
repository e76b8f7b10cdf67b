"""How often paper 004's A* by arcs, as printed, finds a path: from random starts to random goals on our two maps.

    python tests/benchmarks/arc_printed_share.py

Start and goal are free pixels, at least a third of the map apart, the same for every speed. Those that no free pixels
join are not counted. It takes some two minutes, most of them for the exact paths.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from planners.all_planners import make_planner, plan_with
from planners.facts import facts_of
from planners.occupancy import cell_centres
from planners.scenario import Scenario, load_scenario

PAIRS, YARDSTICKS, SEED = 500, 40, 20260
EMPTY = "empty"  # the larger map without its obstacles


def scenarios(name: str) -> list[Scenario]:
    """The scenario with starts and goals drawn anew."""
    known = load_scenario("target-vehicle-640m" if name == EMPTY else name)
    raster, rng = known.map.raster, np.random.default_rng(SEED)
    assert raster is not None
    free = cell_centres(raster)[~raster.blocked]
    area = replace(known.map, raster=None) if name == EMPTY else known.map
    drawn = []
    while len(drawn) < PAIRS:
        start, goal = free[rng.integers(len(free), size=2)]
        if np.hypot(*(goal - start)) >= known.size[0] / 3.0:
            drawn.append(replace(known, map=area, starts=start[None], goals=goal[None]))
    return drawn


def main() -> None:
    """Print a line for each map and speed."""
    for name in (EMPTY, "target-vehicle-71m", "target-vehicle-640m"):
        drawn = scenarios(name)
        for kmh in (30, 45, 60):
            planner = make_planner("astar-arc-paper", {"speed": f"{kmh}km/h"})
            plans = [plan_with(planner, one, 0) for one in drawn]
            found = [(plan, one) for plan, one in zip(plans, drawn, strict=True) if plan.paths]
            lost = sum(plan.outcome == "no path" for plan in plans)
            ratios = [facts_of(plan, planner, one, 0).length_ratio or np.nan for plan, one in found[:YARDSTICKS]]
            turn = max(float(np.degrees(np.abs(plan.paths[0].turns).max())) for plan, _ in found)
            over = f"over the exact path, of the first {len(ratios)}: median {np.median(ratios):.4f}"
            print(
                f"{name:20} {kmh} km/h: {len(found)} of {len(drawn) - lost} found; {over}, worst {max(ratios):.3f}; "
                f"largest turn {turn:.1f} deg"
            )


if __name__ == "__main__":
    main()
