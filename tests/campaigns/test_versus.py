"""Cases that differ in one thing only are found, and held against the best of them."""

import math

import numpy as np
import pytest

from campaigns.conditions import ConditionKeys
from campaigns.difference import BETTER, CHANCE, SAME, SMALL, WORSE
from campaigns.limits import Limit
from campaigns.versus import TRACKWORTHY_SHARE, versus_groups
from sample_results import made_result, unplanned

ONE = {"cross_track_p95": [1.0]}


def groups(*results, limits=None):
    return versus_groups(results, limits or {})


def told(found):
    return [(group.dimension, [member.label for member in group.members]) for group in found]


def test_a_group_a_speed():
    cases = [made_result(ONE, controller=name, speed=speed) for speed in (10.0, 20.0) for name in ("lqr", "l1")]
    assert told(groups(*cases)) == [("controller", ["lqr", "l1"])] * 2


def test_what_differs_in_two_things_is_no_group():
    assert groups(made_result(ONE, controller="lqr", speed=10.0), made_result(ONE, controller="l1", speed=20.0)) == []
    assert groups(made_result(ONE), made_result(ONE, conditions=ConditionKeys(friction=0.5), controller="l1")) == []
    assert groups(made_result(ONE), made_result(ONE)) == []


def test_speeds_and_winds_are_the_same_however_they_are_written():
    a = made_result(ONE, controller="lqr", speed="36km/h", conditions=ConditionKeys(wind="0@270"))
    b = made_result(ONE, controller="l1", speed=10.0)
    assert told(groups(a, b)) == [("controller", ["lqr", "l1"])]


def test_paths_and_planners_meet_on_a_scenario_only():
    a, b = made_result(ONE, path="a.csv"), made_result(ONE, path="b.csv")
    assert groups(a, b) == []
    a, b = (made_result(ONE, path=name, scenario="yard.toml") for name in ("inputs/1/a.csv", "inputs/2/b.csv"))
    c = made_result(ONE, path="", planner="astar-eight", set={"clearance": 1.0}, scenario="yard.toml")
    assert told(groups(a, b, c)) == [("planner", ["a.csv", "b.csv", "astar-eight"])]


def test_vehicles_bring_their_own_speeds():
    a, b = made_result(ONE, vehicle="truck", speed=10.0, corridor=0.5), made_result(ONE, vehicle="c172x", speed=55.0)
    assert told(groups(a, b)) == [("vehicle", ["truck", "c172x"])]


def test_two_of_the_same_planner_are_called_by_their_cases():
    a, b, c = (
        made_result(ONE, path="", scenario="y", planner=planner, set={"clearance": clearance}, name=name)
        for name, planner, clearance in (("near", "vd", 1.0), ("far", "vd", 9.0), ("other", "vdp", 1.0))
    )
    assert told(groups(a, b, c)) == [("planner", ["near", "far", "vdp"])]


def test_the_reference_is_the_most_trackworthy_then_the_closest():
    worse = made_result({"cross_track_p95": [1.0, 1.0]}, [True, False], controller="a")
    far = made_result({"cross_track_p95": [3.0, 3.0]}, controller="b")
    near = made_result({"cross_track_p95": [2.0, 2.0]}, controller="c")
    (group,) = groups(worse, far, near)
    assert group.members[group.reference].label == "c"
    assert group.members[group.reference].differences == {}
    differences = group.members[0].differences
    assert (differences["cross_track_p95"].change, differences["cross_track_p95"].outcome) == (-1.0, BETTER)
    assert (differences[TRACKWORTHY_SHARE].change, differences[TRACKWORTHY_SHARE].outcome) == (-0.5, CHANCE)


def test_other_requirements_make_verdicts_incomparable():
    strict = made_result({"cross_track_p95": [1.0]}, [False], controller="a", require=("cross_track_p95<=0.1",))
    loose = made_result({"cross_track_p95": [2.0]}, [True], controller="b")
    (group,) = groups(strict, loose)
    assert (group.alike, group.metrics) == (False, ("cross_track_p95",))
    assert group.members[group.reference].label == "a"
    (group,) = groups(made_result({"cross_track_p95": [1.0]}, [False], controller="a"), loose)
    assert (group.alike, group.members[group.reference].label) == (True, "b")


def test_limits_of_angles_are_in_degrees():
    cases = [made_result({"bank_max": [math.radians(bank)]}, controller=f"{bank}") for bank in (2.0, 2.4, 3.0)]
    (group,) = groups(*cases)
    assert [m.differences["bank_max"].outcome for m in group.members[1:]] == [SMALL, WORSE]
    (group,) = groups(*cases, limits={"bank_max": Limit(2.0)})
    assert [m.differences["bank_max"].outcome for m in group.members[1:]] == [SMALL, SMALL]


def test_differences_are_over_the_same_weather():
    weather = np.random.default_rng(2).normal(5.0, 3.0, 30)
    a = made_result({"cross_track_p95": weather}, controller="a")
    b = made_result({"cross_track_p95": weather[::-1] + 0.7}, seeds=range(30, 0, -1), controller="b")
    (group,) = groups(a, b)
    found = group.members[1].differences["cross_track_p95"]
    assert found.pairs == 30
    assert found.interval == pytest.approx((0.7, 0.7))
    assert found.outcome == WORSE


def test_spreads_are_medians_with_nine_trials_of_ten():
    (group,) = groups(made_result({"cross_track_p95": range(101)}), made_result(ONE, controller="b"))
    spread = group.members[0].spreads["cross_track_p95"]
    assert (spread.p5, spread.median, spread.p95, spread.count) == (5.0, 50.0, 95.0, 101)


def test_what_could_not_be_measured_is_not_compared():
    a = made_result({"cross_track_p95": [1.0, 2.0], "clearance_min": [None, None]}, controller="a")
    b = made_result({"cross_track_p95": [1.0, None], "clearance_min": [1.0, 2.0]}, controller="b")
    (group,) = groups(a, b)
    assert group.metrics == (TRACKWORTHY_SHARE, "cross_track_p95")
    (other,) = (m for i, m in enumerate(group.members) if i != group.reference)
    assert other.differences["cross_track_p95"].pairs == 1
    assert other.differences["cross_track_p95"].outcome == SAME


def test_what_had_no_path_is_not_compared():
    lost = [unplanned(name, planner=name) for name in ("exact", "astar-eight")]
    assert groups(*lost) == []
    found = made_result(ONE, scenario="slalom-1000x600", planner="aco-improved", path="")
    assert [len(group.members) for group in groups(*lost, found)] == [3]
