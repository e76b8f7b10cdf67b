"""Controller against controller, planner against planner: the cases of a campaign that differ in nothing else."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from campaigns.difference import Difference, Sample, difference
from campaigns.gate import FALSE_ALARMS
from campaigns.limits import DEFAULT_LIMITS, Limit
from campaigns.settings import Settings, key_of, settings, without
from campaigns.summary import CaseResult
from planners.units import degrees

TRACKWORTHY_SHARE = "trackworthy"  # the share of the trials that are
HEADLINES = (
    TRACKWORTHY_SHARE, "completion", "cross_track_p95", "cross_track_max", "clearance_min", "separation_min",
    "track_length", "bank_max", "lateral_acceleration_max",
)  # fmt: skip
NO_DIRECTION_LIMIT = Limit(0.0, 0.01)  # a track that is 1 % longer is no news
COMPARED = ("controller", "planner", "vehicle")


@dataclass(frozen=True, slots=True)
class Spread:
    """A metric over the `count` trials that have it, in SI units; with one trial all are its value."""

    median: float
    p5: float
    p95: float
    count: int


@dataclass(frozen=True, slots=True)
class Member:
    """One case of a group, called `label` in it: its metrics, and how it does against the group's reference."""

    label: str
    result: CaseResult
    spreads: dict[str, Spread]
    differences: dict[str, Difference]


@dataclass(frozen=True, slots=True)
class Group:
    """Cases that differ only in `dimension`, and at most in what is required of them; `common` is what they share.

    The reference is the one with the largest share of trackworthy trials, among equals the one that completes most of
    the path, then the one with the smallest `cross_track_p95`. It is the best of those very trials, and so looks a
    little better than it is. Where the requirements are not `alike`, shares of trackworthy trials say little: they do
    not rank, and are not compared.
    """

    dimension: str
    common: Settings
    members: tuple[Member, ...]
    reference: int
    metrics: tuple[str, ...]
    alike: bool


def versus_groups(results: Sequence[CaseResult], limits: Mapping[str, Limit]) -> list[Group]:
    """Every group of two cases or more, controllers first, then planners, then vehicles; in the order of the cases.

    A group of which none had a path to follow is left out.

    Planners and path files are compared where they have a scenario in common. Differences are over trials of the same
    seed where there are such; chance may raise one false alarm in twenty of all that is compared here together.
    `limits` are what the campaign's own gate allows, beside the default ones.
    """
    grouped = [(dimension, group) for dimension in COMPARED for group in _groups(results, dimension)]
    count = sum((len(group) - 1) * len(_metrics(group)) for _, group in grouped)
    return [_group(dimension, group, limits, FALSE_ALARMS / max(1, count)) for dimension, group in grouped]


def samples(result: CaseResult) -> dict[str, Sample]:
    """The values of each headline metric that the case has, in SI units."""
    found = result.statistics
    told = {TRACKWORTHY_SHARE: Sample(found.worthy.astype(float), found.seeds)} if found.tried else {}
    for name in HEADLINES:
        if name in found.metrics:
            values = found.values[:, found.names.index(name)]
            known = np.flatnonzero(np.isfinite(values))
            told[name] = Sample(values[known], tuple(found.seeds[i] for i in known))
    return {name: told[name] for name in HEADLINES if name in told}


def unit_of(result: CaseResult, metric: str) -> tuple[str, str]:
    """The SI unit and the direction of a headline metric."""
    return ("share", "higher") if metric == TRACKWORTHY_SHARE else result.units[metric]


def held(before: CaseResult, after: CaseResult, limits: Mapping[str, Limit], chance: float) -> dict[str, Difference]:
    """How `after` does against `before`, by each headline metric that both have."""
    old, new = samples(before), samples(after)
    return {
        name: difference(name, *unit_of(after, name), old[name], new[name], _limit(after, name, limits), chance)
        for name in old
        if name in new
    }


def _limit(result: CaseResult, metric: str, limits: Mapping[str, Limit]) -> Limit:
    """What is too small to matter, in SI units: what the gate allows, by `limits` or by default."""
    if metric == TRACKWORTHY_SHARE:
        return Limit()
    stated = limits.get(metric) or DEFAULT_LIMITS.get(metric, NO_DIRECTION_LIMIT)
    return Limit(stated.absolute / degrees(1.0, unit_of(result, metric)[0])[0], stated.relative)


def _groups(results: Sequence[CaseResult], dimension: str) -> list[list[CaseResult]]:
    """The results that differ only in `dimension`, and there do."""
    found: dict[str, list[CaseResult]] = {}
    for result in results:
        stated = settings(result.case)
        if result.statistics.tried and (dimension != "planner" or stated["scenario"]):
            stated.pop("require")
            found.setdefault(key_of(without(stated, dimension)), []).append(result)
    return [
        group for group in found.values()
        if len({_name(one, dimension) for one in group}) > 1
        and any(one.statistics.no_path < one.statistics.tried for one in group)
    ]  # fmt: skip


def _name(result: CaseResult, dimension: str) -> str:
    """What a case is called in a group of that dimension."""
    stated = settings(result.case)
    if dimension != "planner":
        return str(stated[dimension])
    if "planner" not in stated:  # one of others, which is a table
        return result.case.name
    return str(stated["planner"] or stated["path"])


def _metrics(group: Sequence[CaseResult]) -> list[str]:
    """The headline metrics that any two of the group can be compared by."""
    found = [samples(result) for result in group]
    kept = HEADLINES if _alike(group) else HEADLINES[1:]
    return [name for name in kept if sum(name in one for one in found) > 1]


def _alike(group: Sequence[CaseResult]) -> bool:
    """Whether the same is required of all."""
    return len({frozenset(result.case.require) for result in group}) == 1


def _group(dimension: str, group: Sequence[CaseResult], limits: Mapping[str, Limit], chance: float) -> Group:
    names = [_name(result, dimension) for result in group]
    labels = [name if names.count(name) == 1 else group[i].case.name for i, name in enumerate(names)]
    alike, metrics = _alike(group), _metrics(group)
    best = min(range(len(group)), key=lambda i: _rank(group[i], alike))
    members = []
    for i, (label, result) in enumerate(zip(labels, group, strict=True)):
        found = {} if i == best else held(group[best], result, limits, chance)
        differences = {name: one for name, one in found.items() if name in metrics}
        members.append(Member(label, result, _spreads(result), differences))
    common = without(settings(group[0].case), dimension)
    return Group(dimension, common, tuple(members), best, tuple(metrics), alike)


def _rank(result: CaseResult, alike: bool) -> tuple[float, float, float]:
    """The smaller, the better."""
    means = {name: float(one.values.mean()) for name, one in samples(result).items()}
    share = -result.statistics.share if alike else 0.0
    return share, -means.get("completion", -np.inf), means.get("cross_track_p95", np.inf)


def _spreads(result: CaseResult) -> dict[str, Spread]:
    found = {}
    for name, one in samples(result).items():
        if name == TRACKWORTHY_SHARE:
            continue  # a share has no spread
        p5, median, p95 = (float(value) for value in np.percentile(one.values, [5, 50, 95]))
        found[name] = Spread(median, p5, p95, len(one.values))
    return found
