"""TOML files read into typed structs, with errors that say in one line where and what to write instead."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Iterable
from pathlib import Path as FilePath
from typing import TypeVar

import msgspec
from msgspec import inspect

from planners.errors import InputError

T = TypeVar("T", bound=msgspec.Struct)

_MESSAGE = re.compile(r"(.*?)(?: - at `\$\.?(.*)`)?", re.DOTALL)
_UNKNOWN = re.compile(r"Object contains unknown field `(.*)`")
_NO_WORD = re.compile(r"Invalid enum value '(.*)'")
_MISSING = re.compile(r"Object missing required field `(.*)`")


def read_toml(file: FilePath, into: type[T]) -> T:
    """Read a TOML file into a struct, which should forbid unknown fields.

    Raises `InputError` that names the file, the key (as in `obstacle[2].circle`, counted from 0) and the
    remedy; for an unknown key, the nearest that is known.
    """
    try:
        raw = tomllib.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InputError(str(file), "there is no such file", "check the path") from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(str(file), f"it cannot be read ({error})", "give a TOML file in UTF-8") from None
    except tomllib.TOMLDecodeError as error:
        raise InputError(str(file), f"it is not TOML: {error}", "correct that line") from None
    return convert(raw, into, str(file))


def convert(raw: object, into: type[T], place: str) -> T:
    """Plain data (dicts, lists, numbers, strings) as a struct; `place` names its source in errors.

    Raises `InputError` as `read_toml` does.
    """
    try:
        return msgspec.convert(raw, into)
    except msgspec.ValidationError as error:
        match = _MESSAGE.fullmatch(str(error))
    what, key = (match[1], match[2] or "") if match else ("", "")
    where = f"{place}: {key}" if key else place
    if unknown := _UNKNOWN.fullmatch(what):
        raise InputError(where, f"unknown key {unknown[1]!r}", suggestion(unknown[1], _names(into, key)))
    if missing := _MISSING.fullmatch(what):
        raise InputError(where, f"{missing[1]!r} is missing", f"add {missing[1]} = ...")
    if wrong := _NO_WORD.fullmatch(what):
        raise InputError(where, f"{wrong[1]!r} is none of its words", suggestion(wrong[1], _literals(into, key)))
    raise InputError(where, what.replace("`", "").replace("Expected", "expected").replace("object", "table"))


def suggestion(word: str, known: Iterable[str]) -> str:
    """What to tell somebody who wrote `word`: the nearest of the `known` names, or all of them."""
    names = list(known)
    near = difflib.get_close_matches(word, names, n=1)
    return f"did you mean {near[0]!r}?" if near else f"use {', '.join(names)}"


def _names(into: type[msgspec.Struct], key: str) -> list[str]:
    """The keys allowed at `key`."""
    kinds = _types(into, key)
    return [field.encode_name for kind in kinds if isinstance(kind, inspect.StructType) for field in kind.fields]


def _literals(into: type[msgspec.Struct], key: str) -> list[str]:
    """The words allowed at `key`."""
    return [str(value) for kind in _types(into, key) if isinstance(kind, inspect.LiteralType) for value in kind.values]


def _types(into: type[msgspec.Struct], key: str) -> list[inspect.Type]:
    """The types allowed at `key`, found by following it."""
    found: list[inspect.Type] = [inspect.type_info(into)]
    for step in re.findall(r"\w[\w-]*|\[[^]]*\]", key):
        found = [inner for kind in _flat(found) for inner in _children(kind, step)]
    return _flat(found)


def _flat(kinds: list[inspect.Type]) -> list[inspect.Type]:
    return [one for kind in kinds for one in (kind.types if isinstance(kind, inspect.UnionType) else (kind,))]


def _children(kind: inspect.Type, step: str) -> list[inspect.Type]:
    if isinstance(kind, inspect.StructType):
        return [field.type for field in kind.fields if field.encode_name == step]
    if isinstance(kind, inspect.DictType):
        return [kind.value_type]
    if isinstance(kind, (inspect.ListType, inspect.VarTupleType)) and step.startswith("["):
        return [kind.item_type]
    return []
