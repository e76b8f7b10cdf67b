"""Outcomes with other verdicts than their own."""

import dataclasses

from tracking.feasibility import Feasibility
from tracking.metric import Metric, Requirement
from tracking.verdict import judge


def judged(outcome, *pairs, expect="trackworthy", turns=(), steep=(), **changes):
    """`outcome` with another verdict, on (metric, comparison, limit) triples."""
    metrics = {metric.name: metric for metric, _, _ in pairs}
    requirements = [Requirement(metric.name, comparison, limit) for metric, comparison, limit in pairs]
    changes |= {"metrics": metrics, "feasibility": Feasibility(turns, steep)}
    return dataclasses.replace(outcome, verdict=judge(metrics, requirements, expect), **changes)


def error(value, s=3410.0):
    return Metric("cross_track_max", value, "m", s=s, t=62.0)
