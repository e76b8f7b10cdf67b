from __future__ import annotations

import pathlib
from collections.abc import Callable

import pytest

from planners import files
from planners.errors import InputError


@pytest.fixture
def read(tmp_path: pathlib.Path) -> Callable[[str, str], files.PathFile]:
    """Read `text` as a file called `name`."""

    def read(name: str, text: str) -> files.PathFile:
        file = tmp_path / name
        file.write_bytes(text.encode())
        return files.read(file)

    return read


@pytest.fixture
def refusal(read: Callable[[str, str], files.PathFile], tmp_path: pathlib.Path) -> Callable[[str, str], str]:
    """What is said, in one line after the file's name, when `text` is refused."""

    def refusal(name: str, text: str) -> str:
        with pytest.raises(InputError) as caught:
            read(name, text)
        said, place = str(caught.value), str(tmp_path / name)
        assert said.startswith(f"{place}: ")
        assert "\n" not in said
        return said.removeprefix(f"{place}: ")

    return refusal
