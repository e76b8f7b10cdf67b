"""The tracks that lie in a results folder besides those of the worst trials, one at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from campaigns.conditions import draw
from campaigns.finished import Finished
from campaigns.summary import CaseResult
from campaigns.tracks import read_tracks
from planners.errors import InputError
from reports.words.fleet_words import GROUND
from tracking.outcome import Outcome


@dataclass(frozen=True, slots=True)
class Kept:
    """A trial whose track lies in `file`."""

    result: CaseResult
    trial: int
    seed: int
    file: Path


def kept_trials(finished: Finished) -> list[Kept]:
    """Every trial with a track that is not the worst of its case: the first of every case, then the second, ..."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    by_name = {result.case.name: result for result in finished.results if result.case.name in finished.outcomes}
    found: dict[str, list[Kept]] = {}
    for file in sorted((finished.folder / "tracks").glob("*.parquet")):
        try:
            about = pq.read_schema(file).metadata or {}
            name, trial, seed = about[b"case"].decode(), int(about[b"trial"]), int(about[b"seed"])
        except (OSError, pa.ArrowException, KeyError, ValueError):
            continue  # a damaged track of a trial that is no case's worst: the rest is shown
        result = by_name.get(name)
        if result is not None and result.worst is not None and result.worst.trial != trial:
            found.setdefault(name, []).append(Kept(result, trial, seed, file))
    ranked = [
        (rank, kept.result.number, kept)
        for trials in found.values()
        for rank, kept in enumerate(sorted(trials, key=lambda kept: kept.trial))
    ]
    return [kept for _, _, kept in sorted(ranked, key=lambda one: one[:2])]


def members_of(outcome: Outcome) -> tuple[Outcome, ...]:
    """Those of a fleet, or the vehicle that is alone."""
    return outcome.fleet.members if outcome.fleet else (outcome,)


def replayed(kept: Kept, worst: Outcome) -> Iterator[tuple[Outcome, float]]:
    """The vehicles of a trial with their departures [s], in its own conditions: what else there is to say of them is
    what `worst`, of the same case, says. None for a track that is damaged.
    """
    try:
        tracks, departures = read_tracks(kept.file), _departures(kept.file)
    except InputError:
        return
    drawn = draw(kept.result.case.conditions, kept.seed).conditions
    for member, track, departure in zip(members_of(worst), tracks, departures, strict=False):
        wind = member.conditions.wind if member.limits.kind == GROUND else drawn.wind  # no wind moves a truck
        conditions = replace(member.conditions, wind=wind, friction=drawn.friction)
        yield replace(member, track=track, conditions=conditions, seed=kept.seed), departure


def _departures(file: Path) -> list[float]:
    """When each vehicle leaves [s]; one that is alone leaves at 0."""
    import pyarrow.parquet as pq

    if pq.read_schema(file).names[0] != "vehicle":
        return [0.0]
    table = pq.read_table(file, columns=["vehicle", "departure"])
    numbers, departures = (table[name].to_numpy() for name in ("vehicle", "departure"))
    return [float(departures[i]) for i in np.unique(numbers, return_index=True)[1]]
