"""Two campaigns side by side: which cases belong together, what was changed, and what came of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from campaigns.campaign import Campaign
from campaigns.difference import BETTER, MIXED, SAME, UNLIKE, WORSE, Difference, overall
from campaigns.finished import read_campaign, read_results
from campaigns.gate import FALSE_ALARMS
from campaigns.manifest import Manifest
from campaigns.matching import By, matched
from campaigns.seeds import file_digest
from campaigns.settings import settings
from campaigns.summary import CaseResult
from campaigns.versus import held, samples
from planners.errors import InputError


@dataclass(frozen=True, slots=True)
class Side:
    """The results in `folder`, and what made them."""

    folder: Path
    campaign: Campaign
    manifest: Manifest
    results: list[CaseResult]


@dataclass(frozen=True, slots=True)
class Change:
    """A setting, or a version, that is not the same: its values on both sides, None where it is not there."""

    key: str
    old: Any
    new: Any


@dataclass(frozen=True, slots=True)
class CasePair:
    """A case of A and the one of B that belongs to it; `differences` by how large they are, from A to B."""

    a: CaseResult
    b: CaseResult
    changes: tuple[Change, ...]
    differences: tuple[Difference, ...]

    @property
    def name(self) -> str:
        """Both names where they are not the same."""
        a, b = self.a.case.name, self.b.case.name
        return a if a == b else f"{a} → {b}"

    @property
    def outcome(self) -> str:
        """What the differences come to, by all metrics that have a direction: better, worse, mixed or the same."""
        return overall(self.differences)

    @property
    def verdict_changed(self) -> bool:
        """Whether the cases have different verdicts."""
        return self.a.verdict != self.b.verdict


@dataclass(frozen=True, slots=True)
class SideBySide:
    """`pairs`, those first that differ most; names of the cases without a partner; and what `made` them differ."""

    a: Side
    b: Side
    pairs: tuple[CasePair, ...]
    only_a: tuple[str, ...]
    only_b: tuple[str, ...]
    made: tuple[Change, ...]

    def count(self, outcome: str) -> int:
        """How many pairs have come to `outcome`."""
        return sum(pair.outcome == outcome for pair in self.pairs)

    @property
    def verdicts_changed(self) -> int:
        """How many pairs differ in their verdict."""
        return sum(pair.verdict_changed for pair in self.pairs)


def read_side(folder: Path) -> Side:
    """The results in `folder`; raises `InputError` where there are none, not all, or those of other definitions."""
    manifest, campaign = read_campaign(folder)
    if not campaign.cases:
        raise InputError(str(folder), "its campaign has no cases to compare", "give one that has")
    return Side(folder, campaign, manifest, read_results(campaign, folder))


def side_by_side(a: Side, b: Side, by: By = "both") -> SideBySide:
    """Hold the cases of `b` against those of `a` which belong to them; chance may raise one false alarm in twenty of
    all that is compared here together. What is too small to matter is what `b`'s gate allows.
    """
    found = matched(a.results, b.results, by)
    count = sum(len(samples(old).keys() & samples(new).keys()) for old, new in found)
    chance = FALSE_ALARMS / max(1, count)
    pairs = [_pair(a, b, old, new, chance) for old, new in found]
    ranked = sorted(pairs, key=_rank)
    with_a, with_b = ({id(pair[i]) for pair in found} for i in (0, 1))
    return SideBySide(
        a,
        b,
        tuple(ranked),
        tuple(one.case.name for one in a.results if id(one) not in with_a),
        tuple(one.case.name for one in b.results if id(one) not in with_b),
        tuple(_changes(_made(a), _made(b))),
    )


def changes_of(pairs: Sequence[CasePair]) -> list[tuple[Change, int]]:
    """What was set otherwise, each with in how many of `pairs`; the most frequent first."""
    counted = Counter((change.key, str(change.old), str(change.new)) for pair in pairs for change in pair.changes)
    first = {(change.key, str(change.old), str(change.new)): change for pair in pairs for change in pair.changes}
    return [(first[key], count) for key, count in counted.most_common()]


def _pair(a: Side, b: Side, old: CaseResult, new: CaseResult, chance: float) -> CasePair:
    found = held(old, new, b.campaign.check, chance).values()
    ranked = sorted(found, key=lambda one: (one.outcome not in UNLIKE, -one.size))
    return CasePair(old, new, tuple(_changes(_set(a, old), _set(b, new))), tuple(ranked))


def _rank(pair: CasePair) -> tuple[bool, int, float]:
    """The smaller, the more there is to see."""
    order = (WORSE, MIXED, BETTER, SAME).index(pair.outcome)
    largest = max((one.size for one in pair.differences if one.outcome in UNLIKE), default=0.0)
    return not pair.verdict_changed, order, -largest


def _set(side: Side, result: CaseResult) -> dict[str, Any]:
    """The settings of a case, of its files also what is in them, and how often it is tried."""
    case = result.case
    stated = {**settings(case), "trials": case.trials, "expect": case.expect, "pass_share": case.pass_share}
    for key, name in (("path", case.path), ("scenario", case.scenario), ("vehicle", case.vehicle)):
        file = side.campaign.folder / (name or "")
        if name and file.is_file():
            stated[f"{key} content"] = file_digest(file)[:8]
    return stated


def _made(side: Side) -> dict[str, Any]:
    """What made the results, but for the settings of the cases."""
    one = side.manifest
    return {
        "campaign": one.name, "seed": one.seed, **{f"version of {name}": two for name, two in one.versions.items()},
        "git revision": one.git_revision or None, "code": one.code[:12], "platform": one.platform,
    }  # fmt: skip


def _changes(old: dict[str, Any], new: dict[str, Any]) -> list[Change]:
    keys = dict.fromkeys((*old, *new))
    return [Change(key, old.get(key), new.get(key)) for key in keys if old.get(key) != new.get(key)]
