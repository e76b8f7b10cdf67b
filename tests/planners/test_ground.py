import math
from dataclasses import replace

import numpy as np
import pytest

from planners.errors import InputError
from planners.ground import cell_for_cover, cover_ratio, ground_of
from planners.map import Circle, Map
from sample_maps import FREE, GATE, UNIT, WALLED, box, scenario


def test_places_and_lengths_in_cells():
    ground = ground_of(FREE, "test", 2.0 * UNIT, 0.0)
    assert ground.blocked.shape == (40, 60)
    assert ground.start.tolist() == [2.5, 20.0]
    assert ground.to_metres(np.array([[2.5, 20.0]])).tolist() == [[100.0, 800.0]]


def test_a_place_on_the_upper_edge_belongs_to_the_last_cell():
    ground = ground_of(scenario(goal=(120.0, 80.0)), "test", UNIT, 0.0)
    assert [int(value) for value in ground.goal] == [119, 79]


def test_a_flood_fill_tells_whether_the_goal_can_be_reached():
    assert ground_of(GATE, "test", UNIT, 0.0).connected
    assert not ground_of(WALLED, "test", UNIT, 0.0).connected
    narrow = replace(GATE, starts=np.array([[400.0, 800.0]]), goals=np.array([[2000.0, 800.0]]))
    assert ground_of(narrow, "test", UNIT, 4.0 * UNIT).connected
    assert not ground_of(narrow, "test", UNIT, 6.5 * UNIT).connected  # the gate is 12 wide


def test_clearance_blocks_what_is_nearer():
    found = scenario(circles=[(60.0, 40.0, 10.0)], start=(20.0, 40.0), goal=(100.0, 40.0))
    rows, columns = np.nonzero(ground_of(found, "test", UNIT, 5.0 * UNIT).blocked)
    inner = (columns >= 5) & (columns < 115) & (rows >= 5) & (rows < 75)  # the rest is the edge's
    apart = np.hypot(columns[inner] + 0.5 - 60.0, rows[inner] + 0.5 - 40.0)
    assert apart.max() <= 15.0 + math.sqrt(0.5)
    assert (apart <= 14.0).sum() > 500


def test_the_cover_ratio_of_what_is_made_of_cells_is_one():
    assert cover_ratio(Map(polygons=(np.array(box(2.0, 4.0, 6.0, 8.0)),)), 2.0) == pytest.approx(1.0)


def test_the_worst_obstacle_counts():
    square, circle = np.array(box(2.0, 4.0, 6.0, 8.0)), Circle(20.0, 20.0, 3.0)
    assert cover_ratio(Map(polygons=(square,), circles=(circle,)), 2.0) == cover_ratio(Map(circles=(circle,)), 2.0)


def test_smaller_cells_cover_better():
    area = Map(circles=(Circle(20.3, 20.1, 8.0),))
    coarse, fine = cover_ratio(area, 2.0), cover_ratio(area, 0.25)
    assert coarse < fine < 1.0
    assert cell_for_cover(area, (coarse + fine) / 2.0, 2.0) in (1.0, 0.5, 0.25)
    assert cover_ratio(area, cell_for_cover(area, 0.9, 2.0)) > 0.9


def test_a_ratio_beyond_any_grid_is_bad_input():
    with pytest.raises(InputError, match="give a smaller ratio"):
        cell_for_cover(Map(circles=(Circle(2.0, 2.0, 1.0),)), 1.0, 0.1)
