"""Typed JSON, comments allowed, with the line and column of what is wrong."""

from __future__ import annotations

import re
from typing import TypeVar

import msgspec

from planners.errors import InputError

T = TypeVar("T")

_STRING_OR_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*[\s\S]*?(?:\*/|\Z)')
_BYTE = re.compile(r" \(byte (\d+)\)$")
_PATH = re.compile(r" - at `(.*)`$")


def decode(text: str, kind: type[T], place: str) -> T:
    """The JSON `text` as `kind`, with `//` and `/* */` comments as in QGroundControl's plans.

    Raises `InputError` with line and column for broken JSON, with the JSON path for a value of another type.
    """
    text = _STRING_OR_COMMENT.sub(_blank, text)
    try:
        return msgspec.json.decode(text, type=kind)
    except msgspec.ValidationError as error:
        raise _type_error(str(error), place) from None
    except msgspec.DecodeError as error:
        raise _syntax_error(str(error), text, place) from None
    except RecursionError:
        raise InputError(place, "is nested too deeply", "give a file with one path") from None


def decode_raw(raw: msgspec.Raw, kind: type[T], place: str) -> T:
    """A part of a decoded file, kept raw until its type was known, as `kind`."""
    try:
        return msgspec.json.decode(raw, type=kind)
    except msgspec.ValidationError as error:
        raise _type_error(str(error), place) from None
    except msgspec.DecodeError as error:
        raise InputError(place, f"broken JSON: {error}") from None


def _blank(match: re.Match[str]) -> str:
    found = match[0]
    if found.startswith('"'):
        return found
    return "".join(c if c == "\n" else " " for c in found)  # keeps the line and column of what follows


def _type_error(message: str, place: str) -> InputError:
    path = _PATH.search(message)
    where = f"{place}: {path[1]}" if path else place
    what = _PATH.sub("", message).replace("`", "").replace("Expected", "expected")
    return InputError(where, what, "correct the value")


def _syntax_error(message: str, text: str, place: str) -> InputError:
    raw = text.encode()
    byte = _BYTE.search(message)
    before = raw[: int(byte[1])] if byte else raw.rstrip()
    line = before.count(b"\n") + 1
    column = len(before[before.rfind(b"\n") + 1 :].decode(errors="replace")) + 1
    what = (
        _BYTE.sub("", message).removeprefix("JSON is malformed: ").replace("Input data was truncated", "it ends here")
    )
    return InputError(f"{place}: line {line}, column {column}", f"broken JSON: {what}", "correct it or export it again")
