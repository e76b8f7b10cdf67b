"""Plans: the path of a (scenario, planner, seed), planned once and kept in the results folder."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path as FilePath

import msgspec

from campaigns.attempt import MACHINERY, failed
from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.inputs import Inputs
from campaigns.seeds import digest, file_digest, plan_seed
from planners import files
from planners.all_planners import plan_with
from planners.errors import InputError
from planners.facts import PlanFacts, facts_of
from planners.files.text import write_text
from planners.outside import OutsidePlanner, PlannerError, plan_outside
from planners.path import Path
from planners.planner import Planner
from planners.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Plan:
    """What is to be planned; cases that share the `key` share the path. `folder` is that of the campaign."""

    key: str
    planner: Planner | OutsidePlanner
    scenario: Scenario
    seed: int
    folder: FilePath

    def file(self, folder: FilePath, number: int = 1) -> FilePath:
        """Where the path of that number lies within the results `folder`; a fleet has several."""
        return folder / "plans" / (f"{self.key}.csv" if number == 1 else f"{self.key}-{number}.csv")

    def facts(self, folder: FilePath) -> FilePath:
        """Where the facts of a planner of ours lie, written last, also where it found no path."""
        return folder / "plans" / f"{self.key}.json"

    def log(self, folder: FilePath) -> FilePath:
        """Where the end of what the planner printed lies."""
        return folder / "plans" / f"{self.key}.log"

    def done(self, folder: FilePath) -> bool:
        """Whether the planner's answer lies in `folder`."""
        return (self.file if isinstance(self.planner, OutsidePlanner) else self.facts)(folder).exists()

    def told(self, folder: FilePath) -> PlanFacts | None:
        """The facts as they were stored; None where the planner failed."""
        facts = self.facts(folder)
        return msgspec.json.decode(facts.read_bytes(), type=PlanFacts) if facts.exists() else None

    def load(self, folder: FilePath) -> tuple[Path, ...] | str:
        """The paths as they were stored, one a vehicle, or the reason why there are none."""
        told = self.told(folder)
        if told is not None and not told.lengths:
            return told.reason
        count = len(told.lengths) if told is not None else 1
        found = [files.read(self.file(folder, number)).path for number in range(1, count + 1)]
        frame = self.scenario.map.frame
        return tuple(Path(path.points, name=self.scenario.name, frame=frame) for path in found)


def plans_of(case: Case, inputs: Inputs, campaign: Campaign, contents: list[str]) -> tuple[Plan, ...]:
    """The plan that all trials of `case` share, or one for each; `contents` are the hashes of its scenario's files."""
    planner = inputs.planner
    if planner is None or inputs.scenario is None:
        raise InputError("planner", "it has none, or no scenario", "add planner = ... and scenario = ...")
    if isinstance(planner, OutsidePlanner):
        programs = [_program(part, campaign.folder / planner.folder) for part in _words(planner)]
        deciding: list[object] = [contents, case.unit, planner.deciding, programs]
    else:
        deciding = [contents, case.unit, planner.name, planner]
    if inputs.scenario.problem is not None:
        deciding.append(inputs.scenario.problem)
    trials = range(1, case.trials + 1) if case.replan else (None,)
    seeds = [plan_seed(campaign.seed, case, trial) for trial in trials]
    return tuple(Plan(digest(*deciding, seed)[:16], planner, inputs.scenario, seed, campaign.folder) for seed in seeds)


def outstanding(plans: list[Plan], folder: FilePath) -> list[Plan]:
    """Those that are not answered in the results `folder` yet, each once.

    A campaign that lies in a folder of results brings its plans, but for those of planners of ours: they give the same
    again, unless they have changed.
    """
    for plan in plans:
        brought = plan.file(plan.folder)
        if isinstance(plan.planner, OutsidePlanner) and brought.exists() and not plan.done(folder):
            plan.file(folder).parent.mkdir(exist_ok=True)
            shutil.copyfile(brought, plan.file(folder))
    return list({plan.key: plan for plan in plans if not plan.done(folder)}.values())


@dataclass(frozen=True, slots=True)
class Computed:
    """What a planner gave: `paths`, with the `facts` of one of ours, or those alone where it found none.

    Or the `error` in their place, of that `kind`; and the end of what it `printed`.
    """

    paths: tuple[Path, ...] = ()
    facts: PlanFacts | None = None
    error: str = ""
    kind: str = MACHINERY
    printed: str = ""


def compute(plan: Plan) -> Computed:
    """Run the planner; what goes wrong is the result."""
    if isinstance(plan.planner, OutsidePlanner):
        return _outside(plan, plan.planner)
    try:
        found = plan_with(plan.planner, plan.scenario, plan.seed)
        facts = facts_of(found, plan.planner, plan.scenario, plan.seed)
    except Exception as error:  # also a fault of ours: it costs the trials of this plan
        wrong = failed(error)
        return Computed(error=f"planner {plan.planner.name}: {wrong.error}", kind=wrong.kind)
    return Computed(found.paths, facts)


def keep(plan: Plan, folder: FilePath, computed: Computed) -> None:
    """Store what a planner gave in the results `folder`."""
    plan.file(folder).parent.mkdir(exist_ok=True)
    plan.log(folder).unlink(missing_ok=True)
    if computed.printed:
        write_text(plan.log(folder), computed.printed)
    for number, path in enumerate(computed.paths, start=1):
        # In metres, whatever its frame: the scenario's map says where that is
        files.write(Path(path.points, name=plan.scenario.name), plan.file(folder, number))
    if computed.facts is not None:
        text = msgspec.json.format(msgspec.json.encode(computed.facts), indent=2).decode()
        write_text(plan.facts(folder), f"{text}\n")


def _outside(plan: Plan, planner: OutsidePlanner) -> Computed:
    try:
        planned = plan_outside(planner, plan.scenario, plan.seed, plan.folder)
    except PlannerError as error:
        where = f"; what it printed is in plans/{plan.key}.log" if error.stderr else ""
        return Computed(error=f"{error}{where}", printed=error.stderr)
    return Computed((planned.path,), printed=planned.stderr)


def _words(planner: OutsidePlanner) -> tuple[str, ...]:
    if planner.command is not None:
        return planner.command
    module = (planner.python or "").partition(":")[0]
    return (f"{module.replace('.', '/')}.py",)


def _program(word: str, folder: FilePath) -> str:
    """The hash of the file that a word of the command names, so that a changed planner plans anew; "" for no file."""
    file = folder / word
    try:
        return file_digest(file) if file.is_file() else ""
    except OSError:
        return ""
