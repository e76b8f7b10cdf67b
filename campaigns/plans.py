"""Plans: the path of a (scenario, planner, seed), planned once and kept in the results folder."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path as FilePath

from campaigns.campaign import Campaign
from campaigns.case import Case
from campaigns.inputs import Inputs
from campaigns.seeds import digest, file_digest, plan_seed
from planners import files
from planners.errors import InputError, TrackworthyError
from planners.files.text import write_text
from planners.outside import OutsidePlanner, PlannerError, plan_outside
from planners.path import Path
from planners.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Plan:
    """What is to be planned; cases that share the `key` share the path."""

    key: str
    planner: OutsidePlanner
    scenario: Scenario
    seed: int
    folder: FilePath

    def file(self, folder: FilePath) -> FilePath:
        """Where the path lies within the results `folder`."""
        return folder / "plans" / f"{self.key}.csv"

    def log(self, folder: FilePath) -> FilePath:
        """Where the end of what the planner printed lies."""
        return folder / "plans" / f"{self.key}.log"

    def failure(self, folder: FilePath) -> FilePath:
        """Where the reason lies why there is no path."""
        return folder / "plans" / f"{self.key}.error"

    def load(self, folder: FilePath) -> Path:
        """The path as it was stored; raises `TrackworthyError` with the planner's own error where it gave none."""
        failed = self.failure(folder)
        if failed.exists():
            raise TrackworthyError(failed.read_text(encoding="utf-8").strip())
        path = files.read(self.file(folder)).path
        return Path(path.points, name=self.scenario.name, frame=self.scenario.map.frame)


def plan_of(case: Case, inputs: Inputs, campaign: Campaign, contents: list[str]) -> Plan:
    """The plan that `case` needs; `contents` are the hashes of its scenario's files."""
    if case.planner is None or isinstance(case.planner, str) or inputs.scenario is None:
        raise InputError("planner", f"there is no planner {case.planner!r}", "give a command or a python callable")
    programs = [_program(part, campaign.folder / case.planner.folder) for part in _words(case.planner)]
    seed = plan_seed(campaign.seed, case)
    key = digest(contents, case.planner.deciding, programs, seed)[:16]
    return Plan(key, case.planner, inputs.scenario, seed, campaign.folder)


def outstanding(plans: list[Plan], folder: FilePath) -> list[Plan]:
    """Those whose path is not in the results `folder` yet, each once.

    A campaign that lies in a folder of results brings its plans.
    """
    for plan in plans:
        brought = plan.file(plan.folder)
        if brought.exists() and not plan.file(folder).exists():
            plan.file(folder).parent.mkdir(exist_ok=True)
            shutil.copyfile(brought, plan.file(folder))
    return list({plan.key: plan for plan in plans if not plan.file(folder).exists()}.values())


@dataclass(frozen=True, slots=True)
class Computed:
    """What a planner gave: a `path`, or the `error` in its place; and the end of what it printed."""

    path: Path | None
    error: str = ""
    printed: str = ""


def compute(plan: Plan) -> Computed:
    """Run the planner; what goes wrong is the result."""
    try:
        planned = plan_outside(plan.planner, plan.scenario, plan.seed, plan.folder)
    except PlannerError as error:
        return Computed(None, str(error), error.stderr)
    return Computed(planned.path, printed=planned.stderr)


def keep(plan: Plan, folder: FilePath, computed: Computed) -> None:
    """Store what a planner gave in the results `folder`."""
    plan.file(folder).parent.mkdir(exist_ok=True)
    log, failed = plan.log(folder), plan.failure(folder)
    log.unlink(missing_ok=True)
    if computed.printed:
        write_text(log, computed.printed)
    if computed.path is None:
        where = f"; what it printed is in plans/{log.name}" if computed.printed else ""
        write_text(failed, f"{computed.error}{where}\n")
        return
    failed.unlink(missing_ok=True)
    # In metres, whatever its frame: the scenario's map says where that is
    files.write(Path(computed.path.points, name=plan.scenario.name), plan.file(folder))


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
