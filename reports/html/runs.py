"""What the page replays: the worst trial of every case, and as many others as there is room for."""

from __future__ import annotations

import json

import numpy as np

from campaigns.finished import Finished
from campaigns.summary import CaseResult
from reports.figures.extent import whole, whole_fleet
from reports.figures.focus import focus
from reports.files.json_result import Json
from reports.html.kept import Kept, kept_trials, members_of, replayed
from reports.html.vehicle import body_data, vehicle_data
from reports.html.world import World
from reports.words.words import wind_words
from tracking.outcome import Outcome

_MOST, _LEAST = 600, 60  # samples of a vehicle's worst run
_OTHERS = 0.5  # of them: what another trial has
_BYTES = 70  # of a sample on the page, about


def worst_runs(finished: Finished, world: World, room: int) -> dict[str, dict[str, Json]]:
    """Every case that has an outcome, by name, with its worst run; all of them take about `room` bytes at the most."""
    count = sum(len(members_of(outcome)) for outcome in finished.outcomes.values())
    most = max(_LEAST, min(_MOST, room // (_BYTES * max(1, count))))
    found = {}
    for result in finished.results:
        outcome = finished.outcomes.get(result.case.name)
        if outcome is not None:
            found[result.case.name] = _case(result, outcome, world, most)
    return found


def add_others(finished: Finished, cases: dict[str, dict[str, Json]], world: World, room: int) -> None:
    """Add the other trials whose tracks were kept to their `cases` until `room` bytes are used, and count the rest."""
    for kept in kept_trials(finished):
        case, outcome = cases[kept.result.case.name], finished.outcomes[kept.result.case.name]
        runs = case["runs"]
        assert isinstance(runs, list)
        if room > 0 and (run := _other(kept, outcome, case, world)) is not None:
            size = len(json.dumps(run))
            room -= size
            if room > 0:
                runs.append(run)
                continue
        case["left_out"] = _number(case["left_out"]) + 1


def _case(result: CaseResult, outcome: Outcome, world: World, most: int) -> dict[str, Json]:
    members, fleet = members_of(outcome), outcome.fleet
    view = whole_fleet(members) if fleet else whole(outcome)
    departures = fleet.departures if fleet else (0.0,)
    paths = [world.path(member.path, member.corridor) for member in members]
    vehicles: list[Json] = [
        vehicle_data(member, departure, number, most, path)
        for number, (member, departure, path) in enumerate(zip(members, departures, paths, strict=True), start=1)
    ]
    trial = result.worst.trial if result.worst else 1
    return {
        "map": world.map(outcome.obstacles),
        "kind": outcome.limits.kind,
        "body": body_data(outcome.limits.footprint),
        "corridor": outcome.corridor,
        "view": [round(value, 3) for value in (view.x_min, view.y_min, view.x_max, view.y_max)],
        "decides": fleet.member if fleet else 0,
        "replan": result.case.replan,
        "samples": most,
        "runs": [{**_run(trial, outcome, vehicles), "focus": _focus(outcome)}],
        "left_out": 0,
    }


def _other(kept: Kept, worst: Outcome, case: dict[str, Json], world: World) -> dict[str, Json] | None:
    """The run of another trial; on a plan of its own, its path is not on the page. None where its track is damaged."""
    most = max(_LEAST, int(_OTHERS * _number(case["samples"])))
    told = list(replayed(kept, worst))
    if not told:
        return None
    vehicles: list[Json] = []
    for number, (member, departure) in enumerate(told, start=1):
        path = None if kept.result.case.replan else world.path(member.path, member.corridor)
        vehicles.append(vehicle_data(member, departure, number, most, path))
    return _run(kept.trial, told[0][0], vehicles)


def _run(trial: int, outcome: Outcome, vehicles: list[Json]) -> dict[str, Json]:
    wind = outcome.conditions.wind
    return {
        "trial": trial,
        "seed": str(outcome.seed),  # beyond the whole numbers that JavaScript has
        "wind": [round(wind.east, 4), round(wind.north, 4)],
        "wind_words": wind_words(wind),
        "vehicles": vehicles,
    }


def _focus(outcome: Outcome) -> Json:
    """The place that the figures mark [m], when the vehicle is there on the clock of all [s], and what it is."""
    marked, fleet = focus(outcome), outcome.fleet
    own = fleet.members[fleet.member] if fleet else outcome
    if marked is None or not np.isfinite(own.track["s"]).any():
        return None
    index = int(np.nanargmin(np.abs(own.track["s"] - marked.s))) if marked.index is None else marked.index
    clock = float(own.track["t"][index]) + (fleet.departures[fleet.member] if fleet else 0.0)
    return {
        "x": round(marked.x, 3),
        "y": round(marked.y, 3),
        "clock": round(clock, 3),
        "title": marked.title,
        "label": marked.label,
        "alarm": marked.alarm,
    }


def _number(value: Json) -> int:
    assert isinstance(value, int)
    return value
