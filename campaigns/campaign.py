"""A campaign: a TOML file of cases, in which a list of values stands for a case each."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

import msgspec

from campaigns.case import Case
from campaigns.claims import Claim, check_claims
from campaigns.expand import expanded
from campaigns.limits import Limit, check_names
from campaigns.search import ScaleSearch, Search, SpeedSearch
from planners.errors import InputError
from planners.typed_toml import convert, read_toml, suggestion

CAMPAIGNS_FOLDER = Path(__file__).parent
BUILT_IN_CAMPAIGNS = ("papers", "quickstart", "paper-aco", "paper-mars", "paper-target-vehicle")

KeepTracks = Literal["all", "failures", "worst", "none"]
T = TypeVar("T", Case, ScaleSearch, SpeedSearch)


class CampaignFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The file: a `name` for the folder of its results, a `title` for its report, a `seed`, the cases, and searches
    for the smallest scale and the top speed.

    `timeout` [s] of wall time is what one trial may take; `check` replaces the gate's default limits by metric. Claims
    of papers stand in the report under what their planners gave here, and the `note` below them.
    """

    name: str
    case: list[dict[str, Any]] = []
    smallest_scale: list[dict[str, Any]] = []
    top_speed: list[dict[str, Any]] = []
    title: str = ""
    seed: int = 0
    keep_tracks: KeepTracks = "worst"
    timeout: Annotated[float, msgspec.Meta(gt=0.0)] = 300.0
    check: dict[str, dict[str, Any]] = {}
    claim: tuple[Claim, ...] = ()
    note: str = ""


@dataclass(frozen=True, slots=True)
class Campaign:
    """A campaign's cases and searches, one by one, `only` those of these names where it has any; their paths are
    relative to `folder`.
    """

    name: str
    title: str
    cases: tuple[Case, ...]
    searches: tuple[Search, ...]
    folder: Path
    file: str
    seed: int = 0
    keep_tracks: KeepTracks = "worst"
    timeout: float = 300.0
    check: dict[str, Limit] = field(default_factory=dict)
    claims: tuple[Claim, ...] = ()
    note: str = ""
    only: tuple[str, ...] = ()

    @property
    def trials(self) -> int:
        """How many trials there are in all."""
        return sum(case.trials for case in self.cases)


def load_campaign(name_or_file: str, only: Sequence[str] = ()) -> Campaign:
    """A built-in campaign by name, or one from a TOML file; with the cases and searches called as in `only`, or all.

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
    cases = _every(content.case, f"{file}: case", Case)
    scales = _every(content.smallest_scale, f"{file}: {ScaleSearch.BLOCK}", ScaleSearch)
    speeds = _every(content.top_speed, f"{file}: {SpeedSearch.BLOCK}", SpeedSearch)
    searches: list[Search] = [*scales, *speeds]
    if not cases and not searches:
        raise InputError(str(file), "it has no cases", "add a [[case]] with path and vehicle")
    names = [*(case.name for case in cases), *(search.name for search in searches)]
    for name in (content.name, *names):
        if not name.isprintable() or not name.strip():
            raise InputError(str(file), f"{name!r} is no name", "use letters, digits, spaces")
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise InputError(str(file), f"two cases are called {twice!r}", "give one of their blocks another name")
    check_claims(content.claim, cases, str(file))
    if unknown := next((name for name in only if name not in names), None):
        raise InputError(str(file), f"it has no case {unknown!r}", suggestion(unknown, names))
    return Campaign(
        name=content.name,
        title=content.title or content.name,
        cases=tuple(case for case in cases if not only or case.name in only),
        searches=tuple(search for search in searches if not only or search.name in only),
        folder=file.parent,
        file=name_or_file,
        seed=content.seed,
        keep_tracks=content.keep_tracks,
        timeout=content.timeout,
        check=limits,
        claims=content.claim,
        note=content.note,
        only=tuple(only),
    )


def _every(blocks: Sequence[dict[str, Any]], place: str, into: type[T]) -> list[T]:
    """All that the `blocks` stand for."""
    return [one for i, block in enumerate(blocks) for one in expanded(block, f"{place}[{i}]", into)]


def replay_command(file: str, case: str, trial: int) -> str:
    """The command that repeats one trial of the campaign in `file`."""
    return shlex.join(["trackworthy", "run", file, "--case", case, "--trial", str(trial)])
