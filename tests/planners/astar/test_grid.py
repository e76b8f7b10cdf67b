"""A* on a grid finds the shortest of all paths through free cells."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grid_maps import EIGHT, FOUR, distances, free_cells, maze, on_cells, random_grid, rooms
from planners.all_planners import make_planner, plan_with
from planners.errors import InputError
from planners.map import Map, Raster
from planners.planner import NO_PATH, NOT_FOUND
from planners.scenario import load_scenario
from sample_maps import FREE, ONE_CIRCLE, UNIT, room, scenario, scenarios

KINDS = [("astar-four", {}), ("astar-eight", {}), ("astar-eight", {"cut_corners": True})]
GRIDS = {
    "empty": lambda rng: np.zeros((23, 31), dtype=bool),
    "a tenth": lambda rng: random_grid(rng, 60, 40, 0.1),
    "a quarter": lambda rng: random_grid(rng, 60, 40, 0.25),
    "two fifths": lambda rng: random_grid(rng, 40, 60, 0.4),
    "rooms": lambda rng: rooms(rng, 5, 7),
    "maze": lambda rng: maze(rng, 20),
}


def length_of(found, name, **more):
    """The length of the planned path [m]; inf for none."""
    plan = plan_with(make_planner(name, more), found, 0)
    assert bool(plan.paths) != (plan.outcome == NO_PATH)
    return plan.paths[0].length if plan.paths else math.inf


@pytest.mark.parametrize("grid", GRIDS)
@pytest.mark.parametrize(("name", "more"), KINDS)
def test_no_path_through_free_cells_is_shorter(name, more, grid):
    rng = np.random.default_rng(11)
    for _ in range(5):
        blocked = GRIDS[grid](rng)
        start, *goals = free_cells(rng, blocked, 11)
        known = distances(blocked, start, FOUR if name == "astar-four" else EIGHT, more.get("cut_corners", False))
        for goal in goals:
            assert length_of(on_cells(blocked, start, goal), name, **more) == pytest.approx(known[goal], abs=1e-9)


@settings(max_examples=60)
@given(seed=st.integers(0, 2**32), density=st.floats(0.0, 0.5), sides=st.tuples(st.integers(1, 20), st.integers(2, 20)))
def test_any_grid_with_any_way_of_stepping(seed, density, sides):
    rng = np.random.default_rng(seed)
    blocked = random_grid(rng, *sides, density)
    blocked[0, :2] = False
    start, goal = free_cells(rng, blocked, 2)
    for name, more in KINDS:
        cutting = more.get("cut_corners", False)
        known = distances(blocked, start, FOUR if name == "astar-four" else EIGHT, cutting)[goal]
        assert length_of(on_cells(blocked, start, goal), name, **more) == pytest.approx(known, abs=1e-9)


def test_a_corner_is_cut_only_where_that_is_allowed():
    blocked = np.array([[0, 1, 1], [1, 0, 0], [1, 0, 0]], dtype=bool)
    assert length_of(on_cells(blocked, (0, 0), (1, 1)), "astar-eight") == math.inf
    assert length_of(on_cells(blocked, (0, 0), (1, 1)), "astar-eight", cut_corners=True) == math.sqrt(2.0)
    blocked[0, 1] = False
    assert length_of(on_cells(blocked, (0, 0), (1, 1)), "astar-eight") == 2.0


def test_points_are_the_corners_alone():
    blocked = np.zeros((9, 9), dtype=bool)
    blocked[:8, 4] = True
    path = plan_with(make_planner("astar-four"), on_cells(blocked, (0, 0), (0, 8)), 0).paths[0]
    assert path.length == 24.0
    assert np.degrees(np.abs(path.turns[1:-1])) == pytest.approx(90.0)


@pytest.mark.parametrize(("name", "more"), KINDS)
@settings(max_examples=60)
@given(found=scenarios)
def test_legs_keep_to_the_grids_directions_and_never_turn_back(name, more, found):
    try:
        plan = plan_with(make_planner(name, {"cells": 40, **more}), found, 0)
    except InputError:
        return
    if not plan.paths or plan.notes:
        return  # no path, or an end in a blocked cell, from which the first leg is as it must be
    path = plan.paths[0]
    assert room(found, path) >= -1e-9
    assert np.abs(path.turns).max() <= math.pi / 2 + 1e-9
    step = math.pi / (2 if name == "astar-four" else 4)
    assert path.headings / step == pytest.approx(np.round(path.headings / step), abs=1e-6)


def test_in_one_cell_the_path_is_straight():
    found = scenario(start=(10.0, 10.0), goal=(12.0, 13.0))
    path = plan_with(make_planner("astar-four", {"cell": 20.0}), found, 0).paths[0]
    assert len(path.points) == 2
    assert path.length == pytest.approx(math.hypot(2.0, 3.0) * UNIT)


def test_on_free_ground_ways_have_manhattans_and_the_octile_length():
    dx, dy = 110.0, 30.0
    found = scenario(start=(5.5, 40.5), goal=(115.5, 70.5))
    assert length_of(found, "astar-four", cell=1.0) == pytest.approx((dx + dy) * UNIT)
    assert length_of(found, "astar-eight", cell=1.0) == pytest.approx((dx - dy + math.sqrt(2.0) * dy) * UNIT)


def test_a_start_in_a_blocked_cell_leaves_it_for_the_nearest_free_one():
    found = scenario(circles=[(11.0, 45.0, 2.0)], start=(8.6, 45.0))
    plan = plan_with(make_planner("astar-eight", {"cell": 5.0}), found, 0)
    assert plan.notes == ("the cell of the start is blocked: the path is bound to the one beside it",)
    assert plan.paths[0].xy[:2] / UNIT == pytest.approx(np.array([[8.6, 45.0], [7.5, 47.5]]), abs=5.1)
    assert room(found, plan.paths[0]) > 0.0


def test_a_start_whose_cell_nothing_leads_out_of_is_bad_input():
    ring = [(4.0, 36.0), (16.0, 36.0), (16.0, 44.0), (4.0, 44.0), (4.0, 40.5), (4.2, 40.5), (4.2, 43.8), (15.8, 43.8)]
    ring += [(15.8, 36.2), (4.2, 36.2), (4.2, 39.5), (4.0, 39.5)]
    found = scenario(polygons=[ring], start=(12.5, 38.0))
    with pytest.raises(InputError, match="sample: start: its cell of 200 m is blocked"):
        plan_with(make_planner("astar-eight", {"cell": 10.0}), found, 0)


def test_a_clearance_narrows_gaps():
    found = scenario(circles=[(60.0, 30.0, 25.0), (60.0, 86.0, 25.0)])  # a gap of 6
    near, far = (length_of(found, "astar-eight", cell=0.5, clearance=c * UNIT) for c in (2.0, 4.0))
    assert near < far


def test_beyond_the_range_nothing_is_found():
    plan = plan_with(make_planner("astar-four"), dataclasses.replace(FREE, max_range=100.0), 0)
    assert plan.outcome == NOT_FOUND
    assert "the range is 100 m" in plan.reason


def test_cells_are_the_rasters_own_unless_said_otherwise():
    raster = dataclasses.replace(FREE, map=Map(raster=Raster(np.zeros((8, 12), dtype=bool), 200.0)))
    for found, more, cell in (
        (raster, {}, 200.0),
        (FREE, {}, FREE.size[0] / 512),
        (FREE, {"cell": 3.0}, 3.0 * UNIT),
        (raster, {"cells": 30}, FREE.size[0] / 30),
    ):
        assert make_planner("astar-eight", more).cell_on(found) == pytest.approx(cell)


def test_cell_and_cells_together_are_bad_input():
    with pytest.raises(InputError, match="planner astar-four: cell and cells say the same thing"):
        make_planner("astar-four", {"cell": 1.0, "cells": 30})


def test_a_grid_beyond_all_memory_is_bad_input():
    with pytest.raises(InputError, match="give larger cells"):
        plan_with(make_planner("astar-eight", {"cell": 1e-4}), FREE, 0)


def test_equal_lengths_are_the_same_path_on_every_run():
    one, two = (plan_with(make_planner("astar-eight"), ONE_CIRCLE, seed).paths[0] for seed in (1, 2))
    assert one.points.tobytes() == two.points.tobytes()


# Ours, measured: the paper's map is not published; on its own it has 180 m in four directions, on 71.25 m.
@pytest.mark.parametrize(("name", "more", "length", "turn"), [
    ("astar-four", {}, 124.01, 90.0), ("astar-eight", {}, 96.19, 90.0), ("astar-four", {"cells": 30}, 127.25, 90.0),
])  # fmt: skip
def test_the_target_vehicles_map(name, more, length, turn):
    path = plan_with(make_planner(name, more), load_scenario("target-vehicle-71m"), 0).paths[0]
    assert path.length == pytest.approx(length, abs=0.005)
    assert math.degrees(np.abs(path.turns).max()) == pytest.approx(turn)
