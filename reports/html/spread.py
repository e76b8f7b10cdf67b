"""The trials of a case as numbers to plot: the band of the error along the path, and metrics of every trial."""

from __future__ import annotations

import numpy as np

from campaigns.statistics import Band
from campaigns.summary import CaseResult
from planners.kernel import Floats
from reports.files.json_result import Json
from reports.words.campaign_words import HEADLINE
from reports.words.names import listed
from reports.words.quantity import shown
from tracking.outcome import Outcome

_DIGITS = 5


def spread_data(result: CaseResult, outcome: Outcome) -> Json:
    """Band and metrics of a case of several trials; None for one that has but one trial with a path."""
    found = result.statistics
    if found.band is None:
        return None
    limits = {margin.requirement.metric: margin.requirement for margin in outcome.verdict.margins}
    names = dict.fromkeys(name for name in (HEADLINE, "cross_track_max", *limits) if name in found.names)
    metrics: list[Json] = []
    for name in names:
        factor, unit = shown(result.units[name][0])
        requirement = limits.get(name)
        metrics.append(
            {
                "words": listed(name),
                "unit": unit.strip(),
                "limit": None if requirement is None else factor * requirement.limit,
                "comparison": "" if requirement is None else requirement.comparison,
                "values": _short(factor * found.values[:, found.names.index(name)]),
            }
        )
    return {
        "trials": [*found.trials],
        "seeds": [str(seed) for seed in found.seeds],
        "length": outcome.path.length,
        "whose": "path of the worst trial" if result.case.replan else "path",
        "band": _band(found.band),
        "metrics": metrics,
    }


def _band(band: Band) -> Json:
    names = ("bias", "median", "low", "high", "p5", "p95")
    return {name: _short(getattr(band, name)) for name in names}


def _short(values: Floats) -> list[Json]:
    return [float(f"{value:.{_DIGITS}g}") if np.isfinite(value) else None for value in values]
