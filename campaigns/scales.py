"""The searches of a campaign: each a task for the workers, its result kept in the results folder."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns.attempt import MACHINERY
from campaigns.lanes import Lanes
from campaigns.scale_ready import ReadySearch
from campaigns.scale_search import ScaleSearch
from campaigns.scale_steps import Scale, find
from planners.errors import TrackworthyError
from planners.files.text import write_text
from planners.scenario import Scenario


@dataclass(frozen=True, slots=True)
class ScaleResult:
    """A search and what it found; `size` is the map's width and height in map units."""

    search: ScaleSearch
    size: tuple[float, float]
    found: Scale

    @property
    def passed(self) -> bool | None:
        """Whether it is as expected; None where nothing was expected."""
        if self.search.expect_at_most is None:
            return None
        return self.found.unit is not None and self.found.unit <= self.search.expect_at_most


def run_searches(searches: Sequence[ReadySearch], folder: Path, lanes: Lanes) -> list[ScaleResult]:
    """What each search found: as it lies in the results `folder`, else found now and stored there."""

    def send(executor: Executor, ready: ReadySearch) -> Future[Scale]:
        return executor.submit(find, ready)

    found = {one.key: _stored(one.file(folder)) for one in searches if one.file(folder).exists()}
    for ready, future in lanes.each((one for one in searches if one.key not in found), send):
        try:
            scale = future.result()
        except TrackworthyError as error:
            scale = Scale(error=str(error), kind=MACHINERY)
        found[ready.key] = scale
        if not scale.error:
            ready.file(folder).parent.mkdir(exist_ok=True)
            write_text(ready.file(folder), f"{msgspec.json.format(msgspec.json.encode(scale), indent=2).decode()}\n")
    return [ScaleResult(one.search, _map_units(one.scenario), found[one.key]) for one in searches]


def _stored(file: Path) -> Scale:
    return msgspec.json.decode(file.read_bytes(), type=Scale)


def _map_units(scenario: Scenario) -> tuple[float, float]:
    width, height = scenario.size
    return width / scenario.unit, height / scenario.unit
