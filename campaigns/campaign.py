"""A campaign: a TOML file of cases, in which a list of values stands for a case each."""

from __future__ import annotations

import itertools
import shlex
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec

from campaigns.case import Case
from campaigns.limits import Limit, check_names
from planners.errors import InputError
from planners.typed_toml import convert, read_toml, suggestion

CAMPAIGNS_FOLDER = Path(__file__).parent
BUILT_IN_CAMPAIGNS = ("quickstart",)
WHOLE_LISTS = ("require",)  # keys whose own value is a list

KeepTracks = Literal["all", "failures", "worst", "none"]


class CampaignFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The file: a `name` for the folder of its results, a `title` for its report, a `seed`, and the cases.

    `timeout` [s] of wall time is what one trial may take; `check` replaces the gate's default limits by metric.
    """

    name: str
    case: list[dict[str, Any]]
    title: str = ""
    seed: int = 0
    keep_tracks: KeepTracks = "worst"
    timeout: Annotated[float, msgspec.Meta(gt=0.0)] = 300.0
    check: dict[str, dict[str, Any]] = {}


@dataclass(frozen=True, slots=True)
class Campaign:
    """A campaign's cases, one by one; their paths are relative to `folder`."""

    name: str
    title: str
    cases: tuple[Case, ...]
    folder: Path
    file: str
    seed: int = 0
    keep_tracks: KeepTracks = "worst"
    timeout: float = 300.0
    check: dict[str, Limit] = field(default_factory=dict)

    @property
    def trials(self) -> int:
        """How many trials there are in all."""
        return sum(case.trials for case in self.cases)


def load_campaign(name_or_file: str, only: Sequence[str] = ()) -> Campaign:
    """A built-in campaign by name, or one from a TOML file; with the cases called as in `only`, or all.

    Raises `InputError` naming file and key.
    """
    built_in = name_or_file in BUILT_IN_CAMPAIGNS
    file = CAMPAIGNS_FOLDER / name_or_file / "campaign.toml" if built_in else Path(name_or_file)
    if not built_in and not file.suffix:
        known = ", ".join(BUILT_IN_CAMPAIGNS)
        raise InputError("campaign", f"there is no campaign {name_or_file!r}", f"choose {known}, or a TOML file")
    content = read_toml(file, CampaignFile)
    check_names(content.check, f"{file}: check")
    limits = {name: convert(keys, Limit, f"{file}: check.{name}") for name, keys in content.check.items()}
    blocks = enumerate(content.case)
    cases = tuple(case for i, block in blocks for case in expanded(block, f"{file}: case[{i}]"))
    if not cases:
        raise InputError(str(file), "it has no cases", "add a [[case]] with path and vehicle")
    names = [case.name for case in cases]
    for name in (content.name, *names):
        if not name.isprintable() or not name.strip():
            raise InputError(str(file), f"{name!r} is no name", "use letters, digits, spaces")
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise InputError(str(file), f"two cases are called {twice!r}", "give one of their blocks another name")
    if unknown := next((name for name in only if name not in names), None):
        raise InputError(str(file), f"it has no case {unknown!r}", suggestion(unknown, names))
    chosen = tuple(case for case in cases if not only or case.name in only)
    return Campaign(
        content.name, content.title or content.name, chosen, file.parent, name_or_file, content.seed,
        content.keep_tracks, content.timeout, limits,
    )  # fmt: skip


def replay_command(file: str, case: str, trial: int) -> str:
    """The command that repeats one trial of the campaign in `file`."""
    return shlex.join(["trackworthy", "run", file, "--case", case, "--trial", str(trial)])


def expanded(block: dict[str, Any], place: str) -> list[Case]:
    """Every combination of the lists in a `[[case]]` and in its conditions, each with a name of its own."""
    block = dict(block)
    conditions = block.pop("conditions", {})
    lists: dict[tuple[str, ...], list[Any]] = {
        (key,): value for key, value in block.items() if isinstance(value, list) and key not in WHOLE_LISTS
    }
    if isinstance(conditions, dict):
        lists |= {("conditions", key): value for key, value in conditions.items() if isinstance(value, list)}
    if empty := next((keys for keys, values in lists.items() if not values), None):
        what = "an empty list stands for no case"
        raise InputError(f"{place}: {'.'.join(empty)}", what, "give a value, or leave the key out")
    cases = []
    for numbered in itertools.product(*(enumerate(values, start=1) for values in lists.values())):
        one: dict[str, Any] = {**block}
        if conditions != {}:
            one["conditions"] = dict(conditions) if isinstance(conditions, dict) else conditions
        for keys, (_, value) in zip(lists, numbered, strict=True):
            (one["conditions"] if len(keys) > 1 else one)[keys[-1]] = value
        case = convert(one, Case, place)
        stem = case.name or Path(case.path or case.scenario or "").stem
        said = ("name",) if block.get("name") else ("path",) if block.get("path") else ("scenario",)
        words = _words([(keys, one) for keys, one in zip(lists, numbered, strict=True) if keys != said])
        cases.append(msgspec.structs.replace(case, name=" ".join([stem, *words])))
    return cases


def _words(chosen: list[tuple[tuple[str, ...], tuple[int, Any]]]) -> Iterator[str]:
    """What tells this combination from the others: its values, with the key where they do not speak for themselves."""
    for keys, (number, value) in chosen:
        if isinstance(value, str):
            word = Path(value).stem if keys == ("path",) else value
        else:
            word = _number(value) if isinstance(value, (int, float)) else f"{number}"
        yield word if isinstance(value, str) or keys == ("speed",) else f"{keys[-1]} {word}"


def _number(value: float) -> str:
    """As short as it can be without being another number."""
    short = f"{value:g}"
    return short if float(short) == value else repr(value)
