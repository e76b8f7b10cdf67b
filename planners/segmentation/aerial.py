"""Aerial images: their colours and their scale."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np
from numpy.typing import NDArray

from planners.errors import InputError
from planners.kernel import Bools
from planners.picture import opened
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
            what = f"its pixels are of Pillow's mode {picture.mode}, not of 8 bits a channel"
            raise InputError(place, what, "convert it, as with gdal_translate -ot Byte -scale")
        seen = picture.convert("RGBA")
    values = np.asarray(seen)[::-1]
    return Aerial(np.ascontiguousarray(values[..., :3]), values[..., 3] == 0)


def geotiff_scale(file: str | FilePath, place: str, remedy: str) -> float:
    """How wide a pixel is [m], from the tags of a GeoTIFF.

    Raises `InputError` where they do not tell, which ends with `remedy`, as what `read_aerial` cannot read does.
    """
    with opened(file, place) as picture:
        scale = scale_of(picture, place, remedy)
    if scale is None:
        raise InputError(place, "nothing says how many metres wide a pixel is", remedy)
    return scale
