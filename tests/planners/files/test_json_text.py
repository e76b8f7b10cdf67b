from __future__ import annotations

import msgspec
import pytest

from planners.errors import InputError
from planners.files.json_text import decode


class Thing(msgspec.Struct):
    name: str
    size: float | None = None
    parts: list[Thing] = []


def said(text: str) -> str:
    with pytest.raises(InputError) as caught:
        decode(text, Thing, "a.json")
    return str(caught.value)


def test_comments_go_and_strings_stay():
    thing = decode('{ // one\n"name": "http://a/*b*/ \\"//c", /* two\n* */ "size": /**/ 2 } // end', Thing, "a")
    assert (thing.name, thing.size) == ('http://a/*b*/ "//c', 2.0)


def test_unknown_keys_are_tolerated():
    assert decode('{"name": "a", "colour": [1, {"x": null}]}', Thing, "a").name == "a"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('{"name": "a",\n "size": tru}', "a.json: line 2, column 14: broken JSON: invalid character"),
        ('/* 1\n2 */ {"name": "é", "size": 1,}', "a.json: line 2, column 30: broken JSON: trailing comma"),
        ('{"name": "a",\n', "a.json: line 1, column 14: broken JSON: it ends here; "),
        ("", "a.json: line 1, column 1: broken JSON: it ends here; "),
        ('{"name": "a" /* open', "a.json: line 1, column 13: broken JSON: it ends here"),
        ('{"name": "a", "size": NaN}', "a.json: line 1, column 23: broken JSON: invalid character"),
        ("[]", "a.json: expected object, got array; correct the value"),
        ('{"name": "a", "parts": [{"name": 1}]}', "a.json: $.parts[0].name: expected str, got int"),
        ('{"name": "a", "size": 1e999}', "a.json: $.size: Number out of range"),
        ('{"name": "a", "parts": [' * 50_000, "a.json: is nested too deeply"),
        ('{"x": ' + "[" * 50_000, "a.json: is nested too deeply"),
    ],
)
def test_refused(text, expected):
    assert said(text).startswith(expected)
    assert "\n" not in said(text)


def test_many_open_comments_take_linear_time():
    assert "it ends here" in said("/* " * 2_000_000)
