import math

import numpy as np
import pytest

from planners.errors import InputError
from planners.segmentation.aerial import Aerial
from planners.segmentation.segment import overlap, segment
from planners.segmentation.settings import Segmentation
from sample_images import CELL, aerial_of, banded, bytes_of, jpeg, noisy

# The settings were chosen on other bands, noise and places than these
VARIANTS = {
    "as it is": (0.98, lambda image: image),
    "brighter by 20 %": (0.98, lambda image: bytes_of(1.2 * image)),
    "darker by 20 %": (0.98, lambda image: bytes_of(0.8 * image)),
    "JPEG of quality 50": (0.98, lambda image: jpeg(image, 50)),
    "noise of 10": (0.98, lambda image: noisy(image, 10.0, 5)),
    "noise of 20": (0.98, lambda image: noisy(image, 20.0, 6)),
    "upright band at 60 %": (0.98, lambda image: banded(image, 0.0, 40.0, 0.6)),
    "upright band at 50 %": (0.98, lambda image: banded(image, 0.0, 40.0, 0.5)),
    "diagonal band at 60 %": (0.98, lambda image: banded(image, 45.0, -85.0, 0.6)),
    "diagonal band at 50 %": (0.98, lambda image: banded(image, 45.0, -85.0, 0.5)),
    "steep band at 50 %, noise of 10": (0.95, lambda image: noisy(banded(image, -20.0, 70.0, 0.5), 10.0, 7)),
    "flat band at 50 %, JPEG of quality 50": (0.95, lambda image: jpeg(banded(image, 80.0, -120.0, 0.5), 50)),
}
FIELD, ROOF = 200, 60


def found(colours, cell=CELL, **settings):
    """What is obstacle in an image whose first row is the north, in its rows."""
    return segment(aerial_of(colours), cell, Segmentation(**settings), "here").blocked[::-1]


def field(*rectangles, size=(60, 80), ground=FIELD, roof=ROOF):
    """A grey field with darker rectangles: rows and columns from, to."""
    image = np.full(size, ground)
    for top, bottom, left, right in rectangles:
        image[top:bottom, left:right] = roof
    return image


@pytest.mark.parametrize("name", VARIANTS)
def test_the_obstacles_of_the_aerial_image(photo, truth, name):
    least, vary = VARIANTS[name]
    blocked = segment(aerial_of(vary(photo)), CELL, Segmentation(), "here").blocked
    assert overlap(blocked, truth) >= least


@pytest.mark.parametrize("name", ["as it is", "noise of 20", "diagonal band at 50 %"])
def test_its_obstacles_by_clusters_of_colour(photo, truth, name):
    least, vary = VARIANTS[name]
    settings = Segmentation(method="clusters")
    first, second = (segment(aerial_of(vary(photo)), CELL, settings, "here").blocked for _ in range(2))
    assert overlap(first, truth) >= least
    assert (first == second).all()


@pytest.mark.parametrize("method", ["otsu", "clusters"])
@pytest.mark.parametrize("shade", [0.0, 75.0])
@pytest.mark.parametrize("clusters", [2, 6])
def test_two_tones_are_told_apart_to_the_pixel(method, shade, clusters):
    image = field((10, 30, 20, 50), (40, 55, 5, 20))
    assert (found(image, method=method, shade=shade, clusters=clusters) == (image == ROOF)).all()


@pytest.mark.parametrize("shade", [0.0, 75.0])
def test_drivable_ground_may_be_dark(shade):
    image = field((10, 30, 20, 50), ground=ROOF, roof=FIELD)
    assert (found(image, drivable="dark", shade=shade) == (image == FIELD)).all()


def test_the_threshold_is_a_share_of_the_brightness_of_the_ground():
    image = field((10, 20, 20, 50), roof=100)
    image[30:40, 20:50] = 140  # 0.5 and 0.7 of it
    assert (found(image, threshold=0.6) == (image == 100)).all()
    assert (found(image, threshold=0.75) == (image < FIELD)).all()


def test_without_shade_it_is_a_share_of_white():
    image = field((10, 20, 20, 50), roof=100)
    assert found(image, threshold=101 / 255, shade=0.0).sum() == 300
    assert not found(image, threshold=99 / 255, shade=0.0).any()


def test_wide_obstacles_differ_from_shade_by_their_colour(photo):
    area = np.s_[:200, 300:]  # 250 m high and 265 m wide
    for colour in ((42, 86, 114), (40, 75, 35), (0, 0, 0)):
        lake = photo.copy()
        lake[area] = colour
        assert found(lake)[area].all()
    cloudy = photo.copy()
    cloudy[area] = bytes_of(0.5 * cloudy[area])
    assert overlap(found(cloudy), found(photo)) >= 0.97


def test_a_grey_image_takes_wide_shade_for_an_obstacle():
    image = field((0, 60, 0, 100), size=(150, 200))
    assert (found(image, cell=2.0) == (image == ROOF)).all()


def test_specks_and_holes_go_by_their_area():
    image = field((10, 12, 10, 12), (20, 22, 10, 13), (30, 50, 30, 50))
    image[35:37, 35:38], image[42:44, 42:46] = FIELD, FIELD  # of 6 and of 8 pixels
    cell = 0.5
    tidy = found(image, cell, smallest_obstacle=6 * cell**2, largest_hole=6 * cell**2, shade=0.0)
    wanted = field((20, 22, 10, 13), (30, 50, 30, 50)) == ROOF
    wanted[42:44, 42:46] = False
    assert (tidy == wanted).all()
    untouched = found(image, cell, smallest_obstacle=0.0, largest_hole=0.0, shade=0.0)
    assert (untouched == (image == ROOF)).all()


def test_what_is_not_seen_is_an_obstacle():
    seen = aerial_of(field((10, 30, 20, 50)))
    unseen = np.zeros((60, 80), dtype=bool)
    unseen[:, 70:] = True
    blocked = segment(Aerial(seen.colours, unseen), 1.0, Segmentation(), "here").blocked
    assert blocked[:, 70:].all()
    assert blocked[:, :70].sum() == 600


def test_separability_is_1_at_best_and_2_over_pi_for_noise():
    two = segment(aerial_of(field((10, 30, 20, 50))), 1.0, Segmentation(shade=0.0), "here")
    assert two.separability == pytest.approx(1.0, abs=1e-6)
    noise = noisy(np.full((300, 300), 128.0), 20.0, 1)
    assert segment(aerial_of(noise), 1.0, Segmentation(shade=0.0), "here").separability == pytest.approx(
        2.0 / math.pi, abs=0.01
    )


@pytest.mark.parametrize(
    ("image", "settings", "message"),
    [
        (np.zeros((20, 20)), {}, "here: it is black all over, so nothing in it is drivable"),
        (np.full((20, 20), 255), {}, "here: it has no contrast: all of it is of one brightness"),
        (np.full((20, 20), 255), {"method": "clusters", "shade": 0.0}, "no contrast"),
        (field((10, 30, 20, 50)), {"threshold": 0.9, "shade": 0.0}, "nothing in it is found to be drivable"),
    ],
)
def test_images_without_a_map(image, settings, message):
    with pytest.raises(InputError, match=message):
        found(image, **settings)


@pytest.mark.parametrize("shape", [(1, 2), (2, 1), (3, 3), (1, 90)])
def test_the_smallest_images(shape):
    image = np.full(shape, FIELD)
    image.flat[0] = ROOF
    assert found(image, smallest_obstacle=0.0, largest_hole=0.0).ravel().tolist() == [True] + [False] * (image.size - 1)


def test_overlap_is_intersection_over_union():
    left, right = np.zeros((2, 4, 4), dtype=bool)
    left[:, :2], right[:, 1:] = True, True
    assert overlap(left, right) == 4 / 16
    assert overlap(left, left) == 1.0
    assert overlap(~left, left) == 0.0
    assert overlap(left & False, left & False) == 1.0
