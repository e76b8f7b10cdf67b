import math

import numpy as np
import pytest

from planners.all_planners import make_planner
from planners.astar.linearised import WITHIN, Bounds, best_shifts, linearised
from planners.astar.room import body_of, room_of
from planners.astar.room_kernels import drawn
from planners.astar.smooth import smoothed
from sample_maps import box, scenario

TRUCK = make_planner("astar-arc")
BODY = body_of(TRUCK)
ROOM = room_of(scenario(unit=1.0), 0.5)
BOUNDS = Bounds(curvature=0.03, change=0.004, margin=0.2)
STRAIGHT = np.column_stack([np.linspace(20.0, 100.0, 81), np.full(81, 40.0)])


def bow(curvature):
    """To the left and back again by two arcs of 30 m: points (N, 2) every half metre."""
    turn = 30.0 * curvature
    nodes = np.zeros((4, 5))
    x, y, heading = 25.0, 35.0, 0.0
    for i, k in enumerate((None, 0.0, curvature, -curvature)):
        if k is not None:
            length = 15.0 if k == 0.0 else 30.0
            half = 0.5 * k * length
            chord = length if k == 0.0 else length * math.sin(half) / half
            x, y, heading = (
                x + chord * math.cos(heading + half),
                y + chord * math.sin(heading + half),
                heading + 2 * half,
            )
            nodes[i] = x, y, heading, nodes[i - 1, 3] + length, k
        else:
            nodes[i] = x, y, heading, 0.0, 0.0
    assert abs(turn) < 1.5
    return drawn(nodes, 0.5)


def kept(points, bounds):
    """Curvatures and their changes, relative to their bounds."""
    steps = np.diff(points, axis=0)
    legs, headings = np.hypot(*steps.T), np.unwrap(np.arctan2(*steps.T[::-1]))
    bends = np.diff(headings) / (0.5 * (legs[1:] + legs[:-1]))
    return np.abs(bends).max() / bounds.curvature, np.abs(np.diff(bends) / legs[1:-1]).max() / bounds.change


def length(points):
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def test_a_straight_line_in_the_open_stays_as_it_is():
    linear = linearised(STRAIGHT, ROOM, BODY, BOUNDS, 4.0)
    assert linear.kept
    assert linear.merit == pytest.approx(80.0)
    assert np.abs(best_shifts(linear, 1.0)).max() < 1e-4
    assert smoothed(STRAIGHT, 1.0, ROOM, BODY, BOUNDS) == pytest.approx(STRAIGHT, abs=1e-3)


def test_no_shift_is_greater_than_the_trust_and_the_ends_stay():
    shifts = best_shifts(linearised(bow(0.03), ROOM, BODY, BOUNDS, 4.0), 0.25)
    assert np.abs(shifts).max() <= 0.25 + 1e-5
    assert shifts[[0, -1]].tolist() == [0.0, 0.0]


def test_where_nothing_stands_two_arcs_become_a_straight_line():
    arcs = bow(0.03)
    points = smoothed(arcs, 1.0, ROOM, BODY, BOUNDS)
    assert points[[0, -1]] == pytest.approx(arcs[[0, -1]], abs=1e-9)
    assert length(points) == pytest.approx(float(np.hypot(*(arcs[-1] - arcs[0]))), abs=0.02)


@pytest.mark.parametrize("curvature", [0.02, 0.03])
def test_between_given_headings_two_arcs_keep_both_bounds(curvature):
    """The arcs jump in curvature, and their end is not along their start: with headings kept, a bend remains."""
    arcs = bow(curvature)
    bounds = Bounds(0.03, 0.004, 0.2, start=0.0, goal=0.0)
    points = smoothed(arcs, 1.0, ROOM, BODY, bounds)
    bends, changes = kept(points, bounds)
    assert 0.1 < bends <= 1.0 + WITHIN
    assert changes <= 1.0 + WITHIN
    assert kept(arcs[::2], bounds)[1] > 1.5
    for leg, given in ((points[1] - points[0], 0.0), (points[-1] - points[-2], 0.0)):
        assert math.atan2(leg[1], leg[0]) == pytest.approx(given, abs=0.5 * 0.03 * 1.1)


def test_bounds_that_cannot_be_kept_give_none():
    """A quarter of a circle of 30 m with its headings given, where only 100 m are allowed."""
    angle = np.linspace(0.0, 0.5 * math.pi, 48)
    quarter = np.column_stack([40.0 + 30.0 * np.sin(angle), 60.0 - 30.0 * np.cos(angle)])
    assert smoothed(quarter, 1.0, ROOM, BODY, Bounds(0.01, 0.004, 0.2, 0.0, 0.5 * math.pi)) is None


def test_the_margin_gives_way_and_curvature_does_not():
    """Between two walls 3.4 m apart the body has 0.45 m to either side, less what cells hide: not the 1 m wanted."""
    lane = room_of(scenario(polygons=[box(40.0, 0.0, 40.0, 38.3), box(40.0, 41.7, 40.0, 38.3)], unit=1.0), 0.1)
    bounds = Bounds(0.03, 0.004, 1.0)
    points = smoothed(STRAIGHT + (0.0, 0.1) * np.sin(STRAIGHT[:, :1] / 10.0), 1.0, lane, BODY, bounds)
    linear = linearised(points, lane, BODY, bounds, 4.0)
    assert linear.kept
    assert 0.6 < linear.excess[2] < 0.9
    # In the lane, the margin is lost equally to both sides
    inside = (points[:, 0] > 42.0) & (points[:, 0] < 72.0)
    assert points[inside, 1] == pytest.approx(40.0, abs=0.05)


def test_an_obstacle_is_passed_at_the_margin():
    post = room_of(scenario(circles=[(60.0, 40.0, 1.0)], unit=1.0), 0.1)
    detour = STRAIGHT + (0.0, 4.0) * np.exp(-(((STRAIGHT[:, :1] - 60.0) / 12.0) ** 2))
    points = smoothed(detour, 1.0, post, BODY, BOUNDS)
    linear = linearised(points, post, BODY, BOUNDS, 4.0)
    assert linear.kept
    assert linear.excess[2] <= 0.01
    assert 80.0 < length(points) < length(detour)
    # Radius, half the body and the margin; the rims of the discs and what a cell hides come on top
    assert 0.0 <= points[:, 1].max() - 40.0 - (1.0 + 1.25 + 0.2) <= 0.4
