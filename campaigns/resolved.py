"""The campaign written out into its results, with its inputs, so that the folder alone can be run again."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import tomli_w

from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.inputs import Inputs
from campaigns.ready import ReadyCase
from campaigns.search import ALL_SEARCHES, ScaleSearch, Search, SpeedSearch
from campaigns.search_ready import ReadySearch
from planners.atomic_file import atomic
from planners.outside import OutsidePlanner
from planners.scenario import BUILT_IN_SCENARIOS, Scenario
from sim.aircraft_file import Aircraft

RESOLVED = "campaign.toml"

T = TypeVar("T", bound=Case | ScaleSearch | SpeedSearch)


def write_resolved(
    campaign: Campaign, cases: Sequence[ReadyCase], folder: Path, searches: Sequence[ReadySearch] = ()
) -> None:
    """Write `campaign.toml`, every default written out, and copy what it names to `inputs`."""
    if campaign.folder.resolve() == folder.resolve():
        return  # it is this very folder that is run again
    copies = _Copies(folder)
    written = []
    for ready in cases:
        case = _copied(ready.case, ready.inputs, campaign.folder, copies)
        others = tuple(copies.file(campaign.folder / path) for path in case.others)
        case = msgspec.structs.replace(case, others=others)
        if isinstance(case.planner, OutsidePlanner):
            case = msgspec.structs.replace(case, planner=_in_place(case.planner, campaign.folder))
        written.append(_table(case))
    copied: list[Search] = [_copied(one.search, one.inputs, campaign.folder, copies) for one in searches]
    content = {
        "name": campaign.name, "title": campaign.title, "seed": campaign.seed, "keep_tracks": campaign.keep_tracks,
        "timeout": campaign.timeout, "check": msgspec.to_builtins(campaign.check), "case": written,
        **{
            kind.BLOCK: [_without_none(msgspec.to_builtins(search)) for search in copied if isinstance(search, kind)]
            for kind in ALL_SEARCHES
        },
        "note": campaign.note, "claim": [_without_none(msgspec.to_builtins(claim)) for claim in campaign.claims],
    }  # fmt: skip
    with atomic(folder / RESOLVED) as temporary:
        temporary.write_text(tomli_w.dumps(content), encoding="utf-8")


def _copied(stated: T, inputs: Inputs, folder: Path, copies: _Copies) -> T:
    """With the names of copies for those of its path, its scenario and the vehicle's file."""
    if not isinstance(stated, ScaleSearch) and stated.path:
        stated = msgspec.structs.replace(stated, path=copies.file(folder / stated.path))
    if inputs.scenario is not None and stated.scenario not in BUILT_IN_SCENARIOS:
        stated = msgspec.structs.replace(stated, scenario=copies.scenario(inputs.scenario))
    if isinstance(inputs.vehicle, Aircraft):
        stated = msgspec.structs.replace(stated, vehicle=copies.aircraft(folder / stated.vehicle, inputs.vehicle))
    return stated


def _table(case: Case) -> dict[str, Any]:
    """The case as TOML can hold it: without what is None, which is the default wherever it is possible."""
    table: dict[str, Any] = _without_none(msgspec.to_builtins(case))
    if not isinstance(case.planner, str):
        table.pop("set")
    for key in ("plan_seed", "replan") if case.path else ("path", "others"):
        table.pop(key)
    return table


def _without_none(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_none(one) for key, one in value.items() if one is not None}
    return value


def _in_place(planner: OutsidePlanner, folder: Path) -> OutsidePlanner:
    """A planner stays where it is."""
    return msgspec.structs.replace(planner, folder=str((folder / planner.folder).resolve()))


class _Copies:
    """Copies inputs into `folder`/inputs, each once, and tells their names relative to `folder`."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._names: dict[Path, str] = {}
        shutil.rmtree(folder / "inputs", ignore_errors=True)

    def file(self, source: Path) -> str:
        """A path file."""
        return self._place(source, lambda target: shutil.copyfile(source, target / source.name), source.name)

    def scenario(self, scenario: Scenario) -> str:
        """A scenario's file, its pictures where it looks for them."""
        source, *pictures = scenario.files

        def copy(target: Path) -> None:
            shutil.copyfile(source, target / source.name)
            for picture in pictures:
                beside = target / os.path.relpath(picture, source.parent)
                beside.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(picture, beside)

        placed = self._place(source, copy, source.name)
        return placed if scenario.problem is None else f"{placed}:{scenario.problem}"

    def aircraft(self, source: Path, aircraft: Aircraft) -> str:
        """An aircraft's file, and its own JSBSim folder."""

        def copy(target: Path) -> None:
            shutil.copyfile(source, target / source.name)
            if aircraft.root:
                root = Path(aircraft.root)
                shutil.copytree(root, target / os.path.relpath(root, source.parent), dirs_exist_ok=True)

        return self._place(source, copy, source.name)

    def _place(self, source: Path, copy: Callable[[Path], object], name: str) -> str:
        source = source.resolve()
        if source not in self._names:
            inside = Path("inputs", str(len(self._names) + 1))
            (self._folder / inside).mkdir(parents=True, exist_ok=True)
            copy(self._folder / inside)
            self._names[source] = (inside / name).as_posix()
        return self._names[source]
