"""Grid A* against pyastar2d and pathfinding: the same cells, the same ends, in turns in one process.

python -m pip install pyastar2d pathfinding
python tests/benchmarks/grid_against_peers.py [RUNS]

pyastar2d (C++) cuts corners and counts a diagonal as one side, pathfinding (Python) does as astar-eight does. Times are
medians of the processor's: of the search alone, on cells made before, and of all from a scenario to its path; for
astar-arc, all with its field of distances, heuristic and smooth path, on the same maps with their own starts and goals.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

try:
    import pyastar2d
    from pathfinding.core.diagonal_movement import DiagonalMovement
    from pathfinding.core.grid import Grid
    from pathfinding.finder.a_star import AStarFinder
except ModuleNotFoundError:
    sys.exit("this benchmark needs its peers: python -m pip install pyastar2d pathfinding")

sys.path.insert(0, str(Path(__file__).parents[1]))

from grid_maps import maze, on_cells
from planners.all_planners import make_planner, plan_with
from planners.astar.grid import shortest_way
from planners.astar.grid_kernels import DIAGONAL, SIDE
from planners.kernel import Bools
from planners.scenario import BUILT_IN_SCENARIOS, Scenario, load_scenario

PLANNERS: dict[str, dict[str, Any]] = {  # names with settings; what is added here is timed and listed too
    "astar-four": {},
    "astar-eight": {},
    "astar-eight cut_corners": {"cut_corners": True},
}
SEARCHES = {
    "four, search alone": (4, 2 * SIDE, False),
    "eight, search alone": (8, DIAGONAL, False),
    "eight cut_corners, search alone": (8, DIAGONAL, True),
}
SLOW = 3  # runs of what is written in Python

Cell = tuple[int, int]


def scenarios() -> dict[str, Scenario]:
    """The maps, with start and goal at the centres of cells."""
    found = {}
    for name in ("target-vehicle-71m", "target-vehicle-640m"):
        scenario = load_scenario(name)
        raster = scenario.map.raster
        assert raster is not None
        ends = [(places[0] // raster.cell).astype(int)[::-1] for places in (scenario.starts, scenario.goals)]
        on_grid = on_cells(raster.blocked, tuple(ends[0]), tuple(ends[1]), raster.cell)
        found[name] = replace(on_grid, name=name)
    corridors = maze(np.random.default_rng(1), 255)
    found["maze of 511 x 511"] = on_cells(corridors, (1, 1), (509, 509))
    return found


def contenders(scenario: Scenario) -> dict[str, Callable[[], float]]:
    """By name, what plans once and gives the length in cells."""
    raster = scenario.map.raster
    assert raster is not None
    blocked, cell = raster.blocked, raster.cell
    start, goal = ((int(y // cell), int(x // cell)) for x, y in (scenario.starts[0], scenario.goals[0]))
    ours: dict[str, Callable[[], float]] = {}
    for label, kind in SEARCHES.items():
        ours[label] = lambda kind=kind: _length(shortest_way(blocked, start[::-1], goal[::-1], *kind))
    for label, settings in PLANNERS.items():
        planner = make_planner(label.split()[0], settings)
        ours[label] = lambda planner=planner: plan_with(planner, scenario, 0).paths[0].length / cell
    if scenario.name in BUILT_IN_SCENARIOS:
        whole = load_scenario(scenario.name)
        for kmh in (30, 45, 60):
            arc = make_planner("astar-arc", {"speed": f"{kmh}km/h"})
            ours[f"astar-arc, {kmh} km/h"] = lambda arc=arc: plan_with(arc, whole, 0).paths[0].length / cell
    return {**ours, **_peers(blocked, start, goal)}


def _peers(blocked: Bools, start: Cell, goal: Cell) -> dict[str, Callable[[], float]]:
    weights = np.where(blocked, np.inf, 1.0).astype(np.float32)
    grid = Grid(matrix=(~blocked).astype(int))

    def pathfinding(diagonal: DiagonalMovement) -> float:
        grid.cleanup()
        ends = (grid.node(end[1], end[0]) for end in (start, goal))
        way, _ = AStarFinder(diagonal_movement=diagonal).find_path(*ends, grid)
        return _length(np.array([(node.x, node.y) for node in way]))

    return {
        "pyastar2d": lambda: _length(pyastar2d.astar_path(weights, start, goal, allow_diagonal=True)),
        "pyastar2d, four": lambda: _length(pyastar2d.astar_path(weights, start, goal, allow_diagonal=False)),
        "pathfinding, eight": lambda: pathfinding(DiagonalMovement.only_when_no_obstacle),
        "pathfinding, four": lambda: pathfinding(DiagonalMovement.never),
    }


def _length(way: Any) -> float:
    return math.fsum(np.hypot(*np.diff(np.asarray(way, dtype=float), axis=0).T).tolist())


def main(runs: int) -> None:
    """Print a table a map."""
    for name, scenario in scenarios().items():
        known = contenders(scenario)
        lengths = {label: plan() for label, plan in known.items()}  # and compile
        took: dict[str, list[float]] = {label: [] for label in known}
        for run in range(runs):
            for label, plan in known.items():
                if run < SLOW or not label.startswith("pathfinding"):
                    start = time.process_time()
                    plan()
                    took[label].append(1e3 * (time.process_time() - start))
        medians = {label: float(np.median(times)) for label, times in took.items()}
        print(f"\n{name}, {runs} runs")
        print(f"{'':<34}{'length':>12}{'time':>10}{'/ pyastar2d':>13}{'/ pathfinding':>15}")
        print(f"{'':<34}{'cells':>12}{'ms':>10}{'':>13}{'':>15}")
        for label, median in medians.items():
            to_c, to_python = (median / medians[peer] for peer in ("pyastar2d", "pathfinding, eight"))
            print(f"{label:<34}{lengths[label]:>12.3f}{median:>10.2f}{to_c:>13.2f}{to_python:>15.4f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 21)
