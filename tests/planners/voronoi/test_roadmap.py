import math

import numpy as np
import pytest
import shapely

from planners.exact import free_space
from planners.map import Map
from planners.scenario import load_scenario
from planners.voronoi.candidates import in_sight, largest_turn
from planners.voronoi.roadmap import roadmap_of
from sample_maps import HEIGHT, UNIT, WIDTH, scenario

MARS = load_scenario("mars-hazards-15")


def test_edges_lie_halfway_between_the_two_nearest_hazards_or_on_the_edge():
    roadmap = roadmap_of(MARS, 250.0)
    centres = np.array([[circle.x, circle.y] for circle in MARS.map.circles])
    middles = roadmap.vertices[roadmap.edges].mean(axis=1)
    nearest = np.sort(np.hypot(*(middles[:, None] - centres).transpose(2, 0, 1)), axis=1)
    side = np.minimum(middles - 250.0, 300.0 * 250.0 - 250.0 - middles).min(axis=1)
    assert (np.isclose(nearest[:, 0], nearest[:, 1]) | (np.abs(side) < 1e-6)).all()
    assert len(np.unique(roadmap.edges)) == len(roadmap.vertices)


def test_of_two_hazards_the_roadmap_is_their_bisector_and_the_edge():
    roadmap = roadmap_of(scenario(circles=[(40.0, 40.0, 5.0), (80.0, 40.0, 5.0)]), 0.0)
    between = [edge for edge in roadmap.vertices[roadmap.edges] / UNIT if np.allclose(edge[:, 0], WIDTH / 2)]
    assert len(between) == 1
    assert sorted(between[0][:, 1]) == pytest.approx([0.0, HEIGHT])
    assert roadmap.free.all()


def test_a_map_without_hazards_has_no_roadmap():
    assert len(roadmap_of(scenario(), 0.0).edges) == 0


def test_an_edge_that_meets_a_hazard_is_not_free():
    """Two circles overlap, so their bisector leads through both."""
    roadmap = roadmap_of(scenario(circles=[(55.0, 40.0, 10.0), (65.0, 40.0, 10.0)]), 0.0)
    lines = roadmap.vertices[roadmap.edges]
    assert (np.abs(lines[~roadmap.free][:, :, 0] - 60.0 * UNIT) < 1e-6).all()
    assert (~roadmap.free).sum() == 1


def test_line_of_sight_leaves_one_corner_of_a_detour():
    """Of a detour about a square: along the tangent on its corner (-1, 1) to (5, 2.5), and on from there."""
    square = Map(polygons=(np.array([[-1.0, -9.0], [1.0, -9.0], [1.0, 1.0], [-1.0, 1.0]]),))
    ends = np.array([[-5.0, 0.0], [5.0, 0.0]])
    detour = np.array([ends[0], [-5.0, 4.0], [5.0, 4.0], ends[1]])
    free = free_space(square, 0.0, ends)
    short = in_sight(detour, free, 0.01)
    length = np.hypot(*np.diff(short, axis=0).T).sum()
    assert length == pytest.approx(math.hypot(10.0, 2.5) + 2.5, abs=0.02)
    assert len(short) == 3
    assert free.covers(shapely.LineString(short))


def test_the_largest_turn_is_that_of_the_sharpest_corner():
    corner = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]])
    assert largest_turn(corner) == pytest.approx(math.pi / 2)
