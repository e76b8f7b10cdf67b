"""Campaigns' results as figures across cases get them, made up from single runs: quick, and of any size."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from campaigns.attempt import Measured
from campaigns.case import Case
from campaigns.statistics import statistics
from campaigns.store import Row
from campaigns.summary import CaseResult
from reports.figures.scenario_cases import Run, ScenarioRuns, named
from tracking.outcome import Outcome
from tracking.profile import PIECES


def result_like(outcome: Outcome, number: int = 1, trials: int = 5, bad: int = 0, replan: bool = False) -> CaseResult:
    """A case like `outcome` of so many `trials`; the last `bad` of them miss the corridor."""
    rng = np.random.default_rng(number)
    rows = []
    for trial in range(1, trials + 1):
        worthy = trial <= trials - bad
        size = (0.4 + 0.02 * trial if worthy else 1.5 + 0.1 * trial) * outcome.corridor
        table = {name: Measured(m.value if m.valid else None, None, None) for name, m in outcome.metrics.items()}
        table |= {name: Measured(size, None, None) for name in ("cross_track_p95", "cross_track_max")}
        profile = (rng.normal(0.1, 0.2, PIECES) * outcome.corridor).astype(np.float32).tobytes()
        rows.append(
            Row(
                trial, trial, "", "", worthy, worthy, 1.0 - size / outcome.corridor, "cross_track_max", "completed",
                table, profile,
            )
        )  # fmt: skip
    better = {name: metric.better for name, metric in outcome.metrics.items()}
    units = {name: (metric.unit, metric.better) for name, metric in outcome.metrics.items()}
    stated = Case(
        vehicle=outcome.vehicle, name=outcome.name, trials=trials, speed=outcome.speed, controller=outcome.controller,
        replan=replan,
    )  # fmt: skip
    return CaseResult(number, stated, statistics(rows, better), units)


def runs_of(
    outcome: Outcome,
    sources: Sequence[str] = ("planner",),
    controllers: Sequence[str] = ("lqr",),
    speeds: Sequence[float] = (8.0,),
    trials: int = 5,
    name: str = "map",
    bad: int = 0,
    case: str = "",
) -> ScenarioRuns:
    """A case for every combination, each with the run of `outcome`."""
    runs = []
    for number, (source, controller, speed) in enumerate(
        ((a, b, c) for a in sources for b in controllers for c in speeds), start=1
    ):
        called = f"{case or name} {source} {controller} {speed:g}"
        one = dataclasses.replace(outcome, name=called, controller=controller, speed=speed)
        runs.append(Run(result_like(one, number, trials, bad if number % 2 else 0), one, source, ""))
    return ScenarioRuns(name, named(runs))


def unflown(runs: ScenarioRuns, count: int = 1) -> ScenarioRuns:
    """`runs` whose first `count` cases found no path."""
    return ScenarioRuns(
        runs.name,
        tuple(dataclasses.replace(run, outcome=None) if i < count else run for i, run in enumerate(runs.runs)),
    )
