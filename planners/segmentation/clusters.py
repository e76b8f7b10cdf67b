"""Clusters of colour."""

from __future__ import annotations

import numpy as np
from scipy.cluster.vq import kmeans2, vq
from skimage.color import rgb2lab

from planners.kernel import Ints
from planners.segmentation.aerial import Colours
from planners.segmentation.brightness import Singles

_SAMPLE = 10_000  # pixels that the clusters are found from
_SEED = 0  # the same image has the same clusters
_WHITE = 255.0


def colour_clusters(colours: Colours, ground: Singles, count: int) -> Ints:
    """Which of at most `count` clusters each pixel (rows, cols) belongs to.

    k-means in CIE L*a*b* (D65), from the start of Arthur and Vassilvitskii 2007, of the `colours` (rows, cols, 3) as
    they would be were the `ground`'s brightness (rows, cols) its median everywhere.
    """
    rng = np.random.default_rng(_SEED)
    light = (np.median(ground) / _WHITE) / ground
    even = (colours * light[..., None]).clip(0.0, 1.0)
    lab = rgb2lab(even).reshape(-1, 3)
    sample = lab[rng.integers(0, len(lab), _SAMPLE)]
    # A cluster that lost its last pixel is no trouble: no pixel is nearest to it
    centres, _ = kmeans2(sample, count, minit="++", missing="raise", rng=rng)
    return np.asarray(vq(lab, centres)[0], dtype=np.int64).reshape(ground.shape)
