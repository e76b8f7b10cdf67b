"""The searches of a campaign: each a task for the workers, its result kept in the results folder."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns.attempt import MACHINERY
from campaigns.lanes import Lanes
from campaigns.search import Search
from campaigns.search_ready import ReadySearch
from campaigns.search_steps import Found, find
from planners.errors import TrackworthyError
from planners.files.text import write_text
from planners.scenario import Scenario


@dataclass(frozen=True, slots=True)
class SearchResult:
    """A search and what it found, with a vehicle of that `kind`; `size` is the map's width and height in map units,
    None where there is no map.
    """

    search: Search
    size: tuple[float, float] | None
    kind: str
    found: Found

    @property
    def passed(self) -> bool | None:
        """Whether it is as expected, which an error never is; None where nothing was expected."""
        if self.found.error:
            return False
        return self.search.as_expected(self.found.at)


def run_searches(searches: Sequence[ReadySearch], folder: Path, lanes: Lanes) -> list[SearchResult]:
    """What each search found: as it lies in the results `folder`, else found now and stored there."""

    def send(executor: Executor, ready: ReadySearch) -> Future[Found]:
        return executor.submit(find, ready)

    known = {one.key: _stored(one.file(folder)) for one in searches if one.file(folder).exists()}
    for ready, future in lanes.each((one for one in searches if one.key not in known), send):
        try:
            found = future.result()
        except TrackworthyError as error:
            found = Found(error=str(error), kind=MACHINERY)
        known[ready.key] = found
        if not found.error:
            ready.file(folder).parent.mkdir(exist_ok=True)
            write_text(ready.file(folder), f"{msgspec.json.format(msgspec.json.encode(found), indent=2).decode()}\n")
    return [_result(one, known[one.key]) for one in searches]


def stored_searches(searches: Sequence[ReadySearch], folder: Path) -> list[SearchResult]:
    """What each search found, as it lies in the results `folder`; one that failed lies in none."""
    missing = Found(error="it failed to run, and says why when it is run again", kind=MACHINERY)
    files = [one.file(folder) for one in searches]
    return [
        _result(one, _stored(file) if file.exists() else missing) for one, file in zip(searches, files, strict=True)
    ]


def _result(ready: ReadySearch, found: Found) -> SearchResult:
    return SearchResult(ready.search, _map_units(ready.inputs.scenario), ready.inputs.limits.kind, found)


def _stored(file: Path) -> Found:
    return msgspec.json.decode(file.read_bytes(), type=Found)


def _map_units(scenario: Scenario | None) -> tuple[float, float] | None:
    if scenario is None:
        return None
    width, height = scenario.size
    return width / scenario.unit, height / scenario.unit
