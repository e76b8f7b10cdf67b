import dataclasses
import math

import numpy as np
import pytest

from planners.all_planners import make_planner, plan_with
from planners.astar.arc_printed import descent_of
from planners.astar.heading_limits import paper_heading_limit
from planners.errors import InputError
from planners.exact import Exact
from planners.facts import facts_of
from planners.planner import NOT_FOUND
from planners.scenario import load_scenario
from sample_maps import box, room, scenario

SPEEDS = (30.0, 45.0, 60.0)  # [km/h]
PIXEL = 120.0 / 512  # [m] by default, on a map of 120 x 80 m
DIAGONAL = PIXEL * math.sqrt(2.0)
WALL = scenario(polygons=[box(55.0, 20.0, 4.0, 40.0)], unit=1.0)  # round which it is 20 m either way


def planner(kmh, **settings):
    return make_planner("astar-arc-paper", {"speed": f"{kmh:g}km/h", **settings})


def centre(column, row):
    return (column + 0.5) * PIXEL, (row + 0.5) * PIXEL


@pytest.mark.parametrize("kmh", SPEEDS)
@pytest.mark.parametrize("way", [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)])
def test_where_nothing_stands_the_path_is_straight(kmh, way):
    start, goal = centre(250, 170), centre(250 + 150 * way[0], 170 + 150 * way[1])
    path = plan_with(planner(kmh), scenario(start=start, goal=goal, unit=1.0), 0).paths[0]
    assert path.length == pytest.approx(math.dist(start, goal), rel=1e-12)
    assert np.abs(path.turns).max(initial=0.0) == pytest.approx(0.0, abs=1e-9)


def test_of_directions_that_share_a_pixel_the_one_that_turns_least_counts():
    """In pixels of 2 m, several children of 4.17 m lie in the one straight ahead."""
    found = descent_of(scenario(start=(11.0, 41.0), goal=(111.0, 41.0), unit=1.0), planner(30.0, cell=2.0))
    assert (found.headings == 0).all()


def strewn(seed):
    """Six posts of 0.6 m between start and goal, 10 m apart at least."""
    rng = np.random.default_rng(seed)
    posts = [(15.0 + 15.0 * i + 5.0 * rng.random(), 40.0 + 4.0 * rng.standard_normal(), 0.3) for i in range(6)]
    return scenario(circles=posts, goal=(115.0, rng.uniform(10.0, 70.0)), unit=1.0)


@pytest.mark.parametrize("kmh", SPEEDS)
def test_steps_and_turns_are_the_papers_and_what_pixels_add(kmh):
    """The end of a step lies within half a pixel's diagonal of where it should: that much longer or shorter is a leg,
    and its direction off by asin(half a diagonal / step). The goal may lie anywhere in the last pixel.
    """
    step, limit = kmh / 3.6 * 0.5, paper_heading_limit(kmh / 3.6)
    off = math.asin(DIAGONAL / 2.0 / step)
    found = [plan_with(planner(kmh), strewn(seed), 0) for seed in range(20)]
    paths = [plan.paths[0] for plan in found if plan.paths]
    assert len(paths) >= 10
    for path in paths:
        legs = np.hypot(*np.diff(path.xy, axis=0).T)
        assert np.abs(legs[:-1] - step).max() <= DIAGONAL / 2.0
        assert legs[-1] <= step + DIAGONAL
        assert np.abs(path.turns[:-2]).max() <= limit + 2.0 * off
        assert abs(path.turns[-2]) <= limit + off + math.asin(DIAGONAL / step)


def test_posts_are_passed_and_not_touched():
    """One of 2 m stands in the straight way."""
    post = scenario(circles=[(60.0, 40.1, 1.0)], unit=1.0)
    path = plan_with(planner(30.0), post, 0).paths[0]
    assert 0.0 <= room(post, path) < 1.0
    assert path.length > 110.0


@pytest.mark.parametrize("kmh", SPEEDS)
def test_a_wall_is_a_trap_where_another_way_is_free(kmh):
    plan = plan_with(planner(kmh), WALL, 0)
    found, step = descent_of(WALL, planner(kmh)), kmh / 3.6 * 0.5
    last = found.ground.to_metres(found.nodes)[-1]
    assert 55.0 - step - DIAGONAL <= last[0] < 55.0
    assert plan.outcome == NOT_FOUND
    assert (
        f"at ({last[0]:.1f}, {last[1]:.1f}) m, after {len(found.nodes) - 1} steps, no node {step:.3g} m on"
        in plan.reason
    )
    assert "greedy descent cannot go back" in plan.reason
    (stage,) = plan.stages
    assert (stage.name, len(stage.paths)) == ("as far as it came", 1)
    assert (stage.paths[0].xy[0] == WALL.starts[0]).all()
    assert stage.paths[0].xy[1:] == pytest.approx(found.ground.to_metres(found.nodes)[1:])
    told = facts_of(plan, planner(kmh), WALL, 0)
    assert (told.stages, told.lengths, told.length) == ((), (), None)
    assert Exact().plan(WALL, np.random.default_rng(0)).paths


def test_a_start_without_a_free_direction_says_so():
    """A closet with a door, and a screen before it: it leads out, but not within 4.17 m in a straight line."""
    walls = [box(57.5, 42.0, 5.0, 0.5), box(57.5, 37.5, 5.0, 0.5), box(57.5, 37.5, 0.5, 5.0),
             box(62.0, 37.5, 0.5, 1.5), box(62.0, 41.0, 0.5, 1.5), box(63.0, 37.5, 0.5, 5.0)]  # fmt: skip
    plan = plan_with(planner(30.0), scenario(polygons=walls, start=(60.0, 40.0), unit=1.0), 0)
    assert "after 0 steps, no node 4.17 m on and on the whole circle about it" in plan.reason
    assert plan.stages == ()


def test_one_step_is_one_step():
    """9 m before a wall, of which the step takes 8.33 m."""
    plan = plan_with(planner(60.0), scenario(polygons=[box(55.0, 20.0, 4.0, 40.0)], start=(46.0, 40.0), unit=1.0), 0)
    assert "after 1 step, no node 8.33 m on" in plan.reason
    assert len(plan.stages[0].paths[0].xy) == 2


def test_a_goal_within_a_step_is_driven_to_straight():
    plan = plan_with(planner(60.0), scenario(start=(50.0, 40.0), goal=(56.3, 41.1), unit=1.0), 0)
    assert plan.paths[0].xy.tolist() == [[50.0, 40.0], [56.3, 41.1]]


def test_a_goal_that_a_step_lands_beside_is_driven_past():
    """The first node is 0.5 m from it, but it lies far off its heading: the sector does not hold it."""
    found = scenario(start=centre(250, 170), goal=tuple(np.add(centre(250, 170), (8.75, 0.2))), unit=1.0)
    nodes = found.goals[0] - (one := descent_of(found, planner(60.0))).ground.to_metres(one.nodes)
    apart = np.hypot(*nodes.T)
    assert apart[1] < 0.55
    assert (apart[2:4] > 7.0).all()


def test_no_path_is_longer_than_the_range():
    far = dataclasses.replace(strewn(0), max_range=100.0)
    plan = plan_with(planner(30.0), far, 0)
    assert (plan.paths, plan.outcome) == ((), NOT_FOUND)
    assert "exceed the range of 100 m" in plan.reason


def test_a_step_shorter_than_a_pixel_is_bad_input():
    with pytest.raises(InputError, match=r"a step of 0\.139 m is shorter than a cell of 0\.234 m"):
        plan_with(planner(1.0), WALL, 0)


def test_pixels_are_those_of_the_raster_or_as_said():
    named = load_scenario("target-vehicle-71m")
    assert descent_of(named, planner(30.0)).ground.blocked.shape == (512, 512)
    assert descent_of(WALL, planner(30.0)).ground.cell == PIXEL
    assert descent_of(WALL, planner(30.0, cell=0.5)).ground.cell == 0.5


@pytest.mark.parametrize("kmh", SPEEDS)
def test_no_seed_changes_the_path(kmh):
    one, two = (plan_with(planner(kmh), strewn(9), seed).paths[0] for seed in (0, 1))
    assert one.points.tobytes() == two.points.tobytes()


@pytest.mark.parametrize("name", ["target-vehicle-71m", "target-vehicle-640m"])
@pytest.mark.parametrize("kmh", SPEEDS)
def test_of_the_six_plans_on_our_maps_greedy_descent_finds_one(name, kmh):
    plan = plan_with(planner(kmh), load_scenario(name), 0)
    assert bool(plan.paths) == (name == "target-vehicle-640m" and kmh == 30.0)
