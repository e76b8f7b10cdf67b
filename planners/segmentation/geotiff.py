"""How wide a pixel of a GeoTIFF is (OGC GeoTIFF standard 1.1, document 19-008r4)."""

from __future__ import annotations

import math
from typing import Any

import pyproj
from PIL import Image
from pyproj.exceptions import CRSError

from planners.errors import InputError
from planners.picture import SQUARE

_PIXEL_SCALE, _TIE_POINT, _KEYS = 33550, 33922, 34735  # ModelPixelScaleTag, ModelTiepointTag, GeoKeyDirectoryTag
_MODEL_TYPE, _PROJECTION, _LINEAR_UNIT = 1024, 3072, 3076  # keys in that directory
_PROJECTED, _USER_DEFINED = 1, 32767
_METRES = {9001: 1.0, 9002: 0.3048, 9003: 1200.0 / 3937.0}  # EPSG codes of metre, foot and US survey foot


def scale_of(picture: Image.Image, place: str, remedy: str) -> float | None:
    """The side of a pixel on the ground [m]; None without such a tag.

    Map projections stretch: a pixel's side is divided by the scale factor of the projection, if that has an EPSG code,
    in the middle of the picture. Raises `InputError`, with that `remedy`, for a scale in degrees, for an unknown
    unit or projection and for pixels that are not square.
    """
    tags: dict[int, Any] = dict(getattr(picture, "tag_v2", {}))
    if _PIXEL_SCALE not in tags:
        return None
    width, height = (float(side) for side in tags[_PIXEL_SCALE][:2])
    if not (math.isfinite(width) and math.isfinite(height) and width > 0.0 and height > 0.0):
        raise InputError(place, f"its ModelPixelScaleTag says {width} x {height}", remedy)
    keys = _keys(tags.get(_KEYS, ()))
    if keys.get(_MODEL_TYPE, _PROJECTED) != _PROJECTED:
        raise InputError(
            place, "its scale is in degrees", f"reproject it to metres, as with gdalwarp -t_srs; or {remedy}"
        )
    if abs(height / width - 1.0) > SQUARE:
        raise InputError(place, f"its pixels are {width} x {height}, not square", "resample it, as with gdalwarp -tr")
    code = keys.get(_PROJECTION, _USER_DEFINED)
    if code == _USER_DEFINED:
        unit = keys.get(_LINEAR_UNIT, 9001)
        if unit not in _METRES:
            raise InputError(place, f"its scale is in the unit EPSG:{unit}, which is not known here", remedy)
        return width * _METRES[unit]
    try:
        projection = pyproj.CRS.from_epsg(code)
    except CRSError:
        raise InputError(place, f"its projection EPSG:{code} is not known", remedy) from None
    metres = projection.axis_info[0].unit_conversion_factor
    return width * metres / _stretch(projection, picture, tags, width)


def _keys(directory: Any) -> dict[int, int]:
    """The keys whose value stands in the directory itself: rows of key, where the value is (0: here), count, value."""
    rows = [directory[i : i + 4] for i in range(4, len(directory) - 3, 4)]
    return {int(key): int(value) for key, location, _, value in rows if location == 0}


def _stretch(projection: pyproj.CRS, picture: Image.Image, tags: dict[int, Any], pixel: float) -> float:
    """The projection's scale factor along the meridian, in the middle of the picture; 1 where that has no place."""
    if len(tags.get(_TIE_POINT, ())) < 6:
        return 1.0
    column, row, _, x, y, _ = tags[_TIE_POINT][:6]
    x, y = x + (picture.width / 2 - column) * pixel, y - (picture.height / 2 - row) * pixel
    project = pyproj.Proj(projection)
    factor = float(project.get_factors(*project(x, y, inverse=True)).meridional_scale)
    return factor if math.isfinite(factor) and factor > 0.0 else 1.0
