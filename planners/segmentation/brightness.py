"""How bright an image is, and how bright the ground is about each pixel."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from skimage.filters import rank
from skimage.morphology import disk

from planners.segmentation.aerial import Colours

Singles = NDArray[np.float32]

_LUMA = np.array([0.299, 0.587, 0.114], dtype=np.float32)  # of red, green, blue: ITU-R BT.601
_MOST = 32  # cells; a wider disc is taken on coarser cells, for it costs as its radius does
_BLUR = 1.0  # cells; a noisy pixel is not the ground's brightness


def brightness(colours: Colours) -> Singles:
    """The luma (rows, cols) of an image (rows, cols, 3), both 0 to 255."""
    return np.asarray(colours @ _LUMA, dtype=np.float32)


def ground_brightness(luma: Singles, width: float, dark: bool) -> Singles:
    """What the ground's brightness (rows, cols) is about each pixel, at least 1.

    Obstacles that are darker than the ground, and that a disc of `width` [pixels] does not fit into, take the
    brightness of the ground around them: grey-scale closing by the disc, as in shading correction (Gonzalez and Woods,
    "Digital Image Processing", 3rd ed., sec. 9.6.3). Of `dark` ground the brighter ones do, by opening.
    """
    step = max(1, math.ceil(width / 2 / _MOST))
    coarse = gaussian_filter(_means(luma, step), _BLUR)
    radius = max(1, round(width / 2 / step))
    around, round_about = np.pad(np.rint(coarse).astype(np.uint8), radius, mode="symmetric"), disk(radius)
    if dark:
        ground = rank.maximum(rank.minimum(around, round_about), round_about)
    else:
        ground = rank.minimum(rank.maximum(around, round_about), round_about)
    ground = ground[radius:-radius, radius:-radius].clip(1).astype(np.float32)
    rows, columns = luma.shape
    return np.asarray(ground.repeat(step, axis=0)[:rows].repeat(step, axis=1)[:, :columns])


def _means(luma: Singles, step: int) -> Singles:
    """The means of squares of `step` x `step` pixels; those past the edge repeat it."""
    if step == 1:
        return luma
    rows, columns = (-side % step for side in luma.shape)
    whole = np.pad(luma, ((0, rows), (0, columns)), mode="edge")
    squares = whole.reshape(whole.shape[0] // step, step, whole.shape[1] // step, step)
    return np.asarray(squares.mean(axis=(1, 3)))
