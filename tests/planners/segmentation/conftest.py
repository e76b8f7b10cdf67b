import numpy as np
import pytest
from PIL import Image

from sample_images import SCENARIOS


@pytest.fixture(scope="session")
def photo():
    """The aerial image (512, 512, 3)."""
    with Image.open(SCENARIOS / "aerial_640m.png") as picture:
        return np.asarray(picture.convert("RGB"))


@pytest.fixture(scope="session")
def truth():
    """Its obstacles, row 0 in the south."""
    with Image.open(SCENARIOS / "aerial_640m_truth.png") as picture:
        return np.asarray(picture.convert("L"))[::-1] >= 128
