from __future__ import annotations

import errno
import os
import pathlib

import pytest

from planners import files
from planners.errors import InputError, TrackworthyError
from planners.files import text
from planners.path import Path


def test_byte_order_mark_and_line_ends(read):
    assert read("a.csv", "\ufeffx,y\r\n0,0\r\n1,0\r").path.length == 1.0


def test_missing_file():
    with pytest.raises(InputError, match=r"^nowhere/a\.csv: no such file; "):
        files.read("nowhere/a.csv")


def test_directory(tmp_path):
    (tmp_path / "a.csv").mkdir()
    with pytest.raises(InputError, match=r"a\.csv: is a directory"):
        files.read(tmp_path / "a.csv")


def test_pipe_is_refused_without_waiting(tmp_path):
    os.mkfifo(tmp_path / "a.csv")
    with pytest.raises(InputError, match=r"a\.csv: is not a regular file"):
        files.read(tmp_path / "a.csv")


def test_impossible_name():
    with pytest.raises(InputError, match="cannot be read"):
        files.read("a\0.csv")


def test_not_utf8(tmp_path):
    (tmp_path / "a.csv").write_bytes(b"x,y\n0,0\n\xff,1\n")
    with pytest.raises(InputError, match=r"a\.csv: line 3: is not UTF-8 text; "):
        files.read(tmp_path / "a.csv")


def test_large_file_is_refused_unread(tmp_path):
    with open(tmp_path / "a.csv", "wb") as stream:
        stream.truncate(files.MAX_FILE_BYTES + 1)
    with pytest.raises(InputError, match=r"a\.csv: is larger than the limit of 64 MiB; "):
        files.read(tmp_path / "a.csv")


@pytest.mark.parametrize(
    ("name", "body"),
    [
        ("a.csv", "x,y\n" + "0,0\n" * 1_002_000),
        ("a.waypoints", "QGC WPL 110\n" + "0\n" * 1_002_000),
        ("a.plan", '{"x": [' + "[]," * 1_002_000 + "[]]}"),
        ("a.geojson", '{"type": "LineString", "coordinates": [' + "[]," * 1_002_000 + "[]]}"),
    ],
)
def test_many_points_are_refused_unparsed(refusal, name, body):
    assert "over the limit of 1000000; split or simplify" in refusal(name, body)


def test_limit_is_exact():
    text.check_count(text.MAX_POINTS, "a.csv")
    with pytest.raises(InputError):
        text.check_count(text.MAX_POINTS + 1, "a.csv")


def test_failed_write_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch):
    file = tmp_path / "a.csv"
    file.write_text("old")

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(TrackworthyError, match=r"a\.csv: cannot be written: No space") as caught:
        files.write(Path([[0.0, 0.0], [1.0, 0.0]]), file)
    assert not isinstance(caught.value, InputError)
    assert file.read_text() == "old"
    assert os.listdir(tmp_path) == ["a.csv"]


@pytest.mark.parametrize(("name", "why"), [("nowhere/a.csv", "does not exist"), ("a\0.csv", "cannot be written")])
def test_unwritable(tmp_path: pathlib.Path, name, why):
    with pytest.raises(InputError, match=why):
        files.write(Path([[0.0, 0.0], [1.0, 0.0]]), tmp_path / name)
