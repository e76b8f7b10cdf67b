import math

import numpy as np
import pytest

from planners.all_planners import make_planner, plan_with
from planners.astar import arc
from planners.astar.arc_kernels import CURVATURE, HEADING, HEADINGS, WAY, X, Y, cell_of, search
from planners.astar.finish_kernels import FREE_HEADING, arc_to, last_arcs
from planners.astar.room_kernels import along_arc
from planners.clearance import clearance
from planners.footprint import Rectangle
from sample_maps import box, scenario

TRUCK = Rectangle(7.0, 2.5, 2.25)
POSTS = scenario(circles=[(40.0, 38.0, 6.0), (75.0, 46.0, 7.0)], goal=(105.0, 40.0), unit=1.0)
GAP = scenario(polygons=[box(55.0, 0.0, 4.0, 30.0), box(55.0, 38.0, 4.0, 42.0)], goal=(105.0, 40.0), unit=1.0)
STEP, CURVED, CHANGE, SEEN, SLACK = 12, 13, 14, 15, 17  # of the arguments of `search`


@pytest.fixture
def searched(monkeypatch):
    """Plans, and gives what the last search was asked (its arguments) and what it found."""
    calls = []

    def recorded(*asked):
        calls.append((asked, search(*asked)))
        return calls[-1][1]

    monkeypatch.setattr(arc, "search", recorded)

    def run(found, kmh, **more):
        plan_with(make_planner("astar-arc", {"speed": f"{kmh:g}km/h", **more}), found, 0)
        return calls[-1]

    return run


def way(found):
    """The nodes (N, 5) of the way a search has found."""
    last, _, nodes, parents = found
    assert last >= 0
    chain = [last]
    while parents[chain[-1]] >= 0:
        chain.append(parents[chain[-1]])
    return nodes[chain[::-1]]


@pytest.mark.parametrize("goal_heading", [None, 30.0])
@pytest.mark.parametrize("kmh", [30.0, 60.0])
@pytest.mark.parametrize("found", [POSTS, GAP], ids=["posts", "gap"])
def test_every_arc_keeps_all_limits_and_leads_to_the_next(searched, found, kmh, goal_heading):
    asked, result = searched(found, kmh, **({} if goal_heading is None else {"goal_heading": goal_heading}))
    nodes = way(result)
    bends, lengths = nodes[1:, CURVATURE], np.diff(nodes[:, WAY])
    assert np.abs(bends).max() <= asked[CURVED] * (1.0 + 1e-9)
    assert np.abs(np.diff(bends)).max() <= asked[CHANGE] * (1.0 + 1e-9)
    if goal_heading is None:
        assert lengths[:-1] == pytest.approx(asked[STEP])
    else:
        assert math.cos(nodes[-1, HEADING] - math.radians(goal_heading)) == pytest.approx(1.0, abs=1e-9)
    assert (nodes[-1, [X, Y]] == found.goals[0]).all()
    for before, after, length in zip(nodes, nodes[1:], lengths, strict=False):
        driven = np.array([along_arc(*before[:3], after[CURVATURE], s) for s in np.linspace(0.0, length, 30)])
        assert driven[-1] == pytest.approx(after[:3], abs=1e-6)
        assert clearance(found.map, driven, TRUCK).min() >= 0.0


@pytest.mark.parametrize("kmh", [30.0, 60.0])
@pytest.mark.parametrize("found", [POSTS, GAP], ids=["posts", "gap"])
def test_what_is_found_is_within_its_slack_of_the_shortest(searched, found, kmh):
    asked, result = searched(found, kmh)
    exact = list(asked)
    exact[SEEN], exact[SLACK] = np.zeros_like(asked[SEEN]), 1.0
    shortest = search(*exact)
    # Which poses share a cell decides a little more
    assert 0.999 * way(shortest)[-1, WAY] <= way(result)[-1, WAY] <= asked[SLACK] * way(shortest)[-1, WAY]
    assert result[1] <= shortest[1]  # poses


def test_headings_half_a_cell_apart_share_it():
    cell = 2.0 * math.pi / HEADINGS
    numbers = [cell_of(3.2, 4.9, heading, 1.0, 100) for heading in (0.0, 0.49 * cell, -0.49 * cell, 4.0 * math.pi)]
    assert set(numbers) == {(4 * 100 + 3) * HEADINGS}
    assert cell_of(3.2, 4.9, 0.51 * cell, 1.0, 100) == (4 * 100 + 3) * HEADINGS + 1


def test_the_arc_to_a_point_in_closed_form():
    assert arc_to(0.0, 0.0, 0.0, np.array([4.0, 0.0])) == pytest.approx((0.0, 4.0))
    assert arc_to(1.0, 1.0, 0.5 * math.pi, np.array([3.0, 3.0])) == pytest.approx((-0.5, math.pi))  # a quarter
    assert arc_to(0.0, 0.0, 0.0, np.array([-4.0, 0.1]))[1] == math.inf
    assert arc_to(2.0, 3.0, 1.0, np.array([2.0, 3.0]))[1] == math.inf


def test_the_last_arcs_begin_where_the_wheels_can():
    """Straight ahead with wheels turned: not onto a line, unless the path begins."""
    arcs, goal = np.empty((3, 2)), np.array([6.0, 0.0])
    for heading in (FREE_HEADING, 0.0):
        args = goal, heading, 5.0, 0.1, 0.06, arcs
        assert last_arcs(0.0, 0.0, 0.0, 0.05, False, *args) == pytest.approx(6.0)
        assert last_arcs(0.0, 0.0, 0.0, 0.1, True, *args) == pytest.approx(6.0)
        assert arcs[arcs[:, 1] > 0.0] == pytest.approx(np.array([[0.0, 6.0]]))
        assert last_arcs(0.0, 0.0, 0.0, 0.1, False, *args) > 6.5
