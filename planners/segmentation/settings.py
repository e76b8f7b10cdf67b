"""How a picture is told apart into drivable ground and obstacles."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

_LARGEST = 1e9  # [m], [m^2] anything larger is a slip

Positive = Annotated[float, msgspec.Meta(gt=0.0, le=_LARGEST)]
NotNegative = Annotated[float, msgspec.Meta(ge=0.0, le=_LARGEST)]


class Segmentation(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The table `[segment]` of a scenario, and the options of `trackworthy segment`.

    `scale` [m] is how wide a pixel is; None where the size of the map, or the GeoTIFF, tells. `method` is "otsu", one
    threshold of brightness, or "clusters", as many colours as `clusters` says, each drivable or not as a whole.
    `drivable` ground is "light" or "dark". `threshold` is what divides both, a share of the ground's brightness nearby
    (of dark ground: that brightness over the pixel's); None leaves it to Otsu's method.

    An area darker than the ground (dark ground: brighter) and wider than `shade` [m] is the ground in another light,
    and no obstacle, if it has the ground's colour; 0 knows one light only, and `threshold` is then a share of white.
    Obstacles smaller than `smallest_obstacle` [m^2] are taken for specks, holes in obstacles of at most `largest_hole`
    [m^2] are filled.
    """

    scale: Positive | None = None
    method: Literal["otsu", "clusters"] = "otsu"
    drivable: Literal["light", "dark"] = "light"
    threshold: Annotated[float, msgspec.Meta(gt=0.0, lt=1.0)] | None = None
    clusters: Annotated[int, msgspec.Meta(ge=2, le=32)] = 6
    shade: NotNegative = 75.0
    smallest_obstacle: NotNegative = 4.0
    largest_hole: NotNegative = 20.0
