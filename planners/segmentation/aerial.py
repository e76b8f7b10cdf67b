"""Aerial images: their colours and their scale."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np
from numpy.typing import NDArray

from planners.errors import InputError
from planners.kernel import Bools
from planners.picture import SQUARE, opened
from planners.segmentation.geotiff import scale_of

Colours = NDArray[np.uint8]

_EIGHT_BITS = ("1", "L", "LA", "P", "PA", "RGB", "RGBA", "RGBX", "CMYK", "YCbCr", "LAB", "HSV")


@dataclass(frozen=True, slots=True, eq=False)
class Aerial:
    """Red, green and blue (rows, cols, 3) as 0 to 255, row 0 in the south; `unseen` (rows, cols) is transparent."""

    colours: Colours
    unseen: Bools


def read_aerial(file: str | FilePath, place: str) -> Aerial:
    """The image in a PNG, JPEG or TIFF file; `place` names what gave it.

    Raises `InputError` for a file that is missing, too large, no picture, or one of more than 8 bits a channel.
    """
    with opened(file, place) as picture:
        if picture.mode not in _EIGHT_BITS:
            what = f"{file} is of Pillow's mode {picture.mode}, not of 8 bits a channel"
            raise InputError(place, what, "convert it, as with gdal_translate -ot Byte -scale")
        seen = picture.convert("RGBA")
    values = np.asarray(seen)[::-1]
    return Aerial(np.ascontiguousarray(values[..., :3]), values[..., 3] == 0)


def pixels_of(file: str | FilePath, place: str) -> tuple[int, int]:
    """Columns and rows of a picture; raises `InputError` as `read_aerial` does."""
    with opened(file, place) as picture:
        return picture.width, picture.height


def geotiff_scale(file: str | FilePath, place: str, remedy: str) -> float:
    """How wide a pixel is [m], from the tags of a GeoTIFF.

    Raises `InputError` where they do not tell, which ends with `remedy`, as what `read_aerial` cannot read does.
    """
    with opened(file, place) as picture:
        scale = scale_of(picture, place, remedy)
    if scale is None:
        raise InputError(place, f"nothing says how many metres a pixel of {file} is", remedy)
    return scale


def cell_of(pixels: tuple[int, int], size: tuple[float, float], place: str, file: str | FilePath) -> float:
    """The side of a cell, in the unit of `size`, of a picture with that many columns and rows.

    Raises `InputError` where it would not be square.
    """
    (columns, rows), (width, height) = pixels, size
    cell = width / columns
    if abs(height / rows / cell - 1.0) > SQUARE:
        what = f"{width:g} x {height:g} over {columns} x {rows} pixels of {FilePath(file).name} is not square"
        raise InputError(place, what, f"{width:g} wide it is {cell * rows:g} high")
    return cell
