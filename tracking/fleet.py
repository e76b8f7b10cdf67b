"""A fleet: vehicles that fly at the same clock, judged together and on the distance between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from tracking.departures import delays
from tracking.metric import Metric, Requirement
from tracking.outcome import Fleet, Outcome
from tracking.requirements import default_requirements, split_requirement, with_user_requirements
from tracking.separation import Separation, separation, separation_min
from tracking.verdict import judge

Departures = Literal["together", "separated"]
SPARE = 1.001  # of the separation that delays are found for: distances are then looked at more closely
FLEET_METRICS = ("separation_min", "departure_delay_max")


def fleet_outcome(
    name: str,
    members: Sequence[Outcome],
    departures: Departures,
    required: float,
    require: Sequence[str],
) -> Outcome:
    """The outcome of a fleet of `members`, two or more, which keep apart by nothing but their departures.

    They leave `together`, or are `separated` by the delays with the least waiting in all that keep them `required` [m]
    apart. Vehicles do not feel each other, so each track is what it is alone, later by its delay. Metrics are those of
    the worst member each; `require` holds requirements as the user writes them.
    """
    tracks = [member.track for member in members]
    wanted = _wanted(required, require)
    at_once = (0.0,) * len(members)
    leaving = delays(tracks, SPARE * wanted) if departures == "separated" else at_once
    apart = separation(tracks, leaving)
    metrics = _worst_of(members) | {metric.name: metric for metric in _between(apart, leaving)}
    first = members[0]
    own = (Requirement("separation_min", ">=", required, "the vehicle's own"),) if required > 0.0 else ()
    defaults = (*default_requirements(first.limits, first.corridor, first.obstacles is not None), *own)
    verdict = judge(metrics, with_user_requirements(defaults, require, metrics), first.verdict.expect)
    decisive = verdict.decisive
    member = int((decisive.metric.who if decisive else "").partition(" ")[0] or 1) - 1
    remedy = delays(tracks, SPARE * wanted) if metrics["separation_min"].value < wanted else ()
    fleet = Fleet(tuple(members), leaving, apart, member, wanted, remedy)
    return replace(members[member], name=name, seed=first.seed, metrics=metrics, verdict=verdict, fleet=fleet)


def member_seed(seed: int, member: int) -> int:
    """The seed of what is random about a member, from 0, of the fleet flown with `seed`: its own air and sensors."""
    if member == 0:
        return seed
    return int(np.random.SeedSequence([seed, member]).generate_state(1, np.uint64)[0] >> np.uint64(11))


def _wanted(required: float, require: Sequence[str]) -> float:
    """The separation [m] that is required: the user's, else `required`."""
    stated = with_user_requirements(
        (), [text for text in require if split_requirement(text)[0] == "separation_min"],
        {"separation_min": Metric("separation_min", math.nan, "m", "higher")},
    )  # fmt: skip
    return max((one.limit for one in stated if one.comparison == ">="), default=required)


def _between(apart: Separation, departures: Sequence[float]) -> list[Metric]:
    """What no vehicle has alone."""
    last = int(np.argmax(departures))
    delay = Metric("departure_delay_max", departures[last], "s", who=str(last + 1) if departures[last] else "")
    return [separation_min(apart), delay]


def _worst_of(members: Sequence[Outcome]) -> dict[str, Metric]:
    """Each metric of the member where it is worst; the largest by size where it is neither better nor worse.

    A member without it, as a straight path without turns, does not count.
    """
    found = {}
    for name in members[0].metrics:
        own = [replace(member.metrics[name], who=str(i)) for i, member in enumerate(members, start=1)]
        known = [metric for metric in own if metric.valid] or own
        if own[0].better == "higher":
            found[name] = min(known, key=lambda metric: metric.value)
        elif own[0].better == "lower":
            found[name] = max(known, key=lambda metric: metric.value)
        else:
            found[name] = max(known, key=lambda metric: abs(metric.value))
    return found
