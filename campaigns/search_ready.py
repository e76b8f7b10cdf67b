"""Searches made ready: everything read and checked before the first one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.conditions import draw
from campaigns.inputs import Inputs, Reader
from campaigns.prepare import settled
from campaigns.ready import contents_of, digest_of
from campaigns.search import ScaleSearch, Search, SpeedSearch
from campaigns.seeds import digest, plan_seed, trial_seed
from planners.errors import InputError
from planners.outside import OutsidePlanner
from planners.planner import Planner
from planners.scenario import Scenario
from sim.vehicle import Limits


@dataclass(frozen=True, slots=True)
class ReadySearch:
    """A settled `search` with its `case`; `key` names all that decides what it finds."""

    search: Search
    case: Case
    inputs: Inputs
    plan_seed: int
    seed: int
    key: str

    def file(self, folder: Path) -> Path:
        """Where the result lies within the results `folder`."""
        return folder / "searches" / f"{self.key}.json"


def make_searches_ready(campaign: Campaign) -> tuple[ReadySearch, ...]:
    """Read and check all that the searches name; raises `InputError` if one of them cannot be made."""
    reader = Reader(campaign.folder)
    ready = []
    for search in campaign.searches:
        try:
            ready.append(_ready(campaign, reader, search))
        except InputError as error:
            raise InputError(f"{campaign.file}: {search.BLOCK} {search.name!r}", str(error)) from error
    return tuple(ready)


def planning(inputs: Inputs) -> tuple[Planner, Scenario]:
    """A planner of ours and what it plans on; raises `InputError` where there is none."""
    if inputs.planner is None or inputs.scenario is None or isinstance(inputs.planner, OutsidePlanner):
        raise InputError("planner", "it has none of ours", 'name one, as planner = "exact"')
    return inputs.planner, inputs.scenario


def _ready(campaign: Campaign, reader: Reader, given: Search) -> ReadySearch:
    inputs = reader.read(given.case)
    if not inputs.files:
        planning(inputs)
    case, _ = settled(given.case, inputs)
    if draw(case.conditions, 0) != draw(case.conditions, 1):
        what = f"each {'scale is flown' if isinstance(given, ScaleSearch) else 'speed is tried'} once"
        raise InputError("conditions", what, "give numbers in place of distributions")
    search = given.settled(case)
    _check_range(search, inputs.limits)
    plans, flies = plan_seed(campaign.seed, case), trial_seed(campaign.seed, case, 1)
    decides = digest_of(case, inputs, contents_of(campaign.folder, case, inputs))
    anew = isinstance(search, ScaleSearch) and search.replan
    key = digest(search.BLOCK, decides, search.ends, search.tolerance, anew, plans, flies)[:16]
    return ReadySearch(search, case, inputs, plans, flies, key)


def _check_range(search: Search, limits: Limits) -> None:
    low, high = map(float, search.between)
    if not low < high < math.inf:
        what = f"{low:g} to {high:g} {search.UNIT} is no range"
        raise InputError("between", what, "give the smaller first, both finite")
    if isinstance(search, SpeedSearch) and not limits.speed_min <= low < high <= limits.speed_max:
        what = f"{low:.4g} to {high:.4g} m/s is not all within what the {search.vehicle} can do"
        raise InputError("between", what, f"stay within {limits.speed_min:g} to {limits.speed_max:g} m/s")
