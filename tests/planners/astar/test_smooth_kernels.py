import math

import numpy as np
import pytest

from planners.all_planners import make_planner
from planners.astar.room import body_of
from planners.astar.smooth_kernels import bends, contacts, normals

NONE = np.empty((0, 2))
STEP = 1e-6  # [m] of the finite differences


def wavy(seed, n=14):
    """Points of unequal distances that turn to and fro."""
    rng = np.random.default_rng(seed)
    headings = np.cumsum(0.5 * rng.standard_normal(n))
    return np.cumsum(rng.uniform(0.7, 1.4, (n, 1)) * np.column_stack([np.cos(headings), np.sin(headings)]), axis=0)


def differences(function, points, left):
    """By how much what `function` gives for points moves with the shift of each (R, N)."""
    columns = []
    for i in range(len(points)):
        there, back = points.copy(), points.copy()
        there[i] += STEP * left[i]
        back[i] -= STEP * left[i]
        columns.append((function(there) - function(back)) / (2.0 * STEP))
    return np.array(columns).T


def in_band(rows, first, n):
    """The matrix (R, n) of rows whose columns begin at `first` (R,)."""
    matrix = np.zeros((len(rows), n))
    for row, at, values in zip(matrix, first, rows, strict=True):
        for k, value in enumerate(values):
            if 0 <= at + k < n:
                row[at + k] += value
    return matrix


@pytest.mark.parametrize("ends", [(False, False), (True, False), (False, True), (True, True)])
@pytest.mark.parametrize("seed", range(3))
def test_curvatures_and_their_changes_move_as_differences_say(seed, ends):
    points = wavy(seed)
    left, n = normals(points), len(points)
    before = points[:1] - (0.3, 0.1) if ends[0] else NONE
    after = points[-1:] - (-0.2, -0.4) if ends[1] else NONE
    _, by, _, change_by = bends(points, left, before, after)
    exact = differences(lambda at: bends(at, left, before, after)[0], points, left)
    assert in_band(by, np.arange(n) - 1, n) == pytest.approx(exact, abs=1e-5)
    exact = differences(lambda at: bends(at, left, before, after)[2], points, left)
    assert in_band(change_by, np.arange(n - 1) - 1, n) == pytest.approx(exact, abs=1e-5)


def test_the_curvature_of_a_circle_is_one_over_its_radius():
    angle = np.linspace(0.0, 3.0, 61)
    points = 20.0 * np.column_stack([np.sin(angle), 1.0 - np.cos(angle)])
    curvature, _, change, _ = bends(points, normals(points), NONE, NONE)
    # Of an arc by its chords: x / sin(x) greater, where x is half the angle between points
    assert curvature[1:-1] == pytest.approx(0.05 * 0.025 / math.sin(0.025), rel=1e-9)
    assert np.abs(change[1:-1]).max() < 1e-9
    assert curvature[[0, -1]].tolist() == [0.0, 0.0]
    assert normals(points)[1:-1] == pytest.approx(np.column_stack([-np.sin(angle), np.cos(angle)])[1:-1])


def test_what_room_is_left_moves_as_differences_say():
    """In a field that is a plane, of which linear reading is exact."""
    rows, columns = np.indices((120, 160))
    field = 0.3 * (columns + 0.5) * 0.5 - 0.2 * (rows + 0.5) * 0.5
    points = wavy(4, 20) * 0.8 + (35.0, 30.0)
    body, left, size = body_of(make_planner("astar-arc")), normals(points), np.array([80.0, 60.0])
    args = field, 0.5, size, body.along, body.radius, math.inf
    at, _, by = contacts(points, left, *args)
    assert len(at) == len(points) * (len(body.along) + 4)  # discs, and the sides of the map
    exact = differences(lambda moved: contacts(moved, left, *args)[1], points, left)
    assert in_band(by, at - 1, len(points)) == pytest.approx(exact, abs=1e-6)


def test_only_what_is_near_is_a_contact():
    field = np.full((40, 40), 5.0)
    points = np.column_stack([np.linspace(10.0, 30.0, 11), np.full(11, 20.0)])
    along = np.array([0.0])
    assert len(contacts(points, normals(points), field, 1.0, np.array([40.0, 40.0]), along, 1.0, 3.9)[0]) == 0
    assert len(contacts(points, normals(points), field, 1.0, np.array([40.0, 40.0]), along, 1.0, 4.0)[0]) == 11
