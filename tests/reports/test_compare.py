"""Two campaigns side by side, in the words of each format."""

import json
import math
from io import StringIO
from pathlib import Path

import pytest
from rich.console import Console

from campaigns.campaign import Campaign
from campaigns.manifest import Manifest
from campaigns.side_by_side import Side, side_by_side
from planners.outside import OutsidePlanner
from reports.files.compare_json import side_by_side_json
from reports.files.compare_markdown import side_by_side_markdown
from reports.terminal.compare_text import print_side_by_side
from reports.words.compare_words import conclusion, heads
from sample_results import made_result


def side(folder, *results):
    manifest = Manifest("x", 1, 1, "", "", {}, "", "here", 1, {})
    cases = tuple(result.case for result in results)
    return Side(Path(folder), Campaign("x", "x", cases, (), Path(folder), "x", 1), manifest, list(results))


def shown(found, width=80):
    console = Console(file=StringIO(), width=width, highlight=False)
    print_side_by_side(found, console)
    return console.file.getvalue()


def banked(*degrees, **more):
    return made_result({"bank_max": [math.radians(bank) for bank in degrees]}, **more)


def test_angles_are_in_degrees_and_shares_in_per_cent():
    found = side_by_side(side("a", banked(10.0)), side("b", banked(25.0, worthy=[False])))
    (pair,) = json.loads(side_by_side_json(found))["pairs"]
    bank = next(one for one in pair["differences"] if one["metric"] == "bank_max")
    assert (bank["unit"], bank["a"], bank["b"], bank["change"]) == ("deg", *map(pytest.approx, (10.0, 25.0, 15.0)))
    assert bank["limit"] == pytest.approx(1.25)  # 5 % of the larger
    lines = shown(found).splitlines()
    assert [line.split() for line in lines if line.startswith("bank_max")] == [
        ["bank_max", "10", "25", "+15", "°", "worse"]
    ]
    assert [line.split() for line in lines if line.startswith("trackworthy ")] == [
        ["trackworthy", "100", "0", "−100", "%", "worse"]
    ]
    assert "verdict: trackworthy → not-trackworthy" in lines


def test_what_has_no_direction_is_more_or_less():
    pair = [side(name, made_result({"track_length": [length]})) for name, length in (("a", 100.0), ("b", 110.0))]
    assert "more\n" in shown(side_by_side(*pair))
    assert "less\n" in shown(side_by_side(*reversed(pair)))
    assert conclusion(side_by_side(*pair)) == "B: 0 better, 0 worse, 1 the same; 0 verdicts changed"


@pytest.mark.parametrize("width", [80, 120])
def test_large_numbers_fit(width):
    weather = [903_412.5 + 1000.0 * i for i in range(8)]
    metrics = {"track_length": weather, "cross_track_max": [0.5 * one for one in weather]}
    less = {name: [0.5 * one for one in values] for name, values in metrics.items()}
    text = shown(side_by_side(side("a", made_result(metrics)), side("b", made_result(less))), width)
    table = [line for line in text.splitlines() if line.startswith(("metric", "──", "track_length ", "cross_track"))]
    assert len(table) == 4
    assert max(map(len, table)) <= 80


def test_trials_that_failed_to_run_are_counted():
    good, broken = made_result({"completion": [1.0]}), made_result({"completion": [1.0, 1.0]}, errors=2)
    found = side_by_side(side("a", good), side("b", broken))
    assert "trials of B that failed to run: 2" in shown(found).splitlines()
    assert "verdict: trackworthy → error" in shown(found).splitlines()
    assert found.pairs[0].differences == ()
    assert "verdict: trackworthy → error" in side_by_side_markdown(found)
    json.loads(side_by_side_json(found))


def test_planners_of_others_are_told_by_their_keys():
    one, two = (
        made_result({"completion": [1.0]}, path="", scenario="y", planner=OutsidePlanner(python=f"mine:{name}"))
        for name in ("first", "second")
    )
    assert heads(side_by_side(side("a", one), side("b", two)))[2:] == [
        "set in every case: planner.python mine:first → mine:second"
    ]


def test_many_names_are_counted():
    many = [made_result({"completion": [1.0]}, number=i, name=f"n{i}", speed=float(i)) for i in range(1, 12)]
    found = side_by_side(side("a", many[0]), side("b", *many))
    assert heads(found)[-1] == "only in B: n2; n3; n4; n5; n6; n7; n8; n9 and 2 more"
    assert conclusion(found).endswith("; 10 cases only in B")
