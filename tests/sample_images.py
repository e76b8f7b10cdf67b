"""Aerial images, as they are and as cameras spoil them."""

import io
from pathlib import Path

import numpy as np
from PIL import Image

import planners
from planners.segmentation.aerial import Aerial

SCENARIOS = Path(planners.__file__).parent / "scenarios"
CELL = 1.25


def bytes_of(values):
    return np.clip(np.rint(values), 0, 255).astype(np.uint8)


def aerial_of(colours):
    """An image whose first row is the north; one channel is grey."""
    colours = np.asarray(colours, dtype=np.uint8)
    if colours.ndim == 2:
        colours = np.repeat(colours[..., None], 3, axis=2)
    return Aerial(np.ascontiguousarray(colours[::-1]), np.zeros(colours.shape[:2], dtype=bool))


def jpeg(colours, quality):
    file = io.BytesIO()
    Image.fromarray(colours).save(file, "JPEG", quality=quality)
    with Image.open(file) as picture:
        return np.asarray(picture.convert("RGB"))


def noisy(colours, sigma, seed):
    return bytes_of(colours + np.random.default_rng(seed).normal(0.0, sigma, colours.shape))


def banded(colours, angle_deg, offset, light, width=80):
    """A straight band, that many pixels wide and in `light`, `offset` pixels from the middle."""
    rows, columns = colours.shape[:2]
    y, x = np.mgrid[:rows, :columns] - np.array([rows / 2, columns / 2])[:, None, None]
    across = x * np.cos(np.radians(angle_deg)) + y * np.sin(np.radians(angle_deg)) - offset
    return bytes_of(colours * np.where(np.abs(across) < width / 2, light, 1.0)[..., None])
