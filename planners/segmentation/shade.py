"""Shade on the ground, told from wide obstacles by its colour."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import label

from planners.kernel import Bools
from planners.segmentation.aerial import Colours
from planners.segmentation.brightness import Singles

_ALIKE = 2.0  # standard deviations of the ground's own colour
_GREY = 1e-3  # an image whose colour varies less has none


def discoloured(colours: Colours, luma: Singles, doubtful: Bools, ground: Bools) -> Bools:
    """Those of the connected areas of `doubtful` pixels that have not the colour of the `ground`; all (rows, cols).

    Less light leaves the shares of red, green and blue in `luma` as they are. An area is of the ground's colour if the
    mean of each lies within two standard deviations of it over the ground. A grey image tells nothing: none is.
    """
    areas, count = label(doubtful)
    sizes = np.bincount(areas.ravel(), minlength=count + 1).clip(1)
    alike = np.full(count + 1, bool(ground.any()))
    for colour in np.moveaxis(colours, -1, 0):
        share = colour / luma.clip(1.0)
        mean, spread = share[ground].mean(), share[ground].std()
        means = np.bincount(areas.ravel(), share.ravel(), count + 1) / sizes
        alike &= (np.abs(means - mean) <= _ALIKE * spread) & (spread > _GREY)
    return np.asarray(~alike[areas] & doubtful)
