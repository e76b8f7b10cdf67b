import math

import numpy as np
import pyproj
import pytest
from PIL import Image, TiffImagePlugin

from planners.errors import InputError
from planners.segmentation.aerial import geotiff_scale, read_aerial

PROJECTED, GEOGRAPHIC = (1024, 1), (1024, 2)


@pytest.fixture
def geotiff(tmp_path):
    """A GeoTIFF 100 x 60 pixels large, with that scale, keys and place of its upper left corner."""

    def write(width, height, *keys, corner=None):
        tags = TiffImagePlugin.ImageFileDirectory_v2()
        tags[33550], tags.tagtype[33550] = (width, height, 0.0), 12
        tags[34735] = (1, 1, 0, len(keys), *(word for key, value in keys for word in (key, 0, 1, value)))
        tags.tagtype[34735] = 3
        if corner:
            tags[33922], tags.tagtype[33922] = (0.0, 0.0, 0.0, *corner, 0.0), 12
        file = tmp_path / "ground.tif"
        Image.new("RGB", (100, 60), "white").save(file, tiffinfo=tags)
        return geotiff_scale(file, "here", "give it")

    return write


def test_the_first_row_is_the_north_and_transparent_is_unseen(tmp_path):
    values = np.zeros((2, 3, 4), dtype=np.uint8)
    values[..., 3] = 255
    values[0, 0] = (10, 20, 30, 255)
    values[1, 2, 3] = 0
    Image.fromarray(values).save(tmp_path / "a.png")
    aerial = read_aerial(tmp_path / "a.png", "here")
    assert aerial.colours[1, 0].tolist() == [10, 20, 30]
    assert np.argwhere(aerial.unseen).tolist() == [[0, 2]]


@pytest.mark.parametrize("suffix", ["png", "jpg", "tif"])
def test_png_jpeg_and_tiff_are_read(tmp_path, suffix):
    Image.new("L", (4, 2), 100).save(tmp_path / f"a.{suffix}")
    aerial = read_aerial(tmp_path / f"a.{suffix}", "here")
    assert aerial.colours.shape == (2, 4, 3)
    assert (aerial.colours == 100).all()
    assert not aerial.unseen.any()


def test_sixteen_bits_are_refused(tmp_path):
    Image.fromarray(np.full((4, 4), 40_000, dtype=np.uint16)).save(tmp_path / "deep.png")
    with pytest.raises(InputError, match=r"here: its pixels are .*I;16, not of 8 bits a channel; convert it"):
        read_aerial(tmp_path / "deep.png", "here")


def test_a_scale_without_a_projection_is_in_metres(geotiff):
    assert geotiff(0.25, 0.25, PROJECTED) == 0.25


def test_feet(geotiff):
    assert geotiff(10.0, 10.0, PROJECTED, (3076, 9002)) == pytest.approx(3.048)
    assert geotiff(3937.0, 3937.0, PROJECTED, (3072, 2263)) == pytest.approx(1200.0)  # EPSG: New York, US survey feet


def test_utm_stretches_by_0_9996_on_its_meridian(geotiff):
    assert geotiff(1.0, 1.0, PROJECTED, (3072, 32632), corner=(499_950.0, 5_300_000.0)) == pytest.approx(1 / 0.9996)


def test_web_mercator_stretches_twice_at_60_degrees(geotiff):
    north = 6_378_137.0 * math.log(math.tan(math.radians(75.0)))
    scale = geotiff(2.0, 2.0, PROJECTED, (3072, 3857), corner=(0.0, north))
    project = pyproj.Proj("EPSG:3857")
    ends = [project(0.0, y, inverse=True) for y in (north - 60.0, north - 62.0)]
    assert scale == pytest.approx(pyproj.Geod(ellps="WGS84").inv(*ends[0], *ends[1])[2], rel=1e-3)
    assert scale == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize(
    ("width", "height", "keys", "message"),
    [
        (1e-5, 1e-5, [GEOGRAPHIC], "here: its scale is in degrees; reproject it to metres, .*; or give it"),
        (1.0, 1.1, [PROJECTED], "its pixels are 1.0 x 1.1, not square"),
        (0.0, 0.0, [PROJECTED], "its ModelPixelScaleTag says 0.0 x 0.0; give it"),
        (1.0, 1.0, [PROJECTED, (3072, 12345)], "its projection EPSG:12345 is not known; give it"),
        (1.0, 1.0, [PROJECTED, (3076, 9999)], "its scale is in the unit EPSG:9999, which is not known here; give it"),
    ],
)
def test_scales_that_tell_no_metres(geotiff, width, height, keys, message):
    with pytest.raises(InputError, match=message):
        geotiff(width, height, *keys)


def test_a_picture_without_a_scale(tmp_path):
    for name in ("a.png", "a.tif"):
        Image.new("L", (4, 4)).save(tmp_path / name)
        with pytest.raises(InputError, match="here: nothing says how many metres wide a pixel is; give it"):
            geotiff_scale(tmp_path / name, "here", "give it")
