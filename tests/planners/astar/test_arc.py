import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.all_planners import make_planner, plan_with
from planners.astar.arc import AstarArc
from planners.clearance import clearance
from planners.errors import InputError
from planners.footprint import Rectangle
from planners.planner import NO_PATH, NOT_FOUND
from planners.scenario import load_scenario
from planners.units import STANDARD_GRAVITY
from sample_maps import box, scenario, scenarios
from tracking.trial import Trial, run_trial
from trackworthy.__main__ import main

SPEEDS = (30.0, 45.0, 60.0)  # [km/h]
LONGEST = {"target-vehicle-71m": (96.0, 100.5, 105.0), "target-vehicle-640m": (606.0, 606.0, 606.0)}  # [m] promised
TRUCK = Rectangle(7.0, 2.5, 2.25)
WALL = scenario(polygons=[box(55.0, 20.0, 4.0, 40.0)], unit=1.0)  # round which it is 20 m either way
OPEN = scenario(start=(30.0, 40.0), goal=(90.0, 40.0), unit=5.0)


def planner(kmh, **more):
    return make_planner("astar-arc", {"speed": f"{kmh:g}km/h", **more})


def planned(found, kmh, **more):
    return plan_with(planner(kmh, **more), found, 0)


def dense(path):
    """Poses (N, 3) every 0.2 m of a path; within its legs the heading turns from one point's to the next one's."""
    s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path.xy, axis=0).T))])
    east, north = np.gradient(path.xy, axis=0).T
    at = np.linspace(0.0, s[-1], math.ceil(s[-1] / 0.2))
    return np.column_stack([np.interp(at, s, v) for v in (*path.xy.T, np.unwrap(np.arctan2(north, east)))])


def curvatures(path):
    """Heading change over the mean of two legs (N - 2,) [1/m]."""
    legs = np.hypot(*np.diff(path.xy, axis=0).T)
    return path.turns / (0.5 * (legs[1:] + legs[:-1]))


def heading(path, end):
    """The first or last leg's [deg]."""
    leg = path.xy[1] - path.xy[0] if end == 0 else path.xy[-1] - path.xy[-2]
    return math.degrees(math.atan2(leg[1], leg[0]))


def apart(one, other):
    """Between two headings [deg]."""
    return abs((one - other + 180.0) % 360.0 - 180.0)


@pytest.fixture(scope="module", params=list(LONGEST))
def ours(request):
    """One of our maps, how long the paths on it may be, and the plans for all speeds."""
    found = load_scenario(request.param)
    return found, LONGEST[request.param], [planned(found, kmh) for kmh in SPEEDS]


def test_on_our_maps_arcs_and_smooth_paths_are_as_short_as_promised(ours):
    """Of a plain lattice search (rear axle, three discs): 94.0 / 98.3 / 102.9 and 600.4 / 600.5 / 600.8 m."""
    for plan, longest in zip(ours[2], ours[1], strict=True):
        assert [stage.name for stage in plan.stages] == ["arcs", "smooth"]
        assert plan.notes == ()
        for stage in plan.stages:
            assert stage.paths[0].length <= longest


def test_on_our_maps_the_body_is_clear_all_along(ours):
    for plan in ours[2]:
        for stage in plan.stages:
            assert clearance(ours[0].map, dense(stage.paths[0]), TRUCK).min() >= 0.0


def test_on_our_maps_half_a_g_is_never_exceeded_nor_15_deg_a_second_of_the_wheels(ours):
    for kmh, plan in zip(SPEEDS, ours[2], strict=True):
        speed = kmh / 3.6
        bends = curvatures(plan.paths[0])
        assert np.abs(bends).max() * speed**2 <= 0.5 * STANDARD_GRAVITY * 1.002
        legs = np.hypot(*np.diff(plan.paths[0].xy, axis=0).T)[1:-1]
        change = math.radians(15.0) / (4.5 * speed)
        assert np.abs(np.diff(bends) / legs).max() <= 1.002 * change
        # It begins straight, as a truck does
        assert abs(bends[0]) <= 1.01 * change * legs[0]


@pytest.mark.parametrize("name", list(LONGEST))
@pytest.mark.parametrize("kmh", SPEEDS)
def test_a_truck_drives_them(ours, name, kmh):
    found, _, plans = ours
    if found.name != name:
        pytest.skip("of the other map")
    trial = Trial(
        name="driven", path=plans[SPEEDS.index(kmh)].paths[0], vehicle="truck", speed=kmh / 3.6, obstacles=found.map,
        require=("cross_track_p95 <= 0.2", "lateral_acceleration_demanded <= 5.884", "incursion_count <= 0"),
    )  # fmt: skip
    outcome = run_trial(trial)
    assert outcome.verdict.verdict == "trackworthy", outcome.verdict


@pytest.mark.parametrize("kmh", SPEEDS)
def test_the_search_goes_back_where_greedy_descent_is_trapped(kmh):
    greedy = plan_with(make_planner("astar-arc-paper", {"speed": f"{kmh:g}km/h"}), WALL, 0)
    assert greedy.outcome == NOT_FOUND
    plan = planned(WALL, kmh)
    assert clearance(WALL.map, dense(plan.paths[0]), TRUCK).min() >= 0.0
    assert plan.paths[0].length < 1.3 * 110.0


@pytest.mark.parametrize(("start", "goal"), [(0.0, 0.0), (180.0, 0.0), (90.0, -90.0), (0.0, 180.0), (-135.0, 60.0)])
@pytest.mark.parametrize("kmh", [30.0, 60.0])
def test_headings_that_are_given_are_kept(kmh, start, goal):
    """Arcs have the start's and the goal's; the smooth path has them at its ends, and a leg later half a turn of it."""
    plan = planned(OPEN, kmh, start_heading=start, goal_heading=goal)
    tightest = 0.6 * STANDARD_GRAVITY / (kmh / 3.6) ** 2
    for stage in plan.stages:
        path = stage.paths[0]
        leg = max(np.hypot(*(path.xy[1] - path.xy[0])), np.hypot(*(path.xy[-1] - path.xy[-2])))
        off = 1.01 * math.degrees(0.5 * leg * tightest)
        assert apart(heading(path, 0), start) <= off + 1e-6
        assert apart(heading(path, 1), goal) <= off + 1e-6
    assert plan.paths[0].length >= 300.0


def test_a_start_that_points_away_makes_half_a_turn():
    """0.6 g at 60 km/h are 47.2 m: with the goal far ahead, half a circle and a line."""
    path = planned(OPEN, 60.0, start_heading=180.0).stages[0].paths[0]
    radius = (60.0 / 3.6) ** 2 / (0.6 * STANDARD_GRAVITY)
    shortest = math.pi * radius + 300.0
    assert shortest - 2.0 * radius < path.length
    assert path.length < 1.02 * shortest
