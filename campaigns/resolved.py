"""The campaign written out into its results, with its inputs, so that the folder alone can be run again."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import msgspec
import tomli_w

from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.ready import ReadyCase
from planners.atomic_file import atomic
from planners.outside import OutsidePlanner
from planners.scenario import BUILT_IN_SCENARIOS, Scenario
from sim.aircraft_file import Aircraft

RESOLVED = "campaign.toml"


def write_resolved(campaign: Campaign, cases: Sequence[ReadyCase], folder: Path) -> None:
    """Write `campaign.toml`, every default written out, and copy what it names to `inputs`."""
    if campaign.folder.resolve() == folder.resolve():
        return  # it is this very folder that is run again
    copies = _Copies(folder)
    written = []
    for ready in cases:
        case, inputs = ready.case, ready.inputs
        if case.path:
            case = msgspec.structs.replace(case, path=copies.file(campaign.folder / case.path))
        if inputs.scenario is not None and case.scenario not in BUILT_IN_SCENARIOS:
            case = msgspec.structs.replace(case, scenario=copies.scenario(inputs.scenario))
        if isinstance(inputs.vehicle, Aircraft):
            own = copies.aircraft(campaign.folder / case.vehicle, inputs.vehicle)
            case = msgspec.structs.replace(case, vehicle=own)
        if isinstance(case.planner, OutsidePlanner):
            case = msgspec.structs.replace(case, planner=_in_place(case.planner, campaign.folder))
        written.append(_table(case))
    content = {
        "name": campaign.name, "title": campaign.title, "seed": campaign.seed, "keep_tracks": campaign.keep_tracks,
        "timeout": campaign.timeout, "check": msgspec.to_builtins(campaign.check), "case": written,
    }  # fmt: skip
    with atomic(folder / RESOLVED) as temporary:
        temporary.write_text(tomli_w.dumps(content), encoding="utf-8")


def _table(case: Case) -> dict[str, Any]:
    """The case as TOML can hold it: without what is None, which is the default wherever it is possible."""
    table: dict[str, Any] = _without_none(msgspec.to_builtins(case))
    if case.path:
        table.pop("plan_seed")
    else:
        table.pop("path")
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

        return self._place(source, copy, source.name)

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
