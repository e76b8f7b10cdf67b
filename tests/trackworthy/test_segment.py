import json
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from planners.picture import read_blocked

YARD = """name = "yard"
image = "yard.png"
size = [120.0, 80.0]
start = [10.0, 10.0]
goal = [110.0, 70.0]
"""


@pytest.fixture(autouse=True)
def yard(tmp_path, monkeypatch):
    """Light sand with a dark house of 200 pixels, and the mask of it; 60 x 40 pixels."""
    monkeypatch.chdir(tmp_path)
    colours = np.full((40, 60, 3), (210, 190, 150), dtype=np.uint8)
    colours[10:20, 10:30] = (120, 40, 40)
    Image.fromarray(colours).save("yard.png")
    Image.fromarray(colours[..., 1] < 100).save("house.png")
    (tmp_path / "yard.toml").write_text(YARD + "[segment]\n")


def test_an_image_becomes_a_map_and_a_picture(run, tmp_path):
    code, out, err = run("segment", "yard.png", "--size", "120x80", "--truth", "house.png")
    assert code == 0
    lines = [" ".join(line.split()) for line in out.splitlines()]
    for line in (
        "yard.png",
        "pixels 60 × 40",
        "scale, a pixel 2 m",
        "drivable 91.7 %",
        "IoU of obstacles 1",
        "obstacle missed 0 m²",
    ):
        assert line in lines
    assert err.splitlines() == ["saved yard-mask.png", "saved yard-segmented.png"]
    assert read_blocked(tmp_path / "yard-mask.png", white_is_obstacle=False, place="mask").sum() == 200
    assert (tmp_path / "yard-segmented.png").read_bytes().startswith(b"\x89PNG")


def test_its_map_can_be_planned_on(run, tmp_path):
    assert run("segment", "yard.png", "--scale", "2", "-o", "map.png")[0] == 0
    (tmp_path / "drawn.toml").write_text(YARD.replace("yard.png", "map.png"))
    plans = [run("plan", name, "--planner", "exact", "--json") for name in ("drawn.toml", "yard.toml")]
    assert [code for code, _, _ in plans] == [0, 0]
    lengths = [json.loads(out)["length"] for _, out, _ in plans]
    assert lengths[0] == lengths[1]


def test_json_is_one_object(run):
    code, out, _ = run(
        "segment",
        "yard.png",
        "--scale",
        "2",
        "--method",
        "clusters",
        "--clusters",
        "2",
        "-o",
        "a.png",
        "--figure",
        "b.svg",
        "--json",
    )
    told = json.loads(out)
    assert code == 0
    assert (told["size"], told["pixels"], told["cell"]) == ([120.0, 80.0], [60, 40], 2.0)
    assert (told["method"], told["iou"]) == ("clusters", None)
    assert (told["mask"], told["figure"]) == ("a.png", "b.svg")
    assert told["drivable"] == pytest.approx(1 - 200 / 2400)


def test_a_scenario_tells_how_and_options_overrule_it(run, tmp_path):
    (tmp_path / "yard.toml").write_text(YARD + 'truth = "house.png"\n[segment]\nsmallest_obstacle = 801.0\n')
    code, out, _ = run("segment", "yard.toml", "--json")
    assert (code, json.loads(out)["iou"], json.loads(out)["cell"]) == (0, 0.0, 2.0)
    code, out, _ = run("segment", "yard.toml", "--smallest-obstacle", "800", "--json")
    assert (code, json.loads(out)["iou"]) == (0, 1.0)


def test_the_built_in_aerial_image(run):
    code, out, _ = run("segment", "target-vehicle-640m", "--json")
    assert code == 0
    assert json.loads(out)["size"] == [640.0, 640.0]
    assert json.loads(out)["iou"] >= 0.98


def test_noise_is_told_to_be_no_map(run):
    noise = np.random.default_rng(0).normal(128.0, 10.0, (60, 60)).round().astype(np.uint8)
    Image.fromarray(noise).save("noise.png")
    code, _, err = run("segment", "noise.png", "--scale", "1")
    assert code == 0
    assert err.startswith(
        "noise.png: two kinds of ground hardly stand apart, see separability; look at noise-segmented.png"
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("none.png", "--scale", "1"), "none.png: there is no such picture; check the path"),
        (("yard.toml", "--scale", "0"), "--scale: 0.0 metres a pixel is not possible"),
        (("yard.png",), "yard.png: nothing says how many metres wide a pixel is; give --scale or --size"),
        (("yard.png", "--size", "120"), "--size: '120' is no width and height; give metres, as 640x480"),
        (("yard.png", "--size", "0x2"), "--size: '0x2' is no width and height"),
        (("yard.png", "--size", "120x90"), "--size: 120.0 x 90.0 over 60 x 40 pixels of yard.png is not square"),
        (("yard.png", "--scale", "1", "--size", "1x1"), "not allowed with argument"),
        (("yard.png", "--scale", "1", "--threshold", "2"), "options: threshold: expected float < 1.0"),
        (("yard.png", "--scale", "1", "--truth", "small.png"), "its 3 x 3 pixels are not the 60 x 40 of the image"),
        (("yard.png", "--scale", "1", "-o", "yard.png"), "yard.png: it would overwrite what is read"),
        (("yard.png", "--scale", "1", "-o", "mask.jpg"), "mask.jpg: a mask is a .png file"),
        (("yard.png", "--scale", "1", "-o", "a.png", "--figure", "a.png"), "a.png: mask and figure cannot be one file"),
        (("yard.png", "--scale", "1", "--figure", "no/a.png"), "no/a.png: the folder no does not exist"),
        (("small.png", "--scale", "1"), "small.png: it is black all over"),
        (("nofly-1000x660",), "it has no image to segment"),
        (("text.png", "--scale", "1"), "text.png: it cannot be read as a picture"),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(run, tmp_path, arguments, message):
    Image.new("L", (3, 3)).save("small.png")
    (tmp_path / "text.png").write_text("text")
    before = sorted(tmp_path.iterdir())
    code, out, err = run("segment", *arguments)
    assert (code, out) == (2, "")
    assert len(err.splitlines()) == 1
    assert message in err
    assert sorted(tmp_path.iterdir()) == before


def test_who_segments_nothing_does_not_wait_for_scikit_image():
    code = """import sys
from planners.scenario import load_scenario
from trackworthy.__main__ import parser
parser(), load_scenario("target-vehicle-640m")
print("skimage" in sys.modules)"""
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout == "False\n"
