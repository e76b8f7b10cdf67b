"""`trackworthy segment`: from an aerial image to a map."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from pathlib import Path

    from planners.segmentation.settings import Segmentation

_SETTINGS = ("method", "drivable", "threshold", "clusters", "shade", "smallest_obstacle", "largest_hole")
_REMEDY = "give --scale or --size"
_DOUBTFUL = 0.7  # separability; normally distributed noise has 2 / pi


class _Source(NamedTuple):
    """What is segmented: the image, the side of its pixels [m], how, its truth, and what all this was read from."""

    image: Path
    cell: float
    settings: Segmentation
    truth: Path | None
    files: tuple[Path, ...]


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "segment",
        help="find the drivable ground in an aerial image",
        description="Tell drivable ground from obstacles in an aerial image, and save the map and a picture of it.",
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add("source", metavar="IMAGE", help="a PNG, JPEG or GeoTIFF; or a scenario that has an image, by name or TOML file")
    scale = parser.add_mutually_exclusive_group()
    scale.add_argument("--size", metavar="WxH", help="width and height of the image in metres, as 640x480")
    scale.add_argument("--scale", type=float, metavar="M", help="metres a pixel; a GeoTIFF tells by itself")
    add("--method", choices=("otsu", "clusters"), help="one threshold of brightness, or clusters of colour")
    add("--drivable", choices=("light", "dark"), help="what drivable ground is, against obstacles (default: light)")
    add("--threshold", type=float, metavar="SHARE", help="of the ground's brightness; 0 to 1 (default: Otsu's)")
    add("--clusters", type=int, metavar="N", help="how many colours (default: 6)")
    add("--shade", type=float, metavar="M", help="wider dark areas of the ground's colour are shade (default: 75)")
    add("--smallest-obstacle", type=float, metavar="M2", help="what is smaller is a speck (default: 4)")
    add("--largest-hole", type=float, metavar="M2", help="in an obstacle, to be filled (default: 20)")
    add("--truth", metavar="MASK", help="a picture of the same shape in which obstacles are white, to compare with")
    add("-o", "--output", metavar="FILE.png", help="the map, drivable ground white (default: IMAGE-mask.png)")
    add("--figure", metavar="FILE", help="its picture, .png or .svg (default: IMAGE-segmented.png)")
    add("--json", action="store_true", help="print one JSON object on standard output and nothing else")


def main(args: argparse.Namespace) -> int:
    """Read, segment, compare, save and show."""
    from planners.picture import write_blocked
    from planners.scenario_picture import read_truth
    from planners.segmentation.aerial import read_aerial
    from planners.segmentation.facts import facts_of
    from planners.segmentation.segment import segment
    from reports.figures.segmentation_figure import save_segmentation_figure
    from reports.terminal.segmentation_table import print_segmentation, segmentation_json
    from trackworthy.streams import tell

    source = _source(args)
    mask, figure = _outputs(args, source)
    aerial = read_aerial(source.image, str(source.image))
    rows, columns = aerial.unseen.shape
    truth = read_truth(source.truth, (columns, rows), str(source.truth)) if source.truth else None
    found = segment(aerial, source.cell, source.settings, str(source.image))
    facts = facts_of(source.image.name, found, source.cell, source.settings, truth)
    write_blocked(found.blocked, mask)
    save_segmentation_figure(aerial, found.blocked, facts, figure, truth)
    if args.json:
        print(segmentation_json(facts, mask, figure))
    else:
        print_segmentation(facts)
    if facts.separability < _DOUBTFUL:
        tell([f"{source.image}: two kinds of ground hardly stand apart, see separability; look at {figure}"])
    tell([f"saved {mask}", f"saved {figure}"])
    return 0


def _source(args: argparse.Namespace) -> _Source:
    """What the arguments name; the options say more than a scenario does, and both more than a GeoTIFF."""
    from pathlib import Path

    from planners.scenario import BUILT_IN_SCENARIOS
    from planners.segmentation.aerial import geotiff_scale
    from planners.segmentation.settings import Segmentation

    if args.source in BUILT_IN_SCENARIOS or args.source.lower().endswith(".toml"):
        return _of_scenario(args)
    image = Path(args.source)
    cell = _cell(args, image, args.source) or geotiff_scale(image, args.source, _REMEDY)
    truth = Path(args.truth) if args.truth else None
    return _Source(image, cell, _settings(args, Segmentation()), truth, (image,))


def _of_scenario(args: argparse.Namespace) -> _Source:
    """The image of a scenario, whose map need not be plannable."""
    from pathlib import Path

    from planners.errors import InputError
    from planners.picture import cell_of, pixels_of
    from planners.scenario import find_scenario
    from planners.scenario_keys import ScenarioKeys
    from planners.scenario_picture import size_of
    from planners.segmentation.settings import Segmentation
    from planners.typed_toml import read_toml

    file = find_scenario(args.source)
    keys = read_toml(file, ScenarioKeys)
    if keys.image is None:
        raise InputError(str(file), "it has no image to segment", 'add image = "FILE"')
    image, place = file.parent / keys.image, f"{file}: image"
    cell = _cell(args, image, place)
    if cell is None:
        cell = cell_of(pixels_of(image, place), size_of(keys, file), f"{file}: size", image) * keys.unit
    truth = Path(args.truth) if args.truth else (file.parent / keys.truth if keys.truth else None)
    return _Source(image, cell, _settings(args, keys.segment or Segmentation()), truth, (file, image))


def _cell(args: argparse.Namespace, image: Path, place: str) -> float | None:
    """The side of a pixel [m] that the options tell, None where they do not."""
    import math

    from planners.errors import InputError
    from planners.picture import cell_of, pixels_of

    if args.size is not None:
        return cell_of(pixels_of(image, place), _size(args.size), "--size", image)
    if args.scale is not None and not 0.0 < args.scale < math.inf:
        raise InputError("--scale", f"{args.scale} metres a pixel is not possible", "give more than 0")
    return None if args.scale is None else float(args.scale)


def _settings(args: argparse.Namespace, stated: Segmentation) -> Segmentation:
    """Those `stated`, but for what the options say."""
    import msgspec

    from planners.segmentation.settings import Segmentation
    from planners.typed_toml import convert

    given = {key: value for key in _SETTINGS if (value := getattr(args, key)) is not None}
    return convert({**msgspec.to_builtins(stated), **given}, Segmentation, "options")


def _size(text: str) -> tuple[float, float]:
    """Width and height [m] of "640x480"."""
    import math

    from planners.errors import InputError

    try:
        width, height = (float(side) for side in text.lower().split("x"))
    except ValueError:
        width = height = math.nan
    if not (0.0 < width < math.inf and 0.0 < height < math.inf):
        raise InputError("--size", f"{text!r} is no width and height", "give metres, as 640x480")
    return width, height


def _outputs(args: argparse.Namespace, source: _Source) -> tuple[str, str]:
    """The names of mask and figure, where they can be written: better known before the work than after it."""
    import os

    from planners.atomic_file import check_folder
    from planners.errors import InputError
    from trackworthy.streams import check_picture, protect

    mask = args.output or f"{source.image.stem}-mask.png"
    figure = args.figure or f"{source.image.stem}-segmented.png"
    if not mask.lower().endswith(".png"):
        raise InputError(mask, "a mask is a .png file", "give it that suffix")
    check_folder(mask)
    check_picture(figure)
    if os.path.abspath(mask) == os.path.abspath(figure):
        raise InputError(figure, "mask and figure cannot be one file", "give another name")
    read = [*source.files, *([source.truth] if source.truth else [])]
    for file in (mask, figure):
        protect(file, *map(str, read))
    return mask, figure
