"""Pictures of plans as the page carries them: with few colours, as many as there is room for."""

from __future__ import annotations

import base64
import io
from pathlib import Path

from reports.json_result import Json

_WIDTH = 1100  # [px]
_COLOURS = 64


def embedded(sections: list[Json], folder: Path, room: int) -> tuple[list[Json], int]:
    """The `sections` on plans with their pictures in them, whose files lie in `folder`; and what is left of `room`.

    A picture without a file there, or without room, is left out, with its caption and in `left_out` counted.
    """
    told: list[Json] = []
    for section in sections:
        if not isinstance(section, dict):
            continue
        pictures, left_out = [], 0
        given = section.get("pictures")
        for picture in given if isinstance(given, list) else []:
            assert isinstance(picture, dict)
            file = (folder / str(picture["file"])).with_suffix(".png")
            source = _source(file) if room > 0 and file.is_file() else ""
            room -= len(source)
            if source and room > 0:
                pictures.append({"source": source, "caption": picture["caption"]})
            else:
                left_out += 1
        told.append({**section, "pictures": [*pictures], "left_out": left_out})
    return told, max(0, room)


def _source(file: Path) -> str:
    """The picture in `file` as an address of its own."""
    from PIL import Image

    with Image.open(file) as whole:
        picture = whole.convert("RGB")
    if picture.width > _WIDTH:
        picture = picture.resize((_WIDTH, round(picture.height * _WIDTH / picture.width)), Image.Resampling.LANCZOS)
    few = picture.quantize(_COLOURS, dither=Image.Dither.NONE)
    content = io.BytesIO()
    few.save(content, "PNG", optimize=True)
    return f"data:image/png;base64,{base64.b64encode(content.getvalue()).decode()}"
