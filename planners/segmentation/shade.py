"""Shade on the ground, told from obstacles by its colour."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter

from planners.kernel import Bools
from planners.segmentation.aerial import Colours
from planners.segmentation.brightness import Singles

_ALIKE = 3.5  # standard deviations of the ground's own colour
_GREY = 1e-3  # an image whose colour varies less has none
_BLUR = 1.0  # pixels; noise is no colour


def discoloured(colours: Colours, luma: Singles, ground: Bools) -> Bools:
    """Which pixels (rows, cols) have not the colour of those of `ground`.

    Less light leaves the shares of red, green and blue in `luma` as they are: a pixel is of the ground's colour if each
    lies within 3.5 standard deviations of its mean on the ground. A grey image cannot tell: none is.
    """
    strange = np.full(ground.shape, not ground.any())
    if strange.all():
        return strange
    light = gaussian_filter(luma, _BLUR).clip(1.0)
    for colour in np.moveaxis(colours, -1, 0):
        share = gaussian_filter(colour.astype(np.float32), _BLUR) / light
        mean, spread = (float(of(share[ground], dtype=float)) for of in (np.mean, np.std))
        strange |= np.abs(share - mean) > (_ALIKE * spread if spread > _GREY else -1.0)
    return strange
