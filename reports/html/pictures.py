"""Pictures of the report as the page carries them: with few colours, as many as there is room for."""

from __future__ import annotations

import base64
import io
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from reports.files.json_result import Json

_WIDTH = 800  # [px], about
_COLOURS = 64
_PAPER = (255, 255, 255)


def embedded(told: Json, folder: Path, room: int) -> tuple[Json, int]:
    """What is `told` with the pictures that it names, whose files lie in `folder`; and what is left of `room` [bytes].

    Wherever there is a "file", there is a "source" beside it then: "" for a picture without a file or without room.
    """
    named = dict.fromkeys(pictured(told), "")
    with ThreadPoolExecutor() as pool:
        sources = pool.map(_source, [(folder / file).with_suffix(".png") for file in named])
        for file, source in zip(named, sources, strict=True):
            if len(source) <= room:
                named[file] = source
                room -= len(source)
    return _with_sources(told, named.__getitem__), room


def pictured(told: Json) -> list[str]:
    """The files of the pictures in what is `told`, in their order, each once."""
    named: dict[str, str] = {}
    _with_sources(told, lambda file: named.setdefault(file, ""))
    return [*named]


def _with_sources(told: Json, source: Callable[[str], str]) -> Json:
    if isinstance(told, list):
        return [_with_sources(one, source) for one in told]
    if not isinstance(told, dict):
        return told
    found = {key: _with_sources(value, source) for key, value in told.items()}
    figures, file = told.get("figures"), told.get("file")
    if isinstance(figures, list):
        found["figures"] = [
            {"file": one, "caption": "", "source": source(one)} if isinstance(one, str) else _with_sources(one, source)
            for one in figures
        ]
    return {**found, "source": source(file)} if isinstance(file, str) else found


def _source(file: Path) -> str:
    """The picture in `file` as an address of its own, "" where there is none."""
    from PIL import Image

    if not file.is_file():
        return ""
    with Image.open(file) as whole:
        picture = whole.convert("RGB")
    picture = picture.reduce(max(1, round(picture.width / _WIDTH)))
    few = picture.quantize(_COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    palette = few.getpalette() or []
    corner = few.getpixel((0, 0))
    if picture.getpixel((0, 0)) == _PAPER and isinstance(corner, int | float):  # the octree mixes it with what is pale
        at = 3 * int(corner)
        few.putpalette([*palette[:at], *_PAPER, *palette[at + 3 :]])
    content = io.BytesIO()
    few.save(content, "PNG")
    return f"data:image/png;base64,{base64.b64encode(content.getvalue()).decode()}"
