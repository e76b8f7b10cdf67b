"""Searches for the smallest scale made ready: everything read and checked before the first one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.conditions import draw
from campaigns.inputs import Inputs, Reader
from campaigns.prepare import settled
from campaigns.ready import contents_of, digest_of
from campaigns.scale_search import ScaleSearch
from campaigns.seeds import digest, plan_seed, trial_seed
from planners.errors import InputError
from planners.outside import OutsidePlanner
from planners.planner import Planner
from planners.scenario import Scenario


@dataclass(frozen=True, slots=True)
class ReadySearch:
    """A settled `search` with its `case`; `key` names all that decides what it finds."""

    search: ScaleSearch
    case: Case
    inputs: Inputs
    scenario: Scenario
    planner: Planner
    plan_seed: int
    seed: int
    key: str

    def file(self, folder: Path) -> Path:
        """Where the result lies within the results `folder`."""
        return folder / "scales" / f"{self.key}.json"


def make_searches_ready(campaign: Campaign) -> tuple[ReadySearch, ...]:
    """Read and check all that the searches name; raises `InputError` if one of them cannot be made."""
    reader = Reader(campaign.folder)
    ready = []
    for search in campaign.searches:
        try:
            ready.append(_ready(campaign, reader, search))
        except InputError as error:
            raise InputError(f"{campaign.file}: smallest_scale {search.name!r}", str(error)) from error
    return tuple(ready)


def _ready(campaign: Campaign, reader: Reader, search: ScaleSearch) -> ReadySearch:
    low, high = search.between
    if not low < high < math.inf:
        raise InputError("between", f"{low:g} to {high:g} m is no range", "give the smaller first, both finite")
    inputs = reader.read(search.case)
    if inputs.scenario is None or inputs.planner is None or isinstance(inputs.planner, OutsidePlanner):
        raise InputError("planner", "it has none of ours", 'name one, as planner = "exact"')
    case, _ = settled(search.case, inputs)
    if draw(case.conditions, 0) != draw(case.conditions, 1):
        raise InputError("conditions", "each scale is flown once", "give numbers in place of distributions")
    search = msgspec.structs.replace(search, set=case.set, speed=case.speed, corridor=case.corridor)
    plans, flies = plan_seed(campaign.seed, case), trial_seed(campaign.seed, case, 1)
    decides = digest_of(case, inputs, contents_of(campaign.folder, case, inputs))
    key = digest("scale", decides, search.between, search.tolerance, search.replan, plans, flies)[:16]
    return ReadySearch(search, case, inputs, inputs.scenario, inputs.planner, plans, flies, key)
