"""Blocks of a campaign file in which a list of values stands for a case each."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from campaigns.case import Case
from campaigns.search import ScaleSearch, SpeedSearch
from planners.errors import InputError
from planners.scenario import stem_of
from planners.typed_toml import convert

WHOLE_LISTS = ("require", "between", "others")  # keys whose own value is a list
TABLES = ("conditions", "set")  # keys whose values are lists to be multiplied out

T = TypeVar("T", bound=Case | ScaleSearch | SpeedSearch)
_Choice = tuple[tuple[str, ...], tuple[int, Any]]  # the keys of a list, and of its values the number and the value


def expanded(block: dict[str, Any], place: str, into: type[T]) -> list[T]:
    """Every combination of the lists in a block and in its tables, each with a name of its own.

    Raises `InputError`, in which `place` names the block.
    """
    said = next((key for key in ("name", "path", "scenario") if block.get(key)), "scenario")
    found = []
    for combination, chosen in _combinations(block, place):
        one = convert(combination, into, place)
        stem = one.name or (Path(combination["path"]).stem if combination.get("path") else stem_of(one.scenario or ""))
        if not stem:
            raise InputError(place, "it has neither a path nor a scenario", "add path = ..., or planner and scenario")
        name = " ".join([stem, *_words(chosen, said)])
        found.append(msgspec.structs.replace(one, name=name))
    return found


def _combinations(block: dict[str, Any], place: str) -> Iterator[tuple[dict[str, Any], list[_Choice]]]:
    tables = {key: block[key] for key in TABLES if isinstance(block.get(key), dict)}
    lists: dict[tuple[str, ...], list[Any]] = {
        (key,): value for key, value in block.items() if isinstance(value, list) and key not in (*WHOLE_LISTS, *TABLES)
    }
    for name, table in tables.items():
        lists |= {(name, key): value for key, value in table.items() if isinstance(value, list)}
    if empty := next((keys for keys, values in lists.items() if not values), None):
        what = "an empty list stands for no case"
        raise InputError(f"{place}: {'.'.join(empty)}", what, "give a value, or leave the key out")
    for numbered in itertools.product(*(enumerate(values, start=1) for values in lists.values())):
        one: dict[str, Any] = {**block, **{name: dict(table) for name, table in tables.items()}}
        for keys, (_, value) in zip(lists, numbered, strict=True):
            (one[keys[0]] if len(keys) > 1 else one)[keys[-1]] = value
        yield one, list(zip(lists, numbered, strict=True))


def _words(chosen: list[_Choice], said: str) -> Iterator[str]:
    """What tells this combination from the others: its values, with the key where they do not speak for themselves.

    The value of the key `said` is in the name already.
    """
    for keys, (number, value) in chosen:
        if keys == (said,):
            continue
        if isinstance(value, str):
            word = Path(value).stem if keys == ("path",) else value
        else:
            word = _number(value) if isinstance(value, (int, float)) else f"{number}"
        yield word if isinstance(value, str) or keys == ("speed",) else f"{keys[-1]} {word}"


def _number(value: float) -> str:
    """As short as it can be without being another number."""
    short = f"{value:g}"
    return short if float(short) == value else repr(value)
