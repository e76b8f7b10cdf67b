from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.ndimage import label
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from planners.clearance import clearance
from planners.errors import InputError
from planners.exact import Exact, free_space
from planners.footprint import Disc
from planners.frame import Frame
from planners.inflate import inflated
from planners.map import Circle, Map, Raster
from planners.occupancy import cell_centres, occupancy
from planners.path import Path
from planners.planner import NO_PATH
from planners.scenario import Scenario, load_scenario

SQUARE = np.array([[-5.0, -5.0], [5.0, -5.0], [5.0, 5.0], [-5.0, 5.0]])
SIDE = 40.0

seeds = st.integers(0, 2**32 - 1)


def scenario(area, start, goal, side=SIDE):
    ends = np.array([start, goal], dtype=float)
    return Scenario(name="a map", map=area, starts=ends[:1], goals=ends[1:], size=(side, side))


def planned(area, start, goal, keep=0.0):
    return Exact(clearance=keep).plan(scenario(area, start, goal), np.random.default_rng(0))


def path_of(*args) -> Path:
    plan = planned(*args)
    assert len(plan.paths) == 1, plan.reason
    return plan.paths[0]


def rooms(area, points):
    return clearance(area, np.column_stack([points, np.zeros(len(points))]), Disc(0.0))


def assert_clear(path, area, keep, spacing=0.1):
    points = np.vstack([path.xy, path.resample(spacing).xy])
    assert clearance(area, np.column_stack([points, np.zeros(len(points))]), Disc(keep)).min() >= -1e-6


def around_circle(start, goal, radius):
    """Two tangents and an arc about the origin."""
    apart = math.acos(np.dot(start, goal) / (math.hypot(*start) * math.hypot(*goal)))
    turn = apart - sum(math.acos(radius / math.hypot(*end)) for end in (start, goal))
    return sum(math.sqrt(math.hypot(*end) ** 2 - radius**2) for end in (start, goal)) + radius * turn


def random_map(rng):
    polygons = []
    for _ in range(rng.integers(0, 5)):
        radii = rng.uniform(0.2, 1.0, rng.integers(3, 8)) * rng.uniform(2.0, 10.0)
        angles = np.linspace(0.0, 2.0 * np.pi, len(radii), endpoint=False) + rng.uniform(0.0, 6.0)
        polygons.append(np.column_stack([np.cos(angles), np.sin(angles)]) * radii[:, None] + rng.uniform(0.0, SIDE, 2))
    circles = tuple(Circle(*rng.uniform(0.0, SIDE, 2), rng.uniform(1.0, 6.0)) for _ in range(rng.integers(0, 4)))
    keep_in = (np.array([[1.0, 0.0], [39.0, 3.0], [30.0, 20.0], [38.0, 40.0], [0.0, 38.0]]),)
    return Map(
        polygons=tuple(polygons),
        circles=circles,
        keep_in=keep_in if rng.random() < 0.3 else (),
        bounds=(0.0, 0.0, SIDE, SIDE),
        edge=str(rng.choice(["open", "closed"])),
    )


def free_pair(rng, area, keep):
    points = rng.uniform(0.0, SIDE, (60, 2))
    free = points[rooms(area, points) > keep + 1e-3]
    assume(len(free) >= 2)
    return free[0], free[1]


def test_the_known_length_on_the_nofly_map():
    plan = Exact().plan(load_scenario("nofly-1000x660"), np.random.default_rng(0))
    (path,) = plan.paths
    assert path.length / 20.0 == pytest.approx(1192.21, abs=0.01)
    # Around a corner of the first polygon, the large circle and a corner of the last polygon
    centre, before, after = np.array([690.0, 430.0]), np.array([110.0, 300.0]), np.array([850.0, 600.0])
    legs = math.hypot(80.0, 260.0) + math.hypot(120.0, 20.0)
    exact = legs + around_circle(before - centre, after - centre, 100.0)
    assert exact <= path.length / 20.0 <= exact * (1.0 + 1e-5)
    assert_clear(path, load_scenario("nofly-1000x660").map, 0.0, 20.0)
    assert plan.smallest_radius is None


@pytest.mark.parametrize("keep", [50.0, 200.0])
def test_a_clearance_is_none_on_a_map_grown_by_it(keep):
    given = load_scenario("nofly-1000x660")
    grown = replace(given, map=inflated(given.map, keep))
    (one,), (other,) = (Exact(keep).plan(given, None).paths, Exact(0.0).plan(grown, None).paths)
    assert other.length == pytest.approx(one.length, rel=1e-5)


@pytest.mark.parametrize("keep", [0.0, 0.5, 3.0])
def test_tangents_and_arc_around_a_circle(keep):
    area = Map(circles=(Circle(0.0, 0.0, 4.0),))
    start, goal = (-15.0, 1.0), (12.0, 2.0)
    exact = around_circle(start, goal, 4.0 + keep)
    assert exact <= path_of(area, start, goal, keep).length <= exact * (1.0 + 1e-5)


@pytest.mark.parametrize("keep", [0.0, 0.5, 3.0])
def test_round_two_corners_of_a_square(keep):
    path = path_of(Map(polygons=(SQUARE,)), (-15.0, 1.0), (15.0, 1.0), keep)
    away = math.hypot(10.0, 4.0)
    turn = math.atan2(4.0, 10.0) + math.asin(keep / away)
    exact = 2.0 * (math.sqrt(away**2 - keep**2) + keep * turn) + 10.0
    assert exact * (1.0 - 1e-9) <= path.length <= exact * (1.0 + 1e-5)


def test_cells_are_squares():
    blocked = np.zeros((3, 3), dtype=bool)
    blocked[1, 1] = True
    area = Map(raster=Raster(blocked, 10.0, x=-15.0, y=-15.0))
    path = path_of(area, (-15.0, 1.0), (15.0, 1.0))
    assert path.length == pytest.approx(2.0 * math.hypot(10.0, 4.0) + 10.0, rel=1e-8)
    same = path_of(Map(polygons=(SQUARE,)), (-15.0, 1.0), (15.0, 1.0), 1.5)
    assert path_of(area, (-15.0, 1.0), (15.0, 1.0), 1.5).length == pytest.approx(same.length, rel=1e-9)


def test_a_free_line_is_straight():
    plan = planned(Map(polygons=(SQUARE,)), (-15.0, 6.0), (15.0, 6.0), 1.0)
    assert plan.paths[0].points.tolist() == [[-15.0, 6.0], [15.0, 6.0]]
    assert plan.smallest_radius == math.inf
    assert path_of(Map(), (0.0, 0.0), (3.0, 4.0)).length == 5.0


def test_a_corridor_that_is_too_narrow_is_no_way():
    walls = tuple(np.array([[-1.0, y], [1.0, y], [1.0, y + 17.0], [-1.0, y + 17.0]]) for y in (3.0, 24.0))
    area = Map(polygons=walls, bounds=(-20.0, 3.0, 20.0, 41.0))
    assert path_of(area, (-15.0, 22.0), (15.0, 22.0), 1.99).length == 30.0
    plan = planned(area, (-15.0, 22.0), (15.0, 22.0), 2.01)
    assert (plan.paths, plan.outcome) == ((), NO_PATH)
    assert plan.reason == "obstacles and edges leave no way from start to goal with 2.01 m to spare on either side"


def test_what_touches_leaves_no_way_between():
    bounds = (-10.0, -10.0, 10.0, 10.0)
    wall = np.array([[-10.0, -1.0], [0.0, 0.0], [-10.0, 1.0]])
    ends = (-1.0, -5.0), (-1.0, 5.0)
    assert planned(Map(polygons=(wall, -wall), bounds=bounds), *ends).outcome == NO_PATH
    apart = Map(polygons=(wall, [0.01, 0.0] - wall), bounds=bounds)
    assert path_of(apart, *ends).length == pytest.approx(2.0 * math.hypot(1.0, 5.0), rel=1e-3)
    stairs = Map(raster=Raster(np.eye(20, dtype=bool), 1.0, x=-10.0, y=-10.0), bounds=bounds)
    assert planned(stairs, (-5.0, 5.0), (5.0, -5.0)).outcome == NO_PATH
    stretched = Map(polygons=(SQUARE, np.add(SQUARE, (9.9, 0.0)), np.add(SQUARE, (-9.9, 0.0))), bounds=bounds)
    assert planned(stretched, (0.0, -7.0), (0.0, 7.0)).outcome == NO_PATH


def test_keep_in_areas_bend_the_path_at_their_inner_corners():
    corner = np.array([[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [10.0, 10.0], [10.0, 20.0], [0.0, 20.0]])
    start, goal = (19.0, 8.0), (8.0, 19.0)
    assert path_of(Map(keep_in=(corner,)), start, goal).length == pytest.approx(2.0 * math.hypot(9.0, 2.0), rel=1e-8)
    area = Map(keep_in=(corner,), keep_in_circles=(Circle(0.0, 0.0, 21.0),))
    away = math.hypot(9.0, 2.0)
    turn = math.pi / 2.0 - 2.0 * (math.atan2(2.0, 9.0) - math.asin(1.0 / away))
    exact = 2.0 * math.sqrt(away**2 - 1.0) + turn
    assert path_of(Map(keep_in=(corner,)), start, goal, 1.0).length == pytest.approx(exact, rel=1e-5)
    assert planned(area, (17.0, 8.0), (8.0, 17.0), 1.0).paths
    assert planned(Map(keep_in=(corner,), keep_in_circles=(Circle(0.0, 0.0, 14.0),)), (12.0, 2.0), (2.0, 12.0)).paths
    apart = Map(keep_in=(corner,), keep_in_circles=(Circle(15.0, 15.0, 7.0),))
    assert planned(apart, (15.0, 9.0), (9.0, 15.0)).outcome == NO_PATH


@pytest.mark.parametrize(
    ("start", "goal", "length"),
    [
        ((-5.0, 0.0), (5.0, 0.0), 20.0),  # both on its sides
        ((-5.0, 5.0), (5.0, 5.0), 10.0),  # along a side
        ((-5.0, 5.0), (5.0, -5.0), 20.0),  # from corner to corner
        ((-20.0, 5.0), (20.0, 5.0), 40.0),  # on a line with a side, from border to border
        ((-20.0, -20.0), (20.0, 20.0), 2.0 * math.hypot(15.0, 25.0)),  # from corner to corner of the map
        ((-20.0, 20.0), (-20.0, -20.0), 40.0),  # along the map's border
    ],
)
@pytest.mark.parametrize("cells", [False, True])
def test_to_touch_is_free(start, goal, length, cells):
    raster = Raster(np.ones((4, 4), dtype=bool), 2.5, x=-5.0, y=-5.0)
    area = Map(polygons=() if cells else (SQUARE,), raster=raster if cells else None, bounds=(-20.0, -20.0, 20.0, 20.0))
    path = path_of(area, start, goal)
    assert path.length == pytest.approx(length, rel=1e-8)
    assert (path.xy[[0, -1]] == [start, goal]).all()
    assert np.diff(path.s).min() > 1e-3
    assert_clear(path, area, 0.0)


@pytest.mark.parametrize("keep", [0.0, 1.0])
def test_ends_as_near_to_something_round_as_may_be(keep):
    at = 0.3 + np.array([0.0, 2.5])
    circle, inside = Map(circles=(Circle(0.0, 0.0, 4.0),)), Map(keep_in_circles=(Circle(0.0, 0.0, 9.0),))
    start, goal = (4.0 + keep) * np.column_stack([np.cos(at), np.sin(at)])
    assert path_of(circle, start, goal, keep).length == pytest.approx(2.5 * (4.0 + keep), rel=1e-5)
    start, goal = (9.0 - keep) * np.column_stack([np.cos(at), np.sin(at)])
    assert path_of(inside, start, goal, keep).length == pytest.approx(np.hypot(*(goal - start)), rel=1e-8)


def test_an_end_without_the_clearance_is_an_error_that_says_how_far_it_is():
    area = Map(polygons=(SQUARE,))
    with pytest.raises(InputError) as caught:
        planned(area, (-8.0, 0.0), (15.0, 0.0), 4.0)
    assert str(caught.value) == (
        "a map: start: [-8.0, 0.0] m is 3 m from what is forbidden, nearer than the clearance of 4 m; "
        "move it to free ground, or give less clearance"
    )
    with pytest.raises(InputError, match=r"a map: goal: \[3.0, 0.0\] m is 2 m deep in what is forbidden; move it"):
        planned(area, (-8.0, 0.0), (3.0, 0.0))
    bounds = Map(bounds=(-10.0, -10.0, 10.0, 10.0), edge="open")
    assert path_of(bounds, (-10.0, 0.0), (10.0, 0.0), 4.0).length == 20.0


@pytest.mark.parametrize("keep", [math.nan, math.inf])
def test_a_clearance_that_is_not_finite_is_an_error(keep):
    with pytest.raises(InputError, match=r"planner exact: clearance: (nan|inf) m is not possible"):
        planned(Map(polygons=(SQUARE,)), (-8.0, 0.0), (8.0, 0.0), keep)


def test_start_and_goal_in_one_place_are_an_error():
    with pytest.raises(InputError, match="its start is its goal"):
        planned(Map(), (1.0, 2.0), (1.0, 2.0))


def test_the_nearest_places_are_a_line_apart():
    assert path_of(Map(polygons=(SQUARE,)), (-5.0, 0.0), (-5.0, 1e-10)).length == pytest.approx(1e-10)


@pytest.mark.parametrize("keep", [1e-300, 1e-15, 1e-12, 1e-9, 1e-6])
def test_next_to_no_clearance_is_next_to_none(keep):
    area = Map(
        polygons=(SQUARE, np.add(SQUARE, (13.0, 5.0))), circles=(Circle(3.0, 9.0, 4.5),), keep_in=(8.0 * SQUARE,)
    )
    ends = (-15.0, 1.0), (25.0, 8.0)
    assert path_of(area, *ends, keep).length == pytest.approx(path_of(area, *ends).length, rel=1e-6)


# tangent graphs, as in the scenario files; with a unit of clearance: ours
@pytest.mark.parametrize(
    ("hazards", "units", "total"), [(15, 0, 687.172), (15, 1, 688.51), (25, 0, 690.865), (25, 1, 692.98)]
)
def test_a_fleet_has_the_least_total_length(hazards, units, total):
    fleet = load_scenario(f"mars-hazards-{hazards}")
    plan = Exact(clearance=units * fleet.unit).plan(fleet, np.random.default_rng(0))
    assert [path.name[-1] for path in plan.paths] == ["2", "3", "1"]  # the targets of aircraft 1 to 3
    assert sum(path.length for path in plan.paths) / fleet.unit == pytest.approx(total, rel=1.5e-5)


def test_of_a_fleet_as_many_as_possible_are_served():
    """The nearer of two aircraft leaves the only target that the other can reach to it."""
    wall = np.array([[18.0, 0.0], [22.0, 0.0], [22.0, 40.0], [18.0, 40.0]])
    starts, goals = np.array([[30.0, 20.0], [5.0, 20.0], [35.0, 5.0]]), np.array([[39.0, 30.0], [10.0, 30.0]])
    fleet = Scenario(name="a map", map=Map(polygons=(wall,)), starts=starts, goals=goals, size=(SIDE, SIDE))
    fleet = replace(fleet, map=replace(fleet.map, bounds=(0.0, 0.0, SIDE, SIDE)))
    plan = Exact().plan(fleet, np.random.default_rng(0))
    assert [path.name for path in plan.paths] == ["aircraft 1 to target 1", "aircraft 2 to target 2"]
    assert plan.notes == (
        "aircraft 3 has no path: there are fewer targets than aircraft; paths are numbered on without",
    )


def test_the_path_lies_where_the_map_does():
    path = path_of(Map(frame=Frame(47.0, 8.0)), (0.0, 0.0), (3.0, 4.0))
    assert (path.frame, path.name) == (Frame(47.0, 8.0), "a map")


@pytest.mark.parametrize("name", ["target-vehicle-71m", "target-vehicle-640m"])
@pytest.mark.parametrize("keep", [0.0, 4.0])
def test_rasters_of_512_by_512(name, keep):
    given = load_scenario(name)
    (path,) = Exact(clearance=keep).plan(given, np.random.default_rng(0)).paths
    assert_clear(path, given.map, keep)
    assert path.length > np.hypot(*(given.goals[0] - given.starts[0]))


@settings(max_examples=40)
@given(seeds, st.sampled_from([0.0, 0.3, 1.0, 2.0]))
def test_the_path_is_clear_and_no_longer_than_one_over_cells(seed, keep):
    rng = np.random.default_rng(seed)
    area = random_map(rng)
    grid = occupancy(area, 1.0)
    centres = cell_centres(grid).reshape(-1, 2)
    index = np.arange(grid.blocked.size).reshape(grid.blocked.shape)
    free = ~grid.blocked & (rooms(area, centres) >= keep + 0.75).reshape(grid.blocked.shape)
    assume(free.sum() >= 2)
    links = []
    for here, there in (
        ((slice(None), slice(1, None)), (slice(None), slice(None, -1))),
        ((slice(1, None), slice(None)), (slice(None, -1), slice(None))),
        ((slice(1, None), slice(1, None)), (slice(None, -1), slice(None, -1))),
        ((slice(1, None), slice(None, -1)), (slice(None, -1), slice(1, None))),
    ):
        both = free[here] & free[there]
        links.append(np.column_stack([index[here][both], index[there][both]]))
    a, b = np.concatenate(links).T
    graph = coo_array((np.hypot(*(centres[a] - centres[b]).T), (a, b)), shape=(index.size, index.size)).tocsr()
    start, goal = rng.choice(index[free], 2, replace=False)
    over_cells = dijkstra(graph, directed=False, indices=start)[goal]
    plan = planned(area, centres[start], centres[goal], keep)
    if math.isfinite(over_cells):
        (path,) = plan.paths
        assert np.hypot(*(centres[goal] - centres[start])) <= path.length + 1e-9
        assert path.length <= over_cells * (1.0 + 1e-5)
    if plan.paths:
        assert_clear(plan.paths[0], area, keep)


@settings(max_examples=40)
@given(seeds, st.sampled_from([0.0, 0.5]))
def test_no_line_between_any_corners_is_shorter(seed, keep):
    rng = np.random.default_rng(seed)
    area = random_map(rng)
    area = Map(polygons=area.polygons[:3], keep_in=area.keep_in, bounds=area.bounds)
    ends = np.array(free_pair(rng, area, keep))
    # All pairs of vertices, each asked of GEOS, in space a trifle wider and a trifle narrower
    lengths = []
    for wider in (1e-6, -1e-6):
        space = shapely.simplify(free_space(area, keep, ends), 0.01 if keep else 0.0).buffer(wider, join_style="mitre")
        nodes = np.vstack([ends, np.unique(shapely.get_coordinates(space), axis=0)])
        a, b = np.triu_indices(len(nodes), 1)
        shapely.prepare(space)
        seen = shapely.covers(space, shapely.linestrings(np.stack([nodes[a], nodes[b]], axis=1)))
        a, b = a[seen], b[seen]
        graph = coo_array((np.hypot(*(nodes[a] - nodes[b]).T), (a, b)), shape=(len(nodes), len(nodes)))
        lengths.append(dijkstra(graph.tocsr(), directed=False, indices=0)[1])
    plan = planned(area, *ends, keep)
    length = plan.paths[0].length if plan.paths else math.inf
    tolerance = 1e-2 if keep else 1e-5
    assert length == pytest.approx(lengths[0], abs=tolerance) or length == pytest.approx(lengths[1], abs=tolerance)


@settings(max_examples=25)
@given(seeds)
def test_more_clearance_is_never_shorter(seed):
    rng = np.random.default_rng(seed)
    area = random_map(rng)
    ends = free_pair(rng, area, 2.0)
    plans = [planned(area, *ends, keep) for keep in (0.0, 1e-3, 0.2, 0.7, 2.0)]
    lengths = [plan.paths[0].length if plan.paths else math.inf for plan in plans]
    for less, more in pairwise(lengths):
        assert less <= more * (1.0 + 1e-5)


@settings(max_examples=40)
@given(seeds, st.floats(0.05, 0.5))
def test_among_random_cells_there_is_a_way_where_free_cells_have_common_sides(seed, share):
    rng = np.random.default_rng(seed)
    blocked = rng.random((15, 15)) < share
    cells = np.argwhere(~blocked)[:, ::-1] + 0.5
    assume(len(cells) >= 2)
    start, goal = rng.choice(cells, 2, replace=False)
    area = Map(raster=Raster(blocked, 1.0), bounds=(0.0, 0.0, 15.0, 15.0))
    region = label(~blocked)[0]
    (i, j), (m, n) = np.floor([start, goal]).astype(int)
    plan = planned(area, start, goal)
    assert bool(plan.paths) == (region[j, i] == region[n, m])
    if plan.paths:
        assert_clear(plan.paths[0], area, 0.0, 0.02)


@settings(max_examples=40)
@given(seeds, st.floats(0.05, 0.4), st.floats(0.0, 6.0), st.sampled_from([1e-3, 1.0, 1e4]))
def test_squares_turned_and_scaled_are_cells(seed, share, turn, scale):
    rng = np.random.default_rng(seed)
    blocked = rng.random((8, 8)) < share
    cells = np.argwhere(~blocked)[:, ::-1] + 0.5
    assume(len(cells) >= 2)
    ends = rng.choice(cells, 2, replace=False)
    turned = scale * np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    squares = tuple((corners + cell[::-1]) @ turned for cell in np.argwhere(blocked))
    of_cells = planned(Map(raster=Raster(blocked, 1.0), bounds=(0.0, 0.0, 8.0, 8.0)), *ends)
    of_squares = planned(Map(polygons=squares, keep_in=(8.0 * corners @ turned,)), *(ends @ turned))
    assert of_squares.outcome == of_cells.outcome
    for one, other in zip(of_cells.paths, of_squares.paths, strict=True):
        assert other.length == pytest.approx(scale * one.length, rel=1e-7)


def test_every_seed_gives_the_same_path():
    paths = [Exact().plan(load_scenario("nofly-1000x660"), np.random.default_rng(seed)).paths[0] for seed in (0, 1)]
    assert (paths[0].points == paths[1].points).all()
