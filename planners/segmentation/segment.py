"""From an aerial image to a map: which pixels are drivable (paper 004, sec. 2.2, step 1)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from skimage.filters import threshold_otsu
from skimage.morphology import remove_small_holes, remove_small_objects

from planners.errors import InputError
from planners.kernel import Bools
from planners.segmentation.aerial import Aerial
from planners.segmentation.brightness import Singles, brightness, ground_brightness
from planners.segmentation.clusters import colour_clusters
from planners.segmentation.settings import Segmentation
from planners.segmentation.shade import discoloured

_WHITE = 255.0
_BRIGHTEST = 1.2  # of the ground's brightness nearby: glare, which says nothing of where the ground ends
_CONTRAST = 0.02  # of that brightness; less is no contrast


@dataclass(frozen=True, slots=True, eq=False)
class Segmented:
    """What was found: `blocked` (rows, cols), row 0 in the south, is obstacle.

    `threshold` is the share of the ground's brightness that divides both; `separability` Otsu's measure of how well it
    does, the variance between the two classes over that of all: 1 at best, 0.64 for normally distributed noise.
    """

    blocked: Bools
    threshold: float
    separability: float


def segment(aerial: Aerial, cell: float, settings: Segmentation, place: str) -> Segmented:
    """Tell drivable ground from obstacles in an image with pixels of `cell` [m].

    A pixel's brightness over that of the ground nearby is divided by Otsu's threshold (Otsu 1979, IEEE Trans. SMC
    9(1)), pixel by pixel or by the mean of clusters of colour. `place` names the image in errors. Raises `InputError`
    where there is no contrast, and where nothing is drivable.
    """
    luma, seen = brightness(aerial.colours), ~aerial.unseen
    if not luma[seen].any():
        raise InputError(place, "it is black all over, so nothing in it is drivable", "give another image")
    dark = settings.drivable == "dark"
    width = min(settings.shade / cell, 2.0 * max(luma.shape))  # wider ones see all of the image too
    ground = ground_brightness(luma, width, dark) if width else np.full_like(luma, _WHITE)
    share = _share(luma, ground, dark, bool(width))
    if np.ptp(share[seen]) < _CONTRAST:
        raise InputError(place, "it has no contrast: all of it is of one brightness", "give another image")
    threshold = settings.threshold or float(threshold_otsu(share[seen]))
    blocked = aerial.unseen | _unlike(aerial, ground, share, threshold, settings)
    if width:
        usual = float(np.median(ground[seen])) * (1.0 / threshold if dark else threshold)
        blocked |= _wide_obstacles(aerial, luma, blocked, usual, dark)
    blocked = _tidied(blocked, cell, settings)
    if blocked.all():
        remedy = "a lower threshold" if settings.threshold else "another drivable, method or shade"
        raise InputError(place, "nothing in it is found to be drivable", f"try {remedy}")
    return Segmented(blocked, threshold, _separability(share[seen], share[seen] < threshold))


def _unlike(aerial: Aerial, ground: Singles, share: Singles, threshold: float, settings: Segmentation) -> Bools:
    """Which pixels (rows, cols) are less alike to the ground than the threshold says, one by one or by clusters."""
    if settings.method == "otsu":
        return np.asarray(share < threshold)
    clusters = colour_clusters(aerial.colours, ground, settings.clusters)
    means = np.bincount(clusters.ravel(), share.ravel()) / np.bincount(clusters.ravel()).clip(1)
    return np.asarray((means < threshold)[clusters])


def _share(luma: Singles, ground: Singles, dark: bool, shaded: bool) -> Singles:
    """How alike to the ground nearby the brightness is: about 1 on it, towards 0 on obstacles; all (rows, cols)."""
    if dark and not shaded:
        return 1.0 - luma / ground
    ratio = ground / luma.clip(1.0) if dark else luma / ground
    return np.asarray(np.minimum(ratio, np.float32(_BRIGHTEST)))


def _separability(share: Singles, low: Bools) -> float:
    """Otsu's eta of the values (N,) divided into the `low` and the others."""
    below = float(low.mean())
    if below in (0.0, 1.0):
        return 0.0
    apart = float(share[low].mean(dtype=float) - share[~low].mean(dtype=float))
    return below * (1.0 - below) * apart**2 / float(share.var(dtype=float))


def _wide_obstacles(aerial: Aerial, luma: Singles, blocked: Bools, usual: float, dark: bool) -> Bools:
    """What stands out from the `usual` divide of the image, not from the ground nearby, and has another colour."""
    doubtful = ~blocked & ((luma > usual) if dark else (luma < usual))
    return np.asarray(doubtful & discoloured(aerial.colours, luma, ~blocked & ~doubtful))


def _tidied(blocked: Bools, cell: float, settings: Segmentation) -> Bools:
    """Without specks and small holes."""
    smallest, hole = (min(area / cell**2, blocked.size) for area in (settings.smallest_obstacle, settings.largest_hole))
    cleared = remove_small_objects(blocked, max_size=max(math.ceil(smallest) - 1, 0))
    return np.asarray(remove_small_holes(cleared, max_size=math.floor(hole)), dtype=bool)


def overlap(blocked: Bools, truth: Bools) -> float:
    """Intersection over union (Jaccard index) of the obstacles of two masks (rows, cols); 1 where neither has any."""
    union = int((blocked | truth).sum())
    return int((blocked & truth).sum()) / union if union else 1.0
