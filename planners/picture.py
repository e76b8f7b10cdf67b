"""Obstacle maps drawn as pictures."""

from __future__ import annotations

from pathlib import Path as FilePath

import numpy as np
from PIL import Image

from planners.errors import InputError
from planners.kernel import Bools

MIDDLE = 128  # of 0 to 255: lighter counts as white


def read_blocked(file: FilePath, white_is_obstacle: bool, place: str) -> Bools:
    """The obstacle cells (rows, cols) of a picture, one a pixel, row 0 in the south.

    `place` names the key that gave the file. Raises `InputError` for a file that is missing or no picture,
    and for a picture without free cells.
    """
    try:
        with Image.open(file) as picture:
            light = np.asarray(picture.convert("L")) >= MIDDLE
    except FileNotFoundError:
        raise InputError(place, f"there is no picture {file}", "put it beside the scenario file") from None
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise InputError(place, f"{file} cannot be read as a picture ({error})", "give a PNG") from None
    blocked = light if white_is_obstacle else ~light
    if blocked.all():
        free = "black" if white_is_obstacle else "white"
        raise InputError(place, f"{file} is all obstacle", f"draw drivable ground in {free}")
    return blocked[::-1]
