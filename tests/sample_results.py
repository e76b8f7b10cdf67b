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
