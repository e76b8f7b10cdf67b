"""Clusters of colour."""

from __future__ import annotations

import warnings

import numpy as np
from scipy.cluster.vq import kmeans2, vq
from skimage.color import rgb2lab

from planners.kernel import Ints
from planners.segmentation.aerial import Colours
from planners.segmentation.brightness import Singles

_SAMPLE = 10_000  # pixels that the clusters are found from
_AT_ONCE = 1_000_000  # pixels, for the memory they take
_SEED = 0  # the same image has the same clusters
_WHITE = 255.0


def colour_clusters(colours: Colours, ground: Singles, count: int) -> Ints:
    """Which of at most `count` clusters each pixel (rows, cols) belongs to.

    k-means in CIE L*a*b* (D65), from the start of Arthur and Vassilvitskii 2007, of the `colours` (rows, cols, 3) as
    they would be were the `ground`'s brightness (rows, cols) its median everywhere.
    """
    rng = np.random.default_rng(_SEED)
    usual = float(np.median(ground)) / _WHITE
    flat, light = colours.reshape(-1, 3), usual / ground.ravel()
    at = rng.integers(0, len(flat), _SAMPLE)
    sample = _lab(flat[at], light[at])
    count = min(count, len(np.unique(sample, axis=0)))
    with warnings.catch_warnings():  # a cluster may lose its last pixel, and then has none in the image either
        warnings.simplefilter("ignore", UserWarning)
        centres, _ = kmeans2(sample, count, minit="++", rng=rng)
    pieces = [slice(i, i + _AT_ONCE) for i in range(0, len(flat), _AT_ONCE)]
    nearest = [vq(_lab(flat[piece], light[piece]), centres)[0] for piece in pieces]
    return np.concatenate(nearest, dtype=np.int64).reshape(ground.shape)


def _lab(colours: Colours, light: Singles) -> Singles:
    """CIE L*a*b* of the colours (N, 3) in so much more light (N,)."""
    return np.asarray(rgb2lab((colours * light[:, None]).clip(0.0, 1.0)))
