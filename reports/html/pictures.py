"""Pictures of plans as the page carries them: with few colours, as many as there is room for."""

from __future__ import annotations

import base64
import io
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from reports.json_result import Json

_WIDTH = 800  # [px], about
_COLOURS = 64


def embedded(sections: list[Json], folder: Path, room: int) -> tuple[list[Json], int]:
    """The `sections` on plans with their pictures in them, whose files lie in `folder`; and what is left of `room`.

    A picture without a file there, or without room, is left out and counted in `left_out`.
    """
    named = [picture for section in sections for picture in _pictures(section)]
    with ThreadPoolExecutor() as pool:
        sources = pool.map(_source, [(folder / str(one["file"])).with_suffix(".png") for one in named])
        found = dict(zip([str(one["file"]) for one in named], sources, strict=True))
    told: list[Json] = []
    for section in sections:
        if not isinstance(section, dict):
            continue
        shown: list[Json] = []
        pictures = _pictures(section)
        for picture in pictures:
            source = found[str(picture["file"])]
            if source and len(source) <= room:
                room -= len(source)
                shown.append({"source": source, "caption": picture["caption"]})
        told.append({**section, "pictures": shown, "left_out": len(pictures) - len(shown)})
    return told, room


def _pictures(section: Json) -> list[dict[str, Json]]:
    pictures = section.get("pictures") if isinstance(section, dict) else None
    return [one for one in pictures if isinstance(one, dict)] if isinstance(pictures, list) else []


def _source(file: Path) -> str:
    """The picture in `file` as an address of its own, "" where there is none."""
    from PIL import Image

    if not file.is_file():
        return ""
    with Image.open(file) as whole:
        picture = whole.convert("RGB")
    picture = picture.reduce(max(1, round(picture.width / _WIDTH)))
    few = picture.quantize(_COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    content = io.BytesIO()
    few.save(content, "PNG")
    return f"data:image/png;base64,{base64.b64encode(content.getvalue()).decode()}"
