import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from planners.segments import cells_of, is_free, polyline_length, without_needless

ROWS, COLUMNS = 7, 9
grids = st.lists(st.booleans(), min_size=ROWS * COLUMNS, max_size=ROWS * COLUMNS).map(
    lambda cells: np.array(cells).reshape(ROWS, COLUMNS)
)
# Quarters, so that segments pass through corners and along grid lines as often as not
xs, ys = (st.integers(0, 4 * n - 1).map(lambda n: n / 4.0) for n in (COLUMNS, ROWS))


def cells(marked):
    rows, columns = np.nonzero(marked)
    return shapely.box(columns, rows, columns + 1, rows + 1)


@given(grids, xs, ys, xs, ys)
def test_a_free_segment_touches_no_inside_of_a_blocked_cell(blocked, x0, y0, x1, y1):
    if is_free(blocked, x0, y0, x1, y1):
        line = shapely.LineString([(x0, y0), (x1, y1)])
        inner = shapely.buffer(cells(blocked), -1e-7)
        assert not shapely.intersects(line, inner).any()


@given(grids, xs, ys, xs, ys)
def test_a_segment_clear_of_blocked_cells_is_free(blocked, x0, y0, x1, y1):
    line = shapely.LineString([(x0, y0), (x1, y1)])
    if len(cells(blocked)) == 0 or shapely.distance(line, cells(blocked)).min() > 1e-6:
        assert is_free(blocked, x0, y0, x1, y1)


def test_nothing_slips_between_two_blocked_cells_that_touch():
    blocked = np.array([[False, True], [True, False]])
    assert not is_free(blocked, 0.5, 0.5, 1.5, 1.5)
    assert is_free(~blocked & False, 0.5, 0.5, 1.5, 1.5)


@pytest.mark.parametrize(("x", "y"), [(-0.1, 1.0), (3.0, 1.0), (1.0, 2.0), (1.0, -0.5)])
def test_off_the_grid_is_not_free(x, y):
    assert not is_free(np.zeros((2, 3), dtype=bool), 1.0, 1.0, x, y)


@given(xs, ys, xs, ys)
def test_the_cells_of_a_segment_are_those_it_passes_through_each_once(x0, y0, x1, y1):
    found = np.empty((ROWS + COLUMNS, 2), np.int64)
    passed = found[: cells_of(x0, y0, x1, y1, found)]
    assert len({tuple(cell) for cell in passed.tolist()}) == len(passed)
    line = shapely.LineString([(x0, y0), (x1, y1)])
    boxes = [shapely.box(column, row, column + 1, row + 1) for column, row in passed.tolist()]
    assert shapely.distance(line, boxes).max(initial=0.0) == 0.0
    if len(passed):
        assert passed[-1].tolist() == [int(x1), int(y1)]


def test_a_free_way_needs_its_ends_only():
    blocked = np.zeros((5, 30), dtype=bool)
    way = np.column_stack([np.arange(1.0, 25.0), 2.0 + np.sin(np.arange(1.0, 25.0))])
    kept = without_needless(blocked, way, 100)
    assert kept.tolist() == [way[0].tolist(), way[-1].tolist()]
    assert polyline_length(kept) == pytest.approx(np.hypot(*(way[-1] - way[0])))
