"""Results of cases as if they had been run: metrics by trial, as a test states them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from campaigns.attempt import Measured
from campaigns.case import Case
from campaigns.statistics import statistics
from campaigns.store import Row
from campaigns.summary import CaseResult
from tracking.profile import PIECES

UNITS = {
    "cross_track_p95": ("m", "lower"),
    "cross_track_max": ("m", "lower"),
    "completion": ("share", "higher"),
    "clearance_min": ("m", "higher"),
    "track_length": ("m", "neither"),
    "bank_max": ("rad", "lower"),
}


def made_result(
    metrics: dict[str, Sequence[float]],
    worthy: Sequence[bool] | None = None,
    seeds: Sequence[int] | None = None,
    number: int = 1,
    errors: int = 0,
    **case: Any,
) -> CaseResult:
    """A case of as many trials as each of `metrics` has values, the last `errors` of which failed to run."""
    count = len(next(iter(metrics.values())))
    rows = []
    for i in range(count):
        table = {name: Measured(values[i], None, None) for name, values in metrics.items()}
        good = worthy is None or worthy[i]
        profile = np.zeros(PIECES, np.float32).tobytes()
        seed = i + 1 if seeds is None else seeds[i]
        failed = "it fell over" if i >= count - errors else ""
        rows.append(
            Row(i + 1, seed, failed, "machinery" if failed else "", good, good, 0.5, "", "completed", table, profile)
        )
    stated = Case(**{"vehicle": "truck", "path": "road.csv", "name": f"case {number}", "trials": count, **case})
    return CaseResult(number, stated, statistics(rows, {name: way for name, (_, way) in UNITS.items()}), UNITS)


def result_of(outcome, trials=8, bad=1, errors=0, number=1, **case):
    """A case like `outcome`: the last `bad` of its trials miss the corridor, and `errors` more did not run."""
    rng = np.random.default_rng(3)
    rows = []
    for trial in range(1, trials + 1):
        worthy, failed = trial <= trials - errors - bad, trial > trials - errors
        size = (0.4 + 0.02 * trial if worthy else 1.5 + 0.1 * trial) * outcome.corridor
        table = {name: Measured(m.value if m.valid else None, None, None) for name, m in outcome.metrics.items()}
        table |= {name: Measured(size, None, None) for name in ("cross_track_p95", "cross_track_max")}
        profile = rng.normal(0.1, 0.2, PIECES) * outcome.corridor
        rows.append(
            Row(
                trial,
                trial,
                "it fell over" if failed else "",
                "machinery" if failed else "",
                worthy,
                worthy,
                1.0 - size / outcome.corridor,
                "cross_track_max",
                "completed",
                table,
                profile.astype(np.float32).tobytes(),
            )
        )
    better = {name: metric.better for name, metric in outcome.metrics.items()}
    units = {name: (metric.unit, metric.better) for name, metric in outcome.metrics.items()}
    stated = Case(vehicle=outcome.vehicle, name=outcome.name, trials=trials, speed=outcome.speed, **case)
    return CaseResult(number, stated, statistics(rows, better), units)


def unplanned(name="lost", trials=1, reason="none of 9 ants arrived", **case):
    """A case whose planner found no path."""
    measured = {"completion": Measured(0.0, None, None)}
    rows = [Row(i, i, "", "", False, False, -1.0, "completion", reason, measured, b"") for i in range(1, trials + 1)]
    usual = {"vehicle": "truck", "planner": "exact", "scenario": "slalom-1000x600"}
    stated = Case(**(usual | case), name=name, trials=trials)
    units = {"completion": ("share", "higher")}
    return CaseResult(1, stated, statistics(rows, {"completion": "higher"}), units)
