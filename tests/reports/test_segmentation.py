import io
import json

import numpy as np
import pytest
from PIL import Image
from rich.console import Console

from planners.segmentation.aerial import Aerial
from planners.segmentation.facts import facts_of
from planners.segmentation.segment import Segmented
from planners.segmentation.settings import Segmentation
from reports.figures.segmentation_figure import save_segmentation_figure, segmentation_figure
from reports.figures.style import style
from reports.terminal.segmentation_table import print_segmentation, segmentation_json


def made_up(rows=40, columns=60, cell=2.0, known=True):
    """Image, mask, facts and truth: 10 x 10 obstacle of which one column is missed, and one false pixel."""
    truth = np.zeros((rows, columns), dtype=bool)
    truth[10:20, 10:20] = True
    blocked = truth.copy()
    blocked[10:20, 10], blocked[-1, -1] = False, True
    colours = np.where(truth[..., None], 60, 200).repeat(3, axis=2).astype(np.uint8)
    found = Segmented(blocked, 0.6, 0.95)
    given = truth if known else None
    return Aerial(colours, truth & False), blocked, facts_of("yard.png", found, cell, Segmentation(), given), given


def words(figure):
    return "\n".join(text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def test_facts_are_areas_and_shares():
    _, _, facts, _ = made_up()
    assert facts.size == (120.0, 80.0)
    assert facts.drivable == 1.0 - 91 / 2400
    assert facts.iou == 90 / 101
    assert (facts.missed, facts.false) == (40.0, 4.0)


def test_the_table_and_the_object_tell_them():
    _, _, facts, _ = made_up()
    console = Console(file=io.StringIO(), width=80)
    print_segmentation(facts, console)
    lines = [" ".join(line.split()) for line in console.file.getvalue().splitlines()]
    for line in (
        "size 120 m × 80 m",
        "scale, a pixel 2 m",
        "drivable 96.2 %",
        "IoU of obstacles 0.8911",
        "obstacle missed 40 m²",
    ):
        assert line in lines
    told = json.loads(segmentation_json(facts, "mask.png", "figure.png"))
    assert told["iou"] == 90 / 101
    assert told["mask"] == "mask.png"
    assert json.loads(segmentation_json(made_up(known=False)[2], "", ""))["iou"] is None


def test_the_picture_is_the_same_bytes(tmp_path):
    aerial, blocked, facts, truth = made_up()
    for suffix in ("png", "svg"):
        first, second = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
        for file in (first, second):
            save_segmentation_figure(aerial, blocked, facts, file, truth)
        assert first.read_bytes() == second.read_bytes()
    with Image.open(tmp_path / "a.png") as image:
        assert image.width == 1600


def test_it_says_what_was_found_and_what_was_missed():
    aerial, blocked, facts, truth = made_up()
    with style():
        told = words(segmentation_figure(aerial, blocked, facts, truth))
    for part in (
        "yard.png",
        "120 m × 80 m, 2 m a pixel",
        "96.2 % drivable",
        "IoU of obstacles 0.8911",
        "missed",
        "Clearance",
    ):
        assert part in told
    aerial, blocked, facts, _ = made_up(known=False)
    with style():
        told = words(segmentation_figure(aerial, blocked, facts))
    assert "IoU" not in told
    assert "missed" not in told


@pytest.mark.parametrize(("rows", "columns"), [(40, 400), (400, 40), (30, 30)])
def test_every_shape_has_its_panels_within_the_figure(rows, columns):
    aerial, blocked, facts, truth = made_up(rows, columns)
    with style():
        figure = segmentation_figure(aerial, blocked, facts, truth)
    for axes in figure.axes:
        box = axes.get_position()
        assert 0.0 < box.x0 < box.x1 < 1.0
        assert 0.0 < box.y0 < box.y1 < 1.0


def test_no_obstacle_is_too_small_for_the_panel():
    blocked = np.zeros((1100, 2500), dtype=bool)
    blocked[1001, 1999] = True
    facts = facts_of("wide.png", Segmented(blocked, 0.5, 1.0), 1.0, Segmentation())
    colours = np.full((1100, 2500, 3), 200, dtype=np.uint8)
    with style():
        figure = segmentation_figure(Aerial(colours, blocked), blocked, facts)
    shown = figure.axes[1].images[0]
    at = np.argwhere(shown.get_array() == 1)
    assert len(at) == 1
    left, right, south, north = shown.get_extent()
    rows, columns = shown.get_array().shape
    (row, column), cell = at[0], (right - left) / columns
    assert (north - south) / rows == cell
    assert row * cell <= 1001 < (row + 1) * cell
    assert column * cell <= 1999 < (column + 1) * cell


def test_a_map_without_obstacles_has_no_clearance():
    blocked = np.zeros((20, 30), dtype=bool)
    facts = facts_of("bare.png", Segmented(blocked, 0.5, 0.0), 1.0, Segmentation())
    with style():
        figure = segmentation_figure(Aerial(np.full((20, 30, 3), 200, dtype=np.uint8), blocked), blocked, facts)
    assert "no obstacle" in words(figure)
