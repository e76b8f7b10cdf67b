from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Disc
from planners.map import Circle, Map, Raster
from planners.occupancy import cell_centres, clearance_field, extent, occupancy

BOUNDS = (0.0, 0.0, 12.0, 9.0)
SQUARE = np.array([[2.0, 2.0], [5.0, 2.0], [5.0, 4.0], [2.0, 4.0]])

# Quarters, so that vertices and sides lie on grid lines as often as not.
quarters = st.integers(-8, 56).map(lambda n: n / 4.0)
circles = st.builds(Circle, quarters, quarters, st.integers(1, 24).map(lambda n: n / 4.0))


@st.composite
def polygons(draw):
    points = draw(st.lists(st.tuples(quarters, quarters), min_size=3, max_size=7, unique=True))
    x, y = np.mean(points, axis=0)
    ring = np.array(sorted(points, key=lambda p: (math.atan2(p[1] - y, p[0] - x), p)))
    polygon = shapely.Polygon(ring)
    return ring if polygon.is_valid and polygon.area > 0.0 else SQUARE


def cells(grid):
    rows, columns = np.indices(grid.blocked.shape)
    x, y = grid.x + columns * grid.cell, grid.y + rows * grid.cell
    return shapely.box(x, y, x + grid.cell, y + grid.cell)


@settings(max_examples=150, deadline=None)
@given(polygons(), st.sampled_from([0.5, 1.0, 1.3]))
def test_a_cell_that_shares_an_area_with_a_polygon_is_blocked(ring, cell):
    grid = occupancy(Map(polygons=(ring,)), cell, BOUNDS)
    shared = shapely.area(shapely.intersection(cells(grid), shapely.Polygon(ring)))
    assert (grid.blocked == (shared > 1e-9)).all()


@settings(max_examples=100, deadline=None)
@given(polygons(), st.sampled_from([0.5, 1.0, 1.3]))
def test_a_cell_not_wholly_in_a_keep_in_polygon_is_blocked(ring, cell):
    grid = occupancy(Map(keep_in=(ring,)), cell, BOUNDS)
    left_out = shapely.area(shapely.difference(cells(grid), shapely.Polygon(ring)))
    assert (grid.blocked == (left_out > 1e-9)).all()


@settings(max_examples=100, deadline=None)
@given(circles, st.sampled_from([0.5, 1.0, 1.3]))
def test_circles_are_not_polygons(circle, cell):
    centre = shapely.Point(circle.x, circle.y)
    grid = occupancy(Map(circles=(circle,)), cell, BOUNDS)
    near = shapely.distance(cells(grid), centre)
    assert (grid.blocked == (near < circle.radius - 1e-9)).all()
    grid = occupancy(Map(keep_in_circles=(circle,)), cell, BOUNDS)
    far = [[max(centre.distance(shapely.Point(p)) for p in box.exterior.coords) for box in row] for row in cells(grid)]
    assert (grid.blocked == (np.array(far) > circle.radius + 1e-9)).all()


@settings(max_examples=100, deadline=None)
@given(st.integers(0, 2**32 - 1), quarters, quarters, st.sampled_from([0.5, 1.0, 1.3]))
def test_cells_of_another_raster(seed, x, y, cell):
    blocked = np.random.default_rng(seed).random((5, 7)) < 0.2
    grid = occupancy(Map(raster=Raster(blocked, 0.75, x, y)), cell, BOUNDS)
    squares = [
        shapely.box(x + 0.75 * c, y + 0.75 * r, x + 0.75 * c + 0.75, y + 0.75 * r + 0.75)
        for r, c in np.argwhere(blocked)
    ]
    shared = shapely.area(shapely.intersection(cells(grid), shapely.union_all(squares)))
    assert (grid.blocked == (shared > 1e-9)).all()


def test_a_raster_in_its_own_cells_is_itself():
    blocked = np.random.default_rng(3).random((512, 512)) < 0.3
    cell = 71.25 / 512.0
    assert (occupancy(Map(raster=Raster(blocked, cell)), cell).blocked == blocked).all()


def test_touching_does_not_block():
    grid = occupancy(Map(polygons=(SQUARE,), bounds=BOUNDS), 1.0)
    assert grid.blocked.sum() == 6
    assert grid.blocked[2:4, 2:5].all()


def test_cells_beyond_the_bounds_are_blocked():
    grid = occupancy(Map(bounds=(0.0, 0.0, 2.5, 2.0)), 1.0)
    assert grid.blocked.tolist() == [[False, False, True], [False, False, True]]
    assert occupancy(Map(bounds=(1.0, 1.0, 2.0, 2.0)), 1.0, (0.0, 0.0, 3.0, 3.0)).blocked.sum() == 8


def test_the_grid_spans_what_the_map_holds():
    area = Map(polygons=(SQUARE,), circles=(Circle(10.0, 0.0, 1.0),), raster=Raster(np.ones((2, 3)), 2.0, x=-1.0))
    assert extent(area) == (-1.0, -1.0, 11.0, 4.0)
    grid = occupancy(area, 0.5)
    assert (grid.blocked.shape, grid.x, grid.y) == ((10, 24), -1.0, -1.0)
    with pytest.raises(InputError, match="no extent"):
        occupancy(Map(), 1.0)


@pytest.mark.parametrize("cell", [0.0, -1.0, math.nan, math.inf])
def test_a_cell_has_a_size(cell):
    with pytest.raises(InputError, match="cell size"):
        occupancy(Map(bounds=BOUNDS), cell)


@settings(max_examples=60, deadline=None)
@given(st.lists(polygons(), max_size=3), st.lists(circles, max_size=3), st.sampled_from([0.5, 1.0]))
def test_the_field_is_within_half_a_diagonal_of_the_exact_distance(rings, rounds, cell):
    area = Map(polygons=tuple(rings), circles=tuple(rounds))
    # Wide enough that no obstacle lies beyond the grid.
    grid = occupancy(area, cell, (-9.0, -9.0, 21.0, 21.0))
    field, centres = clearance_field(grid), cell_centres(grid)
    poses = np.column_stack([centres.reshape(-1, 2), np.zeros(field.size)])
    exact = clearance(area, poses, Disc(0.0)).reshape(field.shape)
    free = ~grid.blocked
    if not rings and not rounds:
        assert np.isinf(field).all()
        return
    assert (field[grid.blocked] == 0.0).all()
    assert np.abs(field - exact)[free].max(initial=0.0) <= cell / math.sqrt(2.0) + 1e-9


def test_beyond_the_grid_may_be_blocked():
    grid = occupancy(Map(bounds=(0.0, 0.0, 5.0, 5.0)), 1.0)
    assert clearance_field(grid, beyond=True)[2].tolist() == [1.0, 2.0, 3.0, 2.0, 1.0]
    assert np.isinf(clearance_field(grid)).all()


def test_centres_are_x_y_by_row_and_column():
    grid = Raster(np.zeros((2, 3)), 2.0, x=10.0, y=-1.0)
    assert cell_centres(grid)[1, 2].tolist() == [15.0, 2.0]
