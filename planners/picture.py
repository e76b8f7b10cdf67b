"""Obstacle maps drawn as pictures."""

from __future__ import annotations

import struct
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path as FilePath

import numpy as np
from PIL import Image

from planners.atomic_file import atomic
from planners.errors import InputError
from planners.kernel import Bools

MIDDLE = 128  # of 0 to 255: lighter counts as white
MOST_PIXELS = 25_000_000  # so that a small file cannot take all memory
SQUARE = 1e-3  # relative: how far a picture's cells may be from square


@contextmanager
def opened(file: str | FilePath, place: str) -> Iterator[Image.Image]:
    """The picture in `file`, its pixels yet to be read; to be read within this context.

    `place` names what gave the file. Raises `InputError` for one that is missing, too large or no picture.
    """
    it = "it" if place == str(file) else str(file)
    try:
        with warnings.catch_warnings():  # Pillow's own limit lies above ours
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            picture = Image.open(file)
        with picture:
            if picture.width * picture.height > MOST_PIXELS:
                what = f"{it} has {picture.width} x {picture.height} pixels"
                raise InputError(place, what, f"make it smaller, at most {MOST_PIXELS} pixels in all")
            yield picture
    except FileNotFoundError:
        what = "there is no such picture" if it == "it" else f"there is no picture {file}"
        raise InputError(place, what, "check the path") from None
    except (OSError, ValueError, SyntaxError, TypeError, struct.error, Image.DecompressionBombError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InputError(place, f"{it} cannot be read as a picture ({reason})", "give a PNG, JPEG or TIFF") from None


def pixels_of(file: str | FilePath, place: str) -> tuple[int, int]:
    """Columns and rows of a picture; raises `InputError` as `opened` does."""
    with opened(file, place) as picture:
        return picture.width, picture.height


def cell_of(pixels: tuple[int, int], size: tuple[float, float], place: str, file: str | FilePath) -> float:
    """The side of a cell, in the unit of `size`, of a picture with that many columns and rows.

    Raises `InputError` where it would not be square.
    """
    (columns, rows), (width, height) = pixels, size
    cell = width / columns
    if abs(height / rows / cell - 1.0) > SQUARE:
        what = f"{width} x {height} over {columns} x {rows} pixels of {FilePath(file).name} is not square"
        raise InputError(place, what, f"{width} wide it is {cell * rows:g} high")
    return cell


def read_blocked(file: FilePath, white_is_obstacle: bool, place: str) -> Bools:
    """The obstacle cells (rows, cols) of a picture, one a pixel, row 0 in the south.

    `place` names the key that gave the file. Raises `InputError` for a file that is missing, too large or no picture,
    and for a picture without free cells.
    """
    with opened(file, place) as picture:
        light = np.asarray(picture.convert("L")) >= MIDDLE
    blocked = light if white_is_obstacle else ~light
    if blocked.all():
        free = "black" if white_is_obstacle else "white"
        raise InputError(place, f"{file} is all obstacle", f"draw drivable ground in {free}")
    return blocked[::-1]


def write_blocked(blocked: Bools, file: str | FilePath) -> None:
    """Write the cells (rows, cols), row 0 in the south, as PNG that `read_blocked` reads: drivable ground white.

    Raises `InputError` where the folder does not exist.
    """
    with atomic(file) as temporary:
        Image.fromarray(~blocked[::-1]).save(temporary, format="PNG")
