import numpy as np
import pytest

from planners.segmentation.brightness import brightness, ground_brightness


def test_luma_is_that_of_bt_601():
    primaries = np.array([[[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]]], dtype=np.uint8)
    assert brightness(primaries)[0] == pytest.approx([76.245, 149.685, 29.07, 255.0], abs=1e-4)


@pytest.mark.parametrize("dark", [False, True])
def test_what_the_disc_does_not_fit_into_takes_the_brightness_around(dark):
    ground, obstacle = (50, 200) if dark else (200, 50)
    luma = np.full((120, 160), ground, dtype=np.float32)
    luma[40:60, 40:100] = obstacle  # 20 pixels high
    assert (ground_brightness(luma, 40.0, dark) == ground).all()
    luma[30:110, 20:140] = obstacle  # 80
    wide = ground_brightness(luma, 40.0, dark)
    assert wide[70, 80] == obstacle
    assert wide[5, 5] == ground


def test_a_wide_disc_is_taken_on_coarser_cells():
    luma = np.full((301, 403), 200, dtype=np.float32)
    luma[100:180, 100:300] = 50
    assert (ground_brightness(luma, 200.0, dark=False) == 200).all()
    luma[50:, 50:] = 50
    wide = ground_brightness(luma, 200.0, dark=False)
    assert wide.shape == luma.shape
    assert wide[200, 250] == 50


def test_ground_is_never_darker_than_what_is_seen_of_it():
    luma = np.random.default_rng(3).integers(0, 256, (50, 70)).astype(np.float32)
    smooth = ground_brightness(luma, 1.0, dark=False)  # the smallest disc
    assert (ground_brightness(luma, 20.0, dark=False) >= smooth).all()
    assert (ground_brightness(luma, 20.0, dark=True) <= ground_brightness(luma, 1.0, dark=True)).all()
