from __future__ import annotations

import math

import numpy as np
import pytest
from PIL import Image

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.map import Circle
from planners.scenario import BUILT_IN_SCENARIOS, load_scenario

GOOD = """
name = "here"
size = [10.0, 8.0]
unit = 2.0
start = [1.0, 1.0]
goal = [9.0, 7.0]
[[obstacle]]
circle = { center = [5.0, 4.0], radius = 1.0 }
[[obstacle]]
polygon = [[2.0, 5.0], [4.0, 5.0], [3.0, 7.0]]
"""


@pytest.fixture
def load(tmp_path):
    def from_text(text):
        file = tmp_path / "here.toml"
        file.write_text(text, encoding="utf-8")
        return load_scenario(file)

    return from_text


@pytest.fixture
def picture(tmp_path):
    """Two cells high, four wide; black only in the north-west."""
    light = np.full((2, 4), 255, dtype=np.uint8)
    light[0, 0] = 0
    Image.fromarray(light).save(tmp_path / "ground.png")
    return 'name = "p"\nsize = [8.0, 4.0]\nstart = [1.0, 1.0]\ngoal = [7.0, 3.0]\n'


@pytest.mark.parametrize("name", BUILT_IN_SCENARIOS)
def test_every_built_in_scenario_can_be_planned(name):
    scenario = load_scenario(name)
    assert scenario.name == name
    assert all(file.is_file() for file in scenario.files)
    for points in (scenario.starts, scenario.goals):
        poses = np.column_stack([points, np.zeros(len(points))])
        assert (clearance(scenario.map, poses, Disc(0.0)) > 0.0).all()


@pytest.mark.parametrize(("count", "shortest"), [(15, 687.172), (25, 690.865)])
def test_the_mars_hazards_of_paper_001(count, shortest):
    scenario = load_scenario(f"mars-hazards-{count}")
    assert len(scenario.map.circles) == count
    assert {circle.radius for circle in scenario.map.circles} == {10.0 * 250.0}
    assert scenario.size == (75e3, 75e3)
    assert scenario.max_range == 424.0 * 250.0
    assert scenario.max_turn_angle == pytest.approx(math.pi / 4.0)
    assert scenario.starts.tolist() == [[8750.0, 2500.0], [62500.0, 2500.0], [5000.0, 32500.0]]
    # The file quotes the sum of straight lines under the best assignment; no plan can be shorter.
    apart = np.linalg.norm(scenario.starts[:, None] - scenario.goals[None], axis=2) / scenario.unit
    best = min(
        apart[0, i] + apart[1, j] + apart[2, k]
        for i, j, k in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0))
    )
    assert best == pytest.approx(682.579, abs=0.0005)
    assert best < shortest


def test_the_no_fly_map_of_paper_000():
    scenario = load_scenario("nofly-1000x660")
    assert scenario.map.bounds == (0.0, 0.0, 20e3, 13.2e3)
    assert (len(scenario.map.polygons), len(scenario.map.circles)) == (5, 4)
    assert np.linalg.norm(scenario.goals - scenario.starts) / scenario.unit == pytest.approx(1104.54, abs=0.005)
    assert scenario.map.circles[0] == Circle(3600.0, 8400.0, 1400.0)


def test_the_ground_of_paper_004():
    near, far = load_scenario("target-vehicle-71m"), load_scenario("target-vehicle-640m")
    assert (near.map.edge, far.map.edge) == ("open", "closed")
    assert near.map.raster.blocked.shape == far.map.raster.blocked.shape == (512, 512)
    assert near.map.raster.cell * 512 == 71.25
    assert far.map.raster.cell == 1.25
    assert near.picture is None
    assert far.picture is not None
    assert far.picture.name == "aerial_640m.png"


def test_units_become_metres(load):
    scenario = load(GOOD)
    assert scenario.map.circles == (Circle(10.0, 8.0, 2.0),)
    assert scenario.map.polygons[0].tolist() == [[4.0, 10.0], [8.0, 10.0], [6.0, 14.0]]
    assert scenario.goals.tolist() == [[18.0, 14.0]]
    assert scenario.map.bounds == (0.0, 0.0, 20.0, 16.0)
    assert scenario.map.frame is None
    assert scenario.max_range is None


def test_an_origin_gives_a_frame(load):
    frame = load("origin = [47.0, 8.5]\n" + GOOD).map.frame
    assert (frame.lat, frame.lon) == (47.0, 8.5)


def test_areas_to_stay_in(load):
    scenario = load(GOOD + "[[keep_in]]\ncircle = { center = [5.0, 4.0], radius = 6.0 }\n")
    assert scenario.map.keep_in_circles == (Circle(10.0, 8.0, 12.0),)


def test_the_first_row_of_a_picture_is_the_north(load, picture):
    raster = load(picture + 'image = "ground.png"\n').map.raster
    assert raster.cell == 2.0
    assert np.argwhere(raster.blocked).tolist() == [[1, 0]]


def test_in_a_truth_white_is_obstacle(load, picture):
    with pytest.raises(InputError, match=r"start: \[1.0, 1.0\] is 1 map units deep in an obstacle"):
        load(picture + 'image = "ground.png"\ntruth = "ground.png"\n')


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("unit", "unti", r"here.toml: unknown key 'unti'; did you mean 'unit'\?"),
        (
            "radius",
            "radios",
            r"here.toml: obstacle\[0\].circle: unknown key 'radios'; did you mean 'radius'\?",
        ),
        ("polygon", "polygons", r"obstacle\[1\]: unknown key 'polygons'; did you mean 'polygon'\?"),
        ("size = [10.0, 8.0]", "", "here.toml: 'size' is missing; add size = "),
        ("[10.0, 8.0]", '[10.0, "8"]', r"here.toml: size\[1\]: expected float, got str"),
        ("[10.0, 8.0]", "[10.0, inf]", r"size\[1\]: expected float <= "),
        ("unit = 2.0", "unit = 0.0", "unit: expected float > 0"),
        ("unit = 2.0", "unit = nan", "unit"),
        ("unit = 2.0", "unit = ", "here.toml: it is not TOML: .*line 4"),
        ("[1.0, 1.0]", "[5.0, 4.5]", r"start: \[5.0, 4.5\] is 0.5 map units deep in an obstacle.*; move it"),
        ("[9.0, 7.0]", "[3.0, 6.0]", "goal: .* in an obstacle"),
        ("[9.0, 7.0]", "[11.0, 7.0]", r"goal: \[11.0, 7.0\] is off the map; keep it within \[10.0, 8.0\]"),
        ("[9.0, 7.0]", "[nan, 7.0]", "goal: .* off the map"),
        ("goal = [9.0, 7.0]", "", r"here.toml: goal is missing; add goal = \[x, y\] or targets"),
        ("goal = [9.0, 7.0]", "targets = []", "goal is missing"),
        ("goal =", "targets = [[1.0, 1.0]]\ngoal =", "goal: targets is given too"),
        ("goal = [9.0, 7.0]", "targets = [[9.0, 7.0], [5.0, 4.0]]", r"targets\[1\]: .* in an obstacle"),
        ("radius = 1.0", "radius = -1.0", r"obstacle\[0\].circle: its radius is -2"),
        ("[4.0, 5.0], [3.0, 7.0]", "[4.0, 5.0]", r"obstacle\[1\].polygon: .* at least three"),
        ("[3.0, 7.0]]", "[3.0, 7.0], [3.0, 4.0]]", r"obstacle\[1\].polygon: its edges cross"),
        ("[3.0, 7.0]]", "[3.0]]", r"obstacle\[1\].polygon: every vertex must be \[x, y\]"),
        (
            "[[obstacle]]\ncircle",
            "[[obstacle]]\n[[obstacle]]\ncircle",
            r"obstacle\[0\]: .* a polygon or a circle",
        ),
        ("unit", "origin = [91.0, 0.0]\nunit", r"origin: \[91.0, 0.0\] is no place"),
        ("unit", 'edge = "ajar"\nunit', "edge: .*ajar"),
        ("unit", 'image = "none.png"\nunit', "here.toml: image: there is no picture .*none.png"),
        ("unit", 'image = "here.toml"\nunit', "image: .* cannot be read as a picture"),
    ],
)
def test_an_error_names_file_key_and_remedy(load, old, new, message):
    assert old in GOOD
    with pytest.raises(InputError, match=message) as caught:
        load(GOOD.replace(old, new, 1))
    assert "\n" not in str(caught.value)
    assert "here.toml" in str(caught.value)


def test_a_picture_needs_free_ground_and_square_cells(load, picture, tmp_path):
    with pytest.raises(InputError, match=r"size: .* not square; 9.0 wide it is 4.5 high"):
        load(picture.replace("8.0", "9.0") + 'image = "ground.png"\n')
    Image.new("L", (4, 2)).save(tmp_path / "ground.png")
    with pytest.raises(InputError, match=r"image: .* is all obstacle; draw drivable ground in white"):
        load(picture + 'image = "ground.png"\n')


def test_an_aerial_picture_must_be_there_though_its_truth_is(load, picture, tmp_path):
    Image.new("L", (4, 2)).save(tmp_path / "truth.png")
    with pytest.raises(InputError, match=r"image: there is no .*sky.png"):
        load(picture + 'image = "sky.png"\ntruth = "truth.png"\n')


def test_unknown_names_and_missing_files(tmp_path):
    with pytest.raises(InputError, match=r"there is no such scenario; did you mean 'mars-hazards-15'\?"):
        load_scenario("mars-hazard-15")
    with pytest.raises(InputError, match=r"nowhere.toml: there is no such file"):
        load_scenario(tmp_path / "nowhere.toml")
    with pytest.raises(InputError, match="cannot be read"):
        load_scenario(tmp_path)
