"""The picture of a scenario file: its size, and the cells it makes, drawn as such or segmented."""

from __future__ import annotations

from pathlib import Path as FilePath

from planners.errors import InputError
from planners.kernel import Bools
from planners.map import Raster
from planners.picture import cell_of, pixels_of, read_blocked
from planners.scenario_keys import Point, ScenarioKeys

_SIZE = "add size = [width, height]"


def size_of(keys: ScenarioKeys, file: FilePath) -> Point:
    """Width and height [map units]: as given, or what the scale of the picture makes of it.

    Raises `InputError` where nothing tells, or two things do.
    """
    scale = keys.segment.scale if keys.segment else None
    if keys.size is not None:
        if scale is not None:
            raise InputError(f"{file}: segment.scale", "size is given too", "leave size or scale out")
        return keys.size
    if keys.image is None:
        raise InputError(str(file), "'size' is missing", _SIZE)
    image, place = file.parent / keys.image, f"{file}: image"
    columns, rows = pixels_of(image, place)
    if scale is None:
        from planners.segmentation.aerial import geotiff_scale

        scale = geotiff_scale(image, place, _SIZE)
    return columns * scale / keys.unit, rows * scale / keys.unit


def raster_of(keys: ScenarioKeys, size: Point, file: FilePath) -> Raster | None:
    """The cells of a map of that `size` [map units]; None without a picture.

    With a table `segment` they are what is found in `image`; without one, those of `truth`, or else of `image`.
    Raises `InputError` for a picture that cannot be used, and for a `truth` of another shape.
    """
    if keys.segment is not None:
        return _segmented(keys, size, file)
    name, key = (keys.truth, "truth") if keys.truth is not None else (keys.image, "image")
    if name is None:
        return None
    blocked = read_blocked(file.parent / name, white_is_obstacle=key == "truth", place=f"{file}: {key}")
    rows, columns = blocked.shape
    return Raster(blocked, cell_of((columns, rows), size, f"{file}: size", name) * keys.unit)


def read_truth(file: str | FilePath, pixels: tuple[int, int], place: str) -> Bools:
    """The true obstacles (rows, cols) of an image of that many columns and rows, white in a picture of the same shape.

    `place` names what gave the file. Raises `InputError` for a picture that cannot be used, or of another shape.
    """
    blocked = read_blocked(FilePath(file), white_is_obstacle=True, place=place)
    (columns, rows), (high, wide) = pixels, blocked.shape
    if (wide, high) != (columns, rows):
        what = f"its {wide} x {high} pixels are not the {columns} x {rows} of the image"
        raise InputError(place, what, "give a mask of the same size")
    return blocked


def _segmented(keys: ScenarioKeys, size: Point, file: FilePath) -> Raster:
    """What is found in the image; its truth is only seen to fit."""
    from planners.segmentation.aerial import read_aerial  # scikit-image takes half a second to import
    from planners.segmentation.segment import segment

    if keys.image is None or keys.segment is None:
        raise InputError(f"{file}: segment", "there is no image to segment", 'add image = "FILE"')
    place = f"{file}: image"
    aerial = read_aerial(file.parent / keys.image, place)
    rows, columns = aerial.unseen.shape
    cell = cell_of((columns, rows), size, f"{file}: size", keys.image) * keys.unit
    if keys.truth is not None:
        read_truth(file.parent / keys.truth, (columns, rows), f"{file}: truth")
    return Raster(segment(aerial, cell, keys.segment, place).blocked, cell)
