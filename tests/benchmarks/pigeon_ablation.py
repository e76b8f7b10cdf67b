"""Paper 001's pigeons: what they reach, GCCPIO against PIO at equal cost evaluations, and what each strategy is worth.

python tests/benchmarks/pigeon_ablation.py [SEEDS]
"""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np
from scipy.stats import wilcoxon

from planners.all_planners import make_planner, plan_with
from planners.facts import PlanFacts, facts_of
from planners.scenario import Scenario, load_scenario

FIRST_SEED = 100  # those below were used for tuning
STRATEGIES = {"cauchy": False, "communication": "none", "gradient": False}
ABLATIONS: dict[str, dict[str, Any]] = {
    "GCCPIO": {},
    "no Cauchy mutation": {"cauchy": False},
    "no communication factor": {"communication": "none"},
    "factor as printed": {"communication": "printed"},
    "no gradient": {"gradient": False},
    "only Cauchy mutation": {**STRATEGIES, "cauchy": True},
    "only communication factor": {**STRATEGIES, "communication": "rescaled"},
    "only gradient": {**STRATEGIES, "gradient": True},
    "PIO": STRATEGIES,
    "one joint swarm": {"joint": True},
    "one joint swarm, as printed": {"joint": True, "communication": "printed"},
}


def facts(scenario: Scenario, settings: dict[str, Any], seeds: range) -> tuple[list[PlanFacts], float]:
    """Those of a plan a seed, and the median time of a plan [s]."""
    planner = make_planner("vdp", settings)
    plan_with(planner, scenario, 0)
    told, took = [], []
    for seed in seeds:
        start = time.perf_counter()
        plan = plan_with(planner, scenario, seed)
        took.append(time.perf_counter() - start)
        told.append(facts_of(plan, planner, scenario, seed))
    return told, float(np.median(took))


def at_equal_evaluations(scenario: Scenario, settings: dict[str, Any]) -> dict[str, Any]:
    """The settings with as many pigeons as cost what GCCPIO does, in as many iterations."""
    wanted = facts(scenario, {}, range(1))[0][0].evaluations[-1]
    spent = facts(scenario, settings, range(1))[0][0].evaluations[-1]
    return {**settings, "pigeons": round(300 * wanted / spent)}


def keeps_all(one: PlanFacts, scenario: Scenario) -> bool:
    """Whether all three aircraft keep range, turn and clearance, by the exact geometry of the facts."""
    return (
        len(one.lengths) == len(scenario.starts)
        and (one.longest or np.inf) <= (scenario.max_range or np.inf)
        and (one.turn_angle_max_deg or 0.0) <= np.degrees(scenario.max_turn_angle or np.pi)
        and (one.clearance_min or 0.0) >= scenario.unit - 1e-4
        and not one.notes
    )


def main(seeds: int) -> None:
    """Print a row an ablation; ratios are to the exact shortest sum without a clearance."""
    for name in ("mars-hazards-15", "mars-hazards-25"):
        scenario = load_scenario(name)
        exact = sum(path.length for path in plan_with(make_planner("exact"), scenario, 0).paths)
        print(f"\n{name}: exact shortest sum {exact / scenario.unit:.2f} map units, {seeds} seeds from {FIRST_SEED}")
        print(f"{'':<30}{'pigeons':>8}{'keep all':>9}{'sum / exact':>18}{'turn [deg]':>14}{'time':>7}{'p':>10}")
        print(f"{'':<30}{'':>8}{'':>9}{'median    worst':>18}{'median  max':>14}{'s':>7}{'Wilcoxon':>10}")
        best: list[float] = []
        for label, plain in ABLATIONS.items():
            settings = at_equal_evaluations(scenario, plain) if plain else plain
            told, took = facts(scenario, settings, range(FIRST_SEED, FIRST_SEED + seeds))
            # one that finds nothing is as bad as can be
            ratios = [(one.length or np.inf) / exact for one in told]
            turns = [one.turn_angle_max_deg or np.nan for one in told]
            best = best or ratios
            p = wilcoxon(best, ratios, alternative="less").pvalue if plain else np.nan
            kept = sum(keeps_all(one, scenario) for one in told)
            print(
                f"{label:<30}{settings.get('pigeons', 300):>8}{kept:>6}/{seeds:<2}{np.median(ratios):>9.4f}"
                f"{max(ratios):>9.4f}{np.nanmedian(turns):>8.1f}{np.nanmax(turns):>6.1f}{took:>7.2f}{p:>10.1e}"
            )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
