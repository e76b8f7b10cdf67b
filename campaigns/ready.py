"""Cases made ready: everything read and checked before the first trial."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import msgspec

from campaigns.attempt import Attempt, Job, failed, job_of, without_path
from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.inputs import Inputs, Reader
from campaigns.plans import Plan, plans_of
from campaigns.prepare import assemble, settled
from campaigns.seeds import digest, file_digest, trial_seed
from planners.errors import InputError, TrackworthyError
from planners.outside import OutsidePlanner
from sim.aircraft_file import Aircraft
from tracking.metric import SCHEMA_VERSION
from tracking.trial import Trial


@dataclass(frozen=True, slots=True)
class ReadyCase:
    """A settled `case`. `digest` names all that decides its outcome but the seeds.

    `plans` holds one for all trials or one for each, and none where a file gives the path. `flights` holds as many
    trials whose seeds are yet to come, or what becomes of those that have no path; none before there are plans.
    """

    number: int
    case: Case
    inputs: Inputs
    digest: str
    notes: tuple[str, ...] = ()
    plans: tuple[Plan, ...] = ()
    flights: tuple[Trial | Attempt, ...] = ()

    def key(self, trial: int, seed: int) -> str:
        """The key of the trial of that number."""
        return digest(self.digest, trial, seed)

    def flight(self, trial: int) -> Trial | Attempt:
        """That of the trial of that number."""
        return self.flights[(trial - 1) % len(self.flights)]

    def job(self, trial: int) -> Job | Attempt:
        """What is sent to workers for the trial of that number, or what becomes of it without being tried."""
        flight = self.flight(trial)
        return flight if isinstance(flight, Attempt) else job_of(flight, self.case.conditions)

    def only(self, trial: int) -> ReadyCase:
        """With the plan that the trial of that number needs, and no other."""
        return replace(self, plans=self.plans[trial - 1 : trial] if len(self.plans) > 1 else self.plans)

    def with_paths_of(self, folder: Path, without: Mapping[str, Attempt]) -> ReadyCase:
        """With the plans that lie in `folder`; `without` tells by key what becomes of trials whose planner failed."""
        if not self.plans:
            return self
        return replace(self, flights=tuple(self._flight(plan, folder, without) for plan in self.plans))

    def _flight(self, plan: Plan, folder: Path, without: Mapping[str, Attempt]) -> Trial | Attempt:
        if plan.key in without:
            return without[plan.key]
        try:
            found = plan.load(folder)
            if isinstance(found, str):
                return without_path(found, self.case.expect)
            return assemble(self.case, self.inputs, found)
        except TrackworthyError as error:
            return failed(error)


def make_ready(campaign: Campaign) -> tuple[ReadyCase, ...]:
    """Read and check all that the cases name; raises `InputError` if one of them cannot be tried."""
    reader = Reader(campaign.folder)
    return tuple(_ready(campaign, reader, number, case) for number, case in enumerate(campaign.cases, start=1))


def _ready(campaign: Campaign, reader: Reader, number: int, given: Case) -> ReadyCase:
    try:
        inputs = reader.read(given)
        case, notes = settled(given, inputs)
        contents = contents_of(campaign.folder, case, inputs)
        ready = ReadyCase(number, case, inputs, digest_of(case, inputs, contents), notes)
        if case.planner is not None:
            return replace(ready, plans=plans_of(case, inputs, campaign, contents))
        trial = assemble(given, inputs)
        return replace(ready, flights=(trial,), notes=trial.notes)
    except InputError as error:
        raise InputError(f"{campaign.file}: case {given.name!r}", str(error)) from error


def _deciding(case: Case) -> Case:
    """What of `case` decides a trial: not where its files lie, and not how many trials there are."""
    return msgspec.structs.replace(
        case,
        path=Path(case.path).name,
        others=tuple(Path(path).name for path in case.others),
        scenario=case.scenario and Path(case.scenario).name,
        vehicle=Path(case.vehicle).name,
        planner=case.planner.deciding if isinstance(case.planner, OutsidePlanner) else case.planner,
        trials=1,
        pass_share=1.0,
    )


def seeds_of(campaign: Campaign, case: Case) -> list[int]:
    """The seeds of the case's trials, in order."""
    return [trial_seed(campaign.seed, case, trial) for trial in range(1, case.trials + 1)]


def contents_of(folder: Path, case: Case, inputs: Inputs) -> list[str]:
    """Hashes of what was read for the case, besides its vehicle."""
    files = [
        *(folder / path for path in (case.path, *case.others) if path),
        *(inputs.scenario.files if inputs.scenario else ()),
    ]
    return [file_digest(file) for file in files]


def digest_of(case: Case, inputs: Inputs, contents: list[str]) -> str:
    """The hash of all that decides the outcome of a settled case but the seeds."""
    return digest(SCHEMA_VERSION, _deciding(case), contents, _vehicle_digest(inputs.vehicle))


def _vehicle_digest(vehicle: str | Aircraft) -> str:
    """Of an aircraft's numbers, and of its own JSBSim files."""
    if isinstance(vehicle, str):
        return vehicle
    files = sorted(file for file in Path(vehicle.root).rglob("*") if file.is_file()) if vehicle.root else []
    return digest(msgspec.structs.replace(vehicle, root=""), [file_digest(file) for file in files])
