"""Planners of others: a command in any language, or a callable in Python, run once on a scenario."""

from __future__ import annotations

import math
import re
import signal
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path as FilePath

import msgspec

from planners import files
from planners.child import run_child
from planners.errors import InputError, TrackworthyError
from planners.files.text import write_text
from planners.in_frame import in_frame_of
from planners.path import Path
from planners.scenario import Scenario
from planners.scenario_json import scenario_bytes

PLACEHOLDERS = ("scenario", "output", "seed")

_CALL_PYTHON = FilePath(__file__).with_name("call_python.py")
_LABEL_LENGTH, _LINE_LENGTH = 60, 200  # characters of a command, and of what it said, in a message
_BRACES = re.compile(r"(?<!\$)\{(\{)?([A-Za-z_]\w*)\}(?(1)\})")
_COLOUR = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")
_WAYS = 'give command = ["./my_planner", "{scenario}", "{output}"] or python = "module:callable"'


class PlannerKeysError(InputError, ValueError):
    """Keys that describe no planner. A `ValueError`, so that msgspec tells where in a file they are."""


class PlannerError(TrackworthyError):
    """An outside planner gave no usable path; `stderr` is the end of what it printed."""

    def __init__(self, message: str, stderr: str = "") -> None:
        super().__init__(message)
        self.stderr = stderr


class OutsidePlanner(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A planner as a campaign file states it: either a `command` or `python`, a "module:callable".

    In the arguments of a command {scenario} and {output} become file names and {seed} a number. A name alone
    in braces is a placeholder; {{name}} stands for literal braces about a name. All other braces, and those
    after a dollar sign, stay as they are. `timeout` is in seconds. The suffix of `output` says in which format the
    command writes its path. It runs in `folder`, relative to that of the campaign.

    Raises `PlannerKeysError` for keys that describe no planner.
    """

    command: tuple[str, ...] | None = None
    python: str | None = None
    timeout: float = 60.0
    output: str = "path.csv"
    folder: str = ""

    def __post_init__(self) -> None:
        if (self.command is None) == (self.python is None):
            raise PlannerKeysError("", "a planner is either a command or python", _WAYS)
        if not 0.0 < self.timeout < math.inf:
            raise PlannerKeysError("", f"a timeout of {self.timeout} s is not possible", "give seconds above 0")
        suffixes = [suffix for form in files.FORMATS for suffix in form.suffixes]
        output = FilePath(self.output)
        if output.name != self.output or output.suffix.lower() not in suffixes:
            remedy = f"give a name without a folder that ends in {', '.join(suffixes)}"
            raise PlannerKeysError("", f"output {self.output!r} is not the name of a path file", remedy)
        if self.command is not None:
            _check_command(self.command)
        if self.python is not None:
            _check_python(self.python, self.output)

    @property
    def deciding(self) -> OutsidePlanner:
        """The same planner, but for what decides no path: where it runs, and how long it may."""
        return msgspec.structs.replace(self, folder="", timeout=1.0)

    @property
    def label(self) -> str:
        """The planner in messages: its callable or its command, shortened."""
        text = _one_line(self.python or " ".join(self.command or ()))
        return text if len(text) <= _LABEL_LENGTH else f"{text[: _LABEL_LENGTH - 3]}..."


@dataclass(frozen=True, slots=True)
class Planned:
    """The `path` of an outside planner in the scenario's frame, what to note, and the end of what was printed."""

    path: Path
    notes: tuple[str, ...]
    stderr: str


def plan_outside(planner: OutsidePlanner, scenario: Scenario, seed: int, folder: FilePath) -> Planned:
    """Run `planner` once in its folder within `folder`, that of the campaign file; a module is found there too.

    Raises `PlannerError` if it cannot be started, fails, takes too long, or writes no path in the scenario's frame.
    """
    folder = folder / planner.folder
    with tempfile.TemporaryDirectory(prefix="trackworthy-", ignore_cleanup_errors=True) as temporary:
        task, output = FilePath(temporary, "scenario.json"), FilePath(temporary, "output", planner.output)
        output.parent.mkdir()
        write_text(task, scenario_bytes(scenario).decode())
        said = _run(planner, _command(planner, task, output, seed), folder, temporary)
        if not output.exists():
            raise _failed(planner, f"it ended without writing {planner.output}; it must write its path there", said)
        try:
            file = files.read(output)
            path = in_frame_of(scenario, file.path)
        except InputError as error:
            raise _failed(planner, str(error).replace(str(output), planner.output), said) from None
    notes = [*file.notes]
    if file.fence is not None:
        notes.append("its fence is not taken, the scenario's map counts")
    if file.speed is not None:
        notes.append(f"its speed of {file.speed:g} m/s is not taken")
    return Planned(path, tuple(notes), said)


def _check_command(command: tuple[str, ...]) -> None:
    if not command or not command[0]:
        raise PlannerKeysError("", "the command is empty", _WAYS)
    used = {match[2] for argument in command for match in _BRACES.finditer(argument) if not match[1]}
    known = ", ".join(f"{{{name}}}" for name in PLACEHOLDERS)
    for name in sorted(used - set(PLACEHOLDERS)):
        remedy = f"use {known}, or write {{{{{name}}}}} for braces as such"
        raise PlannerKeysError("", f"unknown placeholder {{{name}}} in the command", remedy)
    if "output" not in used:
        what = "the command does not say where to write the path"
        raise PlannerKeysError("", what, "add {output} to its arguments")


def _check_python(target: str, output: str) -> None:
    module, _, name = target.partition(":")
    if not all(word.isidentifier() for word in (*module.split("."), *name.split("."))):
        raise PlannerKeysError("", f"python {target!r} is not known", 'write it as "module:callable"')
    if FilePath(output).suffix.lower() != ".csv":
        raise PlannerKeysError("", "a python planner returns its path and writes no file", "leave output out")


def _command(planner: OutsidePlanner, task: FilePath, output: FilePath, seed: int) -> list[str]:
    if planner.python is not None:
        # -P, or our modules beside that file would hide the user's and the standard library's
        return [sys.executable, "-P", str(_CALL_PYTHON), planner.python, str(task), str(output), str(seed)]
    values = dict(zip(PLACEHOLDERS, (str(task), str(output), str(seed)), strict=True))

    def filled(match: re.Match[str]) -> str:
        return f"{{{match[2]}}}" if match[1] else values[match[2]]

    return [_BRACES.sub(filled, argument) for argument in planner.command or ()]


def _run(planner: OutsidePlanner, command: list[str], folder: FilePath, temporary: str) -> str:
    """What the planner said, without the name of the temporary folder, which is another each time.

    Raises `PlannerError` unless it ended well and in time.
    """
    try:
        ended = run_child(command, folder, planner.timeout)
    except (OSError, ValueError) as error:
        raise _failed(planner, _why_not_started(command[0], folder, error)) from None
    said = ended.said.replace(f"{temporary}/", "")
    if ended.code is None:
        what = f"stopped after {planner.timeout:g} s without a path; give it a longer timeout"
        raise _failed(planner, what, said)
    if ended.code != 0:
        raise _failed(planner, _exit(ended.code), said)
    return said


def _why_not_started(program: str, folder: FilePath, error: OSError | ValueError) -> str:
    if not folder.is_dir():
        return f"there is no folder {folder} to run in; correct folder"
    here = "/" in program
    if isinstance(error, FileNotFoundError) and here and (folder / program).exists():
        return f"{program} names an interpreter that does not exist; correct its first line"
    if isinstance(error, FileNotFoundError):
        where = f"in {folder}" if here else "on the PATH"
        return f"there is no program {program!r} {where}; correct the command"
    if isinstance(error, PermissionError):
        return f"{program} is not executable; chmod +x it, or name its interpreter first"
    return f"{program} cannot be started: {getattr(error, 'strerror', None) or error}"


def _exit(code: int) -> str:
    if code > 0:
        return f"it failed with exit code {code}"
    known = {member.value: member.name for member in signal.Signals}
    return f"it was killed by {known.get(-code, f'signal {-code}')}"


def _failed(planner: OutsidePlanner, what: str, said: str = "") -> PlannerError:
    lines = [line for text in said.splitlines() if (line := _one_line(text))]
    last = f": {lines[-1][:_LINE_LENGTH]}" if lines else ""
    return PlannerError(_one_line(f"planner {planner.label}: {what}{last}"), said)


def _one_line(text: str) -> str:
    words = _COLOUR.sub("", text).split()
    return "".join(letter for letter in " ".join(words) if letter.isprintable())
