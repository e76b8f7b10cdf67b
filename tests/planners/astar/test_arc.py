import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planners.all_planners import make_planner, plan_with
from planners.astar.arc import AstarArc
from planners.astar.home_kernels import way_to_point
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
    turns = np.diff(np.arctan2(*np.diff(path.xy, axis=0).T[::-1]))
    return ((turns + math.pi) % (2.0 * math.pi) - math.pi) / (0.5 * (legs[1:] + legs[:-1]))


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
        legs = np.hypot(*np.diff(plan.paths[0].xy, axis=0).T)
        change = math.radians(15.0) / (4.5 * speed)
        assert np.abs(np.diff(bends) / legs[1:-1]).max() <= 1.002 * change
        # It begins straight, as a truck does
        assert abs(bends[0]) <= 1.002 * change * legs[0]


@pytest.mark.parametrize("kmh", SPEEDS)
def test_a_truck_drives_them(ours, kmh):
    found, _, plans = ours
    trial = Trial(
        name="driven", path=plans[SPEEDS.index(kmh)].paths[0], vehicle="truck", speed=kmh / 3.6, obstacles=found.map,
        require=("cross_track_p95 <= 0.2", "lateral_acceleration_demanded <= 5.884", "incursion_count <= 0"),
    )  # fmt: skip
    outcome = run_trial(trial)
    assert outcome.verdict.trackworthy, outcome.verdict


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
    shortest = way_to_point(-300.0, 0.0, (60.0 / 3.6) ** 2 / (0.6 * STANDARD_GRAVITY))
    assert shortest <= path.length < 1.015 * shortest


@pytest.mark.parametrize("kmh", [3.0, 8.0])
def test_at_walking_speed_it_turns_too(kmh):
    """There the wheels take longer than a step for a third of their angle."""
    found = scenario(polygons=[box(60.0, 0.0, 3.0, 45.0)], start=(50.0, 20.0), goal=(75.0, 20.0), unit=1.0)
    plan = planned(found, kmh)
    assert 2.0 * math.hypot(10.0, 25.0) < plan.paths[0].length < 80.0
    assert clearance(found.map, dense(plan.paths[0]), TRUCK).min() >= 0.0


def corridor(width):
    """A straight one of that width [m]."""
    walls = [box(0.0, 0.0, 120.0, 40.0 - 0.5 * width), box(0.0, 40.0 + 0.5 * width, 120.0, 40.0 - 0.5 * width)]
    return scenario(polygons=walls, start=(5.0, 40.0), goal=(110.0, 40.0), unit=1.0)


def test_a_straight_corridor_with_less_than_the_margin_says_so():
    plan = planned(corridor(3.2), 30.0)
    assert plan.outcome in (NO_PATH, NOT_FOUND)
    bare = planned(corridor(3.2), 30.0, margin=0.0)
    assert clearance(corridor(3.2).map, dense(bare.paths[0]), TRUCK).min() >= 0.0


def hairpin(radius, width):
    """A lane of that width [m] that comes from the west and goes back there by half a circle of `radius` [m]."""
    angles = np.linspace(0.5 * math.pi, -0.5 * math.pi, 181)
    arc = np.column_stack([np.cos(angles), np.sin(angles)])
    inner = (60.0, 40.0) + (radius - 0.5 * width) * arc
    outer = (60.0, 40.0) + (radius + 0.5 * width) * arc
    walls = [
        [(0.0, inner[0, 1]), *inner.tolist(), (0.0, inner[-1, 1])],
        [
            (0.0, outer[0, 1]),
            *outer.tolist(),
            (0.0, outer[-1, 1]),
            (0.0, 0.0),
            (120.0, 0.0),
            (120.0, 80.0),
            (0.0, 80.0),
        ],
    ]
    return scenario(polygons=walls, start=(10.0, 40.0 + radius), goal=(10.0, 40.0 - radius), unit=1.0)


def test_where_half_a_g_is_too_little_the_arcs_are_left_as_they_are():
    """At 45 km/h 0.6 g are 26.6 m and 0.5 g are 31.9 m, and the lane is of 28.5 m."""
    lane = hairpin(28.5, 5.0)
    plan = planned(lane, 45.0)
    assert [stage.name for stage in plan.stages] == ["arcs"]
    assert "no path near the arcs keeps to 0.5 g" in plan.notes[0]
    assert plan.paths[0] is plan.stages[0].paths[0]
    assert clearance(lane.map, dense(plan.paths[0]), TRUCK).min() >= 0.0
    # Of points half a metre apart on them; where two arcs meet, the legs differ
    assert plan.smallest_radius == pytest.approx((45.0 / 3.6) ** 2 / (0.6 * STANDARD_GRAVITY), rel=5e-4)
    wide = planned(hairpin(33.0, 5.0), 45.0)
    assert [stage.name for stage in wide.stages] == ["arcs", "smooth"]


def test_where_no_smooth_path_is_near_the_arcs_others_are_searched():
    """At 0.6 g an S-bend is sharper than any at 0.5 g that leads to the same pose."""
    field = scenario(start=(10.0, 40.0), goal=(110.0, 40.0), unit=2.5)
    plan = planned(field, 60.0, start_heading=0.0, goal_heading=60.0)
    assert ([stage.name for stage in plan.stages], plan.notes) == (["arcs", "smooth"], ())
    assert np.abs(curvatures(plan.paths[0])).max() <= 1.001 * 0.5 * STANDARD_GRAVITY / (60.0 / 3.6) ** 2


def test_a_pocket_too_narrow_to_turn_in_gives_nothing():
    """It opens behind, and its walls are 6 m apart; the goal lies beyond, and is free."""
    walls = [box(50.0, 36.0, 30.0, 1.0), box(50.0, 43.0, 30.0, 1.0), box(80.0, 36.0, 1.0, 8.0)]
    pocket = scenario(polygons=walls, start=(65.0, 40.0), goal=(110.0, 40.0), unit=1.0)
    plan = planned(pocket, 30.0, start_heading=0.0)
    assert plan.outcome == NOT_FOUND
    assert "no pose that can be reached leads on" in plan.reason
    assert planned(pocket, 30.0, start_heading=180.0).paths


def test_a_wall_allows_no_path():
    walled = scenario(polygons=[box(55.0, 0.0, 4.0, 80.0)], unit=1.0)
    plan = planned(walled, 30.0)
    assert (plan.outcome, plan.paths) == (NO_PATH, ())
    assert "no way 2.5 m wide" in plan.reason


def test_most_bounds_the_search():
    plan = planned(WALL, 30.0, most=20)
    assert (plan.outcome, plan.paths) == (NOT_FOUND, ())
    assert "20 poses were looked at, the `most`" in plan.reason


@pytest.mark.parametrize("name", ["start", "goal"])
def test_where_the_body_does_not_fit_the_reason_says_so(name):
    """A pit of 5 m square with a screen before its door: the axle is free in it, and has a way out, but not 7 m."""
    walls = [box(57.0, 43.0, 6.0, 0.5), box(57.0, 36.5, 6.0, 0.5), box(57.0, 36.5, 0.5, 7.0), box(67.0, 36.5, 0.5, 7.0)]
    pit = scenario(polygons=walls, **{name: (60.0, 40.0)}, unit=1.0)
    plan = planned(scenario(polygons=[*walls, box(62.5, 36.5, 0.5, 1.6), box(62.5, 41.9, 0.5, 1.6)],
                            **{name: (60.0, 40.0)}, unit=1.0), 30.0)  # fmt: skip
    assert plan.outcome == NOT_FOUND
    assert f"does not fit at the {name} at any heading" in plan.reason
    across = planned(pit, 30.0, **{f"{name}_heading": 90.0})
    assert f"does not fit at the {name} at the heading given" in across.reason


@pytest.mark.parametrize(
    ("setting", "what"),
    [
        ("speed='fast'", "speed"),
        ("speed=-3.0", "speed"),
        ("margin=-0.1", "margin"),
        ("goal_heading=nan", "goal_heading"),
        ("start_heading=361.0", "start_heading"),
        ("most=0", "most"),
        ("cell=0.0", "cell"),
        ("width=nan", "width"),
        ("steering_limit=90.0", "steering_limit"),
    ],
)
def test_bad_settings_are_one_line_and_exit_code_2(capsys, setting, what):
    code = main(["plan", "target-vehicle-71m", "--planner", "astar-arc", "--set", setting])
    shown = capsys.readouterr()
    assert code == 2
    assert shown.out == ""
    assert what in shown.err
    assert shown.err.count("\n") == 1


def test_clearance_is_that_of_the_reference_point_which_is_in_the_body():
    assert AstarArc().clearance == 1.25
    assert AstarArc(overhang=0.5).clearance == 0.5
    assert AstarArc(overhang=6.5).clearance == 0.5
    with pytest.raises(InputError, match=r"overhang: 9 m are longer than the body of 7 m"):
        AstarArc(overhang=9.0)


def test_an_arrival_straight_ahead_is_looked_at_like_any_other():
    """At 36 km/h steps are 5 m, and nodes straight ahead lie on the goal to the bit; a post is in the way."""
    post = scenario(circles=[(22.0, 40.0, 0.2)], start=(10.0, 40.0), goal=(30.0, 40.0), unit=1.0)
    plan = planned(post, 36.0)
    assert clearance(post.map, dense(plan.paths[0]), TRUCK).min() >= 0.0
    east = planned(
        scenario(start=(10.0, 40.0), goal=(60.0, 40.0), unit=1.0), 36.0, start_heading=0.0, goal_heading=90.0
    )
    assert east.paths[0].length > 50.0
    assert apart(heading(east.paths[0], 1), 90.0) < 3.0


def test_every_run_gives_the_same_bytes(ours):
    again = planned(ours[0], SPEEDS[0])
    assert again.paths[0].points.tobytes() == ours[2][0].paths[0].points.tobytes()


def test_a_longer_way_than_the_range_is_no_plan():
    plan = planned(dataclasses.replace(WALL, max_range=112.0), 30.0)
    assert (plan.outcome, plan.paths) == (NOT_FOUND, ())
    assert "exceed the range of 112 m" in plan.reason


def test_a_mirrored_map_has_the_mirrored_path_but_for_the_order_of_equals():
    """Heading cells are symmetric about east; where two ways are as long, the first found counts."""
    posts = [(40.0, 38.0, 6.0), (75.0, 46.0, 7.0)]
    one = planned(scenario(circles=posts, unit=1.0), 45.0).paths[0]
    other = planned(scenario(circles=[(x, 80.0 - y, r) for x, y, r in posts], unit=1.0), 45.0).paths[0]
    assert other.length == pytest.approx(one.length, rel=2e-3)


def yard(found):
    """One of the contract tests' maps, with 2.5 m a map unit: 300 by 200 m."""
    rings = [ring / found.unit for ring in found.map.polygons]
    circles = [
        (circle.x / found.unit, circle.y / found.unit, circle.radius / found.unit) for circle in found.map.circles
    ]
    ends = {"start": found.starts[0] / found.unit, "goal": found.goals[0] / found.unit}
    return scenario(polygons=rings, circles=circles, **ends, unit=2.5)


@settings(max_examples=25)
@given(found=scenarios.map(yard), kmh=st.sampled_from(SPEEDS))
def test_on_any_yard_the_body_is_clear_and_the_curvature_bounded(found, kmh):
    try:
        plan = planned(found, kmh, most=20_000)
    except InputError:
        return  # its start or its goal is not free
    for stage in plan.stages:
        assert clearance(found.map, dense(stage.paths[0]), TRUCK).min() >= -1e-3
    if plan.paths:
        limit = (0.5 if len(plan.stages) == 2 else 0.6) * STANDARD_GRAVITY / (kmh / 3.6) ** 2
        assert np.abs(curvatures(plan.paths[0])).max(initial=0.0) <= 1.3 * limit
        if len(plan.stages) == 2:
            assert np.abs(curvatures(plan.paths[0])).max(initial=0.0) <= 1.002 * limit
