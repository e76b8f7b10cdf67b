"""A campaign: a TOML file of cases, in which a list of values stands for a case each."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from campaigns.case import Case
from planners.errors import InputError
from planners.typed_toml import read_toml, suggestion
from tracking.verdict import TRACKWORTHY, Expectation

CAMPAIGNS_FOLDER = Path(__file__).parent
BUILT_IN_CAMPAIGNS = ("quickstart",)

Quantity = str | float


class Block(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One `[[case]]` of the file; `vehicle`, `controller`, `speed` and `wind` may be lists."""

    path: str
    vehicle: str | list[str]
    name: str = ""
    controller: str | list[str] = "lqr"
    speed: Quantity | list[Quantity] | None = None
    altitude: Quantity | None = None
    corridor: Quantity | None = None
    wind: str | list[str] | None = None
    scenario: str | None = None
    corners: Literal["as-drawn", "fly-by"] = "as-drawn"
    steering_hz: float = 20.0
    require: tuple[str, ...] = ()
    expect: Expectation = TRACKWORTHY


class CampaignFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The file: a `name` for the folder of its results, a `title` for its report, a `seed`, and the cases."""

    name: str
    case: list[Block]
    title: str = ""
    seed: int = 0


@dataclass(frozen=True, slots=True)
class Campaign:
    """A campaign's cases, one by one; their paths are relative to `folder`."""

    name: str
    title: str
    cases: tuple[Case, ...]
    folder: Path


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
    cases = tuple(case for block in content.case for case in _cases(block, content.seed))
    if not cases:
        raise InputError(str(file), "it has no cases", "add a [[case]] with path and vehicle")
    names = [case.name for case in cases]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise InputError(str(file), f"two cases are called {twice!r}", "give one of their blocks another name")
    if unknown := next((name for name in only if name not in names), None):
        raise InputError(str(file), f"it has no case {unknown!r}", suggestion(unknown, names))
    chosen = tuple(case for case in cases if not only or case.name in only)
    return Campaign(content.name, content.title or content.name, chosen, file.parent)


def _cases(block: Block, seed: int) -> list[Case]:
    """Every combination of the block's lists, each with a name of its own."""
    settings = msgspec.structs.asdict(block)
    lists = {key: value for key, value in settings.items() if isinstance(value, list)}
    stem = block.name or Path(block.path).stem
    cases = []
    for values in itertools.product(*lists.values()):
        chosen = dict(zip(lists, values, strict=True))
        name = " ".join([stem, *(value if isinstance(value, str) else f"{value:g}" for value in values)])
        cases.append(Case(**{**settings, **chosen, "name": name, "seed": seed}))
    return cases
