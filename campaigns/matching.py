"""Which cases of two campaigns belong together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal

from campaigns.settings import DIMENSIONS, key_of, settings, without
from campaigns.summary import CaseResult

By = Literal["both", "name", "setting"]
Pairs = list[tuple[CaseResult, CaseResult]]


def matched(a: Sequence[CaseResult], b: Sequence[CaseResult], by: By = "both") -> Pairs:
    """Pairs in the order of `a`: by `name`; by `setting`, which is all that a case is, or all but one dimension of it
    (the controller first, at last the conditions); or by name as far as that goes, and the others by setting.

    Where several cases of one side could belong to one of the other, none does.
    """
    keys: list[Callable[[CaseResult], str]] = []
    if by != "setting":
        keys.append(lambda one: one.case.name)
    if by != "name":
        keys.append(lambda one: key_of(settings(one.case)))
        keys += [_all_but(dimension) for dimension in DIMENSIONS]
    found: Pairs = []
    for key in keys:
        found += _unique(_left(a, [pair[0] for pair in found]), _left(b, [pair[1] for pair in found]), key)
    return sorted(found, key=lambda pair: pair[0].number)


def _all_but(dimension: str) -> Callable[[CaseResult], str]:
    def key(one: CaseResult) -> str:
        stated = settings(one.case)
        mission = dimension == "planner" and not stated["scenario"]  # another path without a map is another mission
        return key_of(stated if mission else without(stated, dimension))

    return key


def _left(results: Sequence[CaseResult], taken: Sequence[CaseResult]) -> list[CaseResult]:
    gone = {one.number for one in taken}
    return [one for one in results if one.number not in gone]


def _unique(a: Sequence[CaseResult], b: Sequence[CaseResult], key: Callable[[CaseResult], str]) -> Pairs:
    """The pairs of the same key, where it is only one case's on both sides."""
    keys_a, keys_b = [key(one) for one in a], [key(one) for one in b]
    return [
        (a[i], b[keys_b.index(one)])
        for i, one in enumerate(keys_a)
        if keys_a.count(one) == 1 and keys_b.count(one) == 1
    ]
