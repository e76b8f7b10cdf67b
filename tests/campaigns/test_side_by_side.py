"""Two campaigns side by side: what belongs together, what was set otherwise, what came of it."""

from pathlib import Path

import pytest

from campaigns.campaign import Campaign
from campaigns.conditions import ConditionKeys
from campaigns.difference import BETTER, MIXED, SAME, WORSE
from campaigns.manifest import Manifest
from campaigns.matching import matched
from campaigns.side_by_side import Change, Side, changes_of, side_by_side
from sample_results import made_result

ONE = {"cross_track_p95": [1.0]}


def side(*results, seed=1, revision="abc", folder="a"):
    cases = tuple(result.case for result in results)
    manifest = Manifest("x", 1, 1, "", "", {"numpy": "2.0"}, revision, "here", seed, {})
    return Side(Path(folder), Campaign("x", "x", cases, (), Path(folder), "x", seed), manifest, list(results))


def numbered(results):
    """Results with names and the numbers of their places."""
    return [made_result(ONE, number=i, **case) for i, case in enumerate(results, start=1)]


def names(pairs):
    return [(a.case.name, b.case.name) for a, b in pairs]


def test_names_come_first_and_settings_next():
    a = numbered([{"name": "same", "speed": 10.0}, {"name": "old", "speed": 20.0}])
    b = numbered([{"name": "new", "speed": "72km/h"}, {"name": "same", "speed": 30.0}])
    assert names(matched(a, b)) == [("same", "same"), ("old", "new")]
    assert names(matched(a, b, "name")) == [("same", "same")]


def test_by_setting_names_say_nothing():
    a = numbered([{"name": "one", "speed": 10.0}, {"name": "two", "speed": 20.0}])
    b = numbered([{"name": "one", "speed": 20.0}, {"name": "two", "speed": 10.0}])
    assert names(matched(a, b, "setting")) == [("one", "two"), ("two", "one")]


@pytest.mark.parametrize(
    ("was", "now"),
    [
        ({"controller": "lqr"}, {"controller": "stanley"}),
        ({"vehicle": "truck", "corridor": 0.5}, {"vehicle": "c172x", "corridor": 30.0}),
        ({"speed": 10.0}, {"speed": 11.0}),
        ({"conditions": ConditionKeys()}, {"conditions": ConditionKeys(friction=0.5)}),
        ({"path": "", "scenario": "y", "planner": "vd"}, {"path": "", "scenario": "y", "planner": "vdp"}),
    ],
)
def test_cases_that_differ_in_one_dimension_belong_together(was, now):
    a, b = numbered([{"name": "a", **was}]), numbered([{"name": "b", **now}])
    assert names(matched(a, b)) == [("a", "b")]


def test_what_differs_in_two_dimensions_or_is_ambiguous_does_not():
    a = numbered([{"name": "a", "speed": 10.0, "controller": "lqr"}])
    assert matched(a, numbered([{"name": "b", "speed": 20.0, "controller": "l1"}])) == []
    two = numbered([{"name": name, "speed": 10.0, "controller": name} for name in ("l1", "stanley")])
    assert matched(a, two) == []
    assert matched(numbered([{"name": "a", "path": "a.csv"}]), numbered([{"name": "b", "path": "b.csv"}])) == []


def case(name, error, clearance, worthy=True, **more):
    metrics = {"cross_track_p95": [error], "clearance_min": [clearance]}
    return made_result(metrics, [worthy], name=name, number=ord(name), **more)


A = side(case("a", 1.0, 5.0), case("b", 1.0, 5.0), case("c", 1.0, 5.0), case("d", 1.0, 5.0), case("e", 1.0, 5.0))
B = side(
    case("d", 1.0, 5.0, False), case("c", 2.0, 6.0), case("b", 0.5, 5.0), case("a", 1.0, 5.0, controller="l1"),
    case("f", 3.0, 5.0, speed=9.0), seed=2, revision="def",
)  # fmt: skip


def test_each_pair_comes_to_one_word_and_what_differs_most_is_first():
    found = side_by_side(A, B)
    assert [(pair.name, pair.outcome) for pair in found.pairs] == [
        ("d", WORSE), ("e → f", WORSE), ("c", MIXED), ("b", BETTER), ("a", SAME),
    ]  # fmt: skip
    assert [found.count(outcome) for outcome in (BETTER, WORSE, MIXED, SAME)] == [1, 2, 1, 1]
    assert found.verdicts_changed == 1
    assert (found.only_a, found.only_b) == ((), ())
    assert side_by_side(A, B, "name").only_a == ("e",)
    assert side_by_side(A, B, "name").only_b == ("f",)


def test_what_was_set_otherwise_is_told():
    found = side_by_side(A, B)
    changes = {pair.name: pair.changes for pair in found.pairs}
    assert changes["a"] == (Change("controller", "lqr", "l1"),)
    assert changes["e → f"] == (Change("speed", None, 9.0),)
    assert changes["b"] == ()
    assert set(found.made) == {Change("seed", 1, 2), Change("git revision", "abc", "def")}
    assert [count for _, count in changes_of(found.pairs)] == [1, 1]


def test_an_input_of_another_content_is_told(tmp_path):
    sides = []
    for i, content in enumerate(("x,y\n0,0\n9,0\n", "x,y\n0,0\n8,0\n")):
        folder = tmp_path / f"{i}"
        folder.mkdir()
        (folder / "road.csv").write_text(content)
        sides.append(side(case("a", 1.0, 5.0), folder=folder))
    (pair,) = side_by_side(*sides).pairs
    assert [change.key for change in pair.changes] == ["path content"]
    assert side_by_side(sides[0], sides[0]).pairs[0].changes == ()


def test_b_against_a_is_the_negative_of_a_against_b():
    there, back = side_by_side(A, B), side_by_side(B, A)
    changes = [
        {(pair.name, one.metric): sign * one.change for pair in found.pairs for one in pair.differences}
        for found, sign in ((there, 1.0), (back, -1.0))
    ]
    changes[1] = {(name.replace("f → e", "e → f"), metric): value for (name, metric), value in changes[1].items()}
    assert changes[0] == changes[1]
    assert (there.count(BETTER), there.count(WORSE)) == (back.count(WORSE), back.count(BETTER))


def test_a_campaign_against_itself_is_all_the_same():
    found = side_by_side(B, B)
    assert {pair.outcome for pair in found.pairs} == {SAME}
    assert (found.verdicts_changed, found.made, found.only_a, found.only_b) == (0, (), (), ())
    assert all(not pair.changes for pair in found.pairs)
