"""Cases made ready: everything read and checked before the first trial."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import msgspec

from campaigns.attempt import Job, job_of
from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.inputs import Inputs, Reader
from campaigns.plans import Plan, plan_of
from campaigns.prepare import assemble, settled
from campaigns.seeds import digest, file_digest, trial_seed
from planners.errors import InputError, TrackworthyError
from planners.outside import OutsidePlanner
from sim.aircraft_file import Aircraft
from tracking.metric import SCHEMA_VERSION
from tracking.trial import Trial


@dataclass(frozen=True, slots=True)
class ReadyCase:
    """A settled `case`. `digest` names all that decides its outcome but the seeds; `plan` is None for a path file.

    Without a path yet, `trial` is None; `error` says why there will be none.
    """

    number: int
    case: Case
    inputs: Inputs
    digest: str
    notes: tuple[str, ...] = ()
    plan: Plan | None = None
    trial: Trial | None = None
    error: str = ""

    def key(self, trial: int, seed: int) -> str:
        """The key of the trial of that number."""
        return digest(self.digest, trial, seed)

    def job(self) -> Job:
        """What is sent to workers."""
        if self.trial is None:
            raise TrackworthyError(f"{self.case.name}: there is no path to try")
        return job_of(self.trial, self.case.conditions)

    def with_path_of(self, folder: Path) -> ReadyCase:
        """With the plan that lies in `folder`, or the reason why it cannot be used."""
        if self.plan is None:
            return self
        try:
            planned = self.plan.load(folder)
            return replace(self, trial=assemble(self.case, self.inputs, planned))
        except TrackworthyError as error:
            return replace(self, error=str(error))


def make_ready(campaign: Campaign) -> tuple[ReadyCase, ...]:
    """Read and check all that the cases name; raises `InputError` if one of them cannot be tried."""
    reader = Reader(campaign.folder)
    return tuple(_ready(campaign, reader, number, case) for number, case in enumerate(campaign.cases, start=1))


def _ready(campaign: Campaign, reader: Reader, number: int, given: Case) -> ReadyCase:
    try:
        inputs = reader.read(given)
        case, notes = settled(given, inputs)
        contents = [file_digest(file) for file in _files(campaign.folder, case, inputs)]
        vehicle = _vehicle_digest(inputs.vehicle)
        ready = ReadyCase(number, case, inputs, digest(SCHEMA_VERSION, _deciding(case), contents, vehicle), notes)
        if case.planner is not None:
            return replace(ready, plan=plan_of(case, inputs, campaign, contents))
        trial = assemble(given, inputs)
        return replace(ready, trial=trial, notes=trial.notes)
    except InputError as error:
        raise InputError(f"{campaign.file}: case {given.name!r}", str(error)) from error


def _deciding(case: Case) -> Case:
    """What of `case` decides a trial: not where its files lie, and not how many trials there are."""
    return msgspec.structs.replace(
        case,
        path=Path(case.path).name,
        scenario=case.scenario and Path(case.scenario).name,
        vehicle=Path(case.vehicle).name,
        planner=case.planner.deciding if isinstance(case.planner, OutsidePlanner) else case.planner,
        trials=1,
        pass_share=1.0,
    )


def seeds_of(campaign: Campaign, case: Case) -> list[int]:
    """The seeds of the case's trials, in order."""
    return [trial_seed(campaign.seed, case, trial) for trial in range(1, case.trials + 1)]


def _files(folder: Path, case: Case, inputs: Inputs) -> list[Path]:
    """What was read for the case, besides its vehicle."""
    return [*([folder / case.path] if case.path else []), *(inputs.scenario.files if inputs.scenario else ())]


def _vehicle_digest(vehicle: str | Aircraft) -> str:
    """Of an aircraft's numbers, and of its own JSBSim files."""
    if isinstance(vehicle, str):
        return vehicle
    files = sorted(file for file in Path(vehicle.root).rglob("*") if file.is_file()) if vehicle.root else []
    return digest(msgspec.structs.replace(vehicle, root=""), [file_digest(file) for file in files])
