"""The long form of a built-in campaign: all that it shows a little of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import msgspec

from campaigns.campaign import Campaign, load_campaign
from planners.errors import InputError
from planners.typed_toml import suggestion

FULL = {"papers-full": ("paper-aco", "paper-mars", "paper-target-vehicle")}


def find_campaign(name_or_file: str, only: Sequence[str] = (), full: bool = False) -> Campaign:
    """That which `load_campaign` loads; of a built-in one, with `full`, the long form.

    Raises `InputError` where there is no long form, or no such case.
    """
    name = f"{name_or_file}-full" if full else name_or_file
    if name in FULL:
        return _whole(name, only)
    if full:
        known = ", ".join(one.removesuffix("-full") for one in FULL)
        raise InputError("--full", f"{name_or_file!r} has no long form", f"{known} has one")
    return load_campaign(name, only)


def _whole(name: str, only: Sequence[str]) -> Campaign:
    """Every case, search and claim of its parts; those called as in `only`, or all."""
    parts = [_named(load_campaign(part)) for part in FULL[name]]
    names = [one.name for part in parts for one in (*part.cases, *part.searches)]
    if unknown := next((one for one in only if one not in names), None):
        raise InputError(name, f"it has no case {unknown!r}", suggestion(unknown, names))
    return replace(
        load_campaign(name.removesuffix("-full")),
        name=name,
        title="Three papers in full: promised, flown and driven",
        cases=tuple(case for part in parts for case in part.cases if not only or case.name in only),
        searches=tuple(search for part in parts for search in part.searches if not only or search.name in only),
        claims=tuple(claim for part in parts for claim in part.claims),
        file=name,
        note=" ".join(dict.fromkeys(part.note for part in parts if part.note)),
        only=tuple(only),
    )


def _named(part: Campaign) -> Campaign:
    """With its own name before those of its cases and searches, so that these differ from the other parts'."""
    cases = tuple(msgspec.structs.replace(case, name=f"{part.name}: {case.name}") for case in part.cases)
    searches = tuple(msgspec.structs.replace(one, name=f"{part.name}: {one.name}") for one in part.searches)
    return replace(part, cases=cases, searches=searches)
