import numpy as np
import pytest
from PIL import Image, TiffImagePlugin

from planners.errors import InputError
from planners.scenario import load_scenario

WORDS = 'name = "here"\nimage = "ground.png"\nstart = [1.0, 1.0]\ngoal = [19.0, 9.0]\n'
SIZE = "size = [20.0, 10.0]\n"


@pytest.fixture
def load(tmp_path):
    """A scenario about a picture 20 pixels wide and 10 high: light sand, and a house of 8 x 4 in the north-west."""
    colours = np.full((10, 20, 3), (210, 190, 150), dtype=np.uint8)
    colours[1:5, 2:10] = (120, 40, 40)
    Image.fromarray(colours).save(tmp_path / "ground.png")
    tags = TiffImagePlugin.ImageFileDirectory_v2()
    tags[33550], tags.tagtype[33550] = (0.5, 0.5, 0.0), 12
    Image.fromarray(colours).save(tmp_path / "ground.tif", tiffinfo=tags)
    Image.new("L", (20, 10)).save(tmp_path / "nothing.png")

    def from_text(text):
        (tmp_path / "here.toml").write_text(text, encoding="utf-8")
        return load_scenario(tmp_path / "here.toml")

    return from_text


def house(scenario):
    return np.argwhere(scenario.map.raster.blocked).min(axis=0).tolist(), int(scenario.map.raster.blocked.sum())


@pytest.mark.parametrize(
    "table", ["[segment]", '[segment]\nmethod = "clusters"\nclusters = 2', "[segment]\nshade = 0.0"]
)
def test_a_map_is_segmented(load, table):
    scenario = load(SIZE + WORDS + table)
    assert house(scenario) == ([5, 2], 32)
    assert scenario.map.raster.cell == 1.0


def test_its_truth_is_no_map(load):
    scenario = load(SIZE + WORDS + 'truth = "nothing.png"\n[segment]')
    assert house(scenario) == ([5, 2], 32)
    assert scenario.picture is None
    assert [file.name for file in scenario.files] == ["here.toml", "ground.png", "nothing.png"]
    drawn = load(SIZE + WORDS + 'truth = "nothing.png"\n')
    assert not drawn.map.raster.blocked.any()
    assert drawn.picture is not None


def test_areas_are_in_metres_whatever_the_unit(load):
    """The house is 32 pixels large, and a pixel 4 square metres."""
    text = SIZE + WORDS + "unit = 2.0\n[segment]\nsmallest_obstacle = "
    assert house(load(text + "128.0")) == ([5, 2], 32)
    assert not load(text + "128.1").map.raster.blocked.any()


@pytest.mark.parametrize("unit", [1.0, 2.0])
def test_the_size_follows_from_the_scale(load, unit):
    scenario = load(WORDS + f"unit = {unit}\n[segment]\nscale = {unit}")
    assert scenario.size == (20.0 * unit, 10.0 * unit)
    assert scenario.map.bounds == (0.0, 0.0, *scenario.size)
    assert scenario.map.raster.cell == unit


def test_a_geotiff_tells_its_size(load):
    words = WORDS.replace("ground.png", "ground.tif").replace("[19.0, 9.0]", "[9.0, 4.0]")
    for table in ("", "[segment]"):
        scenario = load(words + table)
        assert scenario.size == (10.0, 5.0)
        assert scenario.map.raster.cell == 0.5


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (WORDS, r"here.toml: image: nothing says how many metres wide a pixel is; add size = \[width, height\]"),
        (SIZE + WORDS + "[segment]\nscale = 1.0", "here.toml: segment.scale: size is given too"),
        (SIZE + WORDS.replace("image", "truth") + "[segment]", "segment: there is no image to segment; add image"),
        ("size = [20.0, 11.0]\n" + WORDS + "[segment]", "size: .* over 20 x 10 pixels of ground.png is not square"),
        (SIZE + WORDS + 'truth = "house.png"\n[segment]', "here.toml: truth: there is no picture .*house.png"),
        (SIZE + WORDS.replace("ground", "nothing") + "[segment]", "here.toml: image: it is black all over"),
        (SIZE + WORDS.replace("[19.0, 9.0]", "[5.0, 7.0]") + "[segment]", r"goal: \[5.0, 7.0\] is .* in an obstacle"),
        (SIZE + WORDS + '[segment]\nmethod = "otso"', "segment.method: 'otso' is none of its words"),
        (SIZE + WORDS + "[segment]\nthresold = 0.5", "segment: unknown key 'thresold'; did you mean 'threshold'"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told(load, text, message):
    with pytest.raises(InputError, match=message):
        load(text)


def test_a_truth_has_the_shape_of_the_image(load, tmp_path):
    Image.new("L", (20, 20)).save(tmp_path / "square.png")
    with pytest.raises(InputError, match=r"here.toml: truth: its 20 x 20 pixels are not the 20 x 10 of the image"):
        load(SIZE + WORDS + 'truth = "square.png"\n[segment]')
