import dataclasses
import json
import math

import pytest

from reports.files.json_result import to_json
from reports.words.words import sentence
from tracking.feasibility import Feasibility, Turn
from tracking.verdict import Verdict


@pytest.mark.parametrize("name", ["route", "yard", "sharp_yard"])
def test_is_strict_json(name, request):
    told = to_json(request.getfixturevalue(name))
    assert json.loads(json.dumps(told, allow_nan=False)) == told


def test_says_what_decides(route):
    told = to_json(route)
    assert told["verdict"] == "not-trackworthy"
    assert told["trackworthy"] is False
    assert told["passed"] is False
    assert told["decided_by"] == "cross_track_max"
    assert told["sentence"] == sentence(route)
    assert told["wind"] == {"speed": pytest.approx(10.0), "from_deg": pytest.approx(270.0)}
    assert told["versions"]["schema"] >= 1


def test_angles_are_in_degrees(route):
    told = to_json(route)
    assert told["metrics"]["bank_max"]["unit"] == "deg"
    assert told["metrics"]["bank_max"]["value"] == pytest.approx(math.degrees(route.metrics["bank_max"].value))
    [bank] = [r for r in told["requirements"] if r["metric"] == "bank_max"]
    assert (bank["limit"], bank["unit"]) == (pytest.approx(30.0), "deg")
    assert bank["margin"] == pytest.approx(bank["limit"] - bank["value"])


def test_no_number_is_null(yard):
    metric = to_json(yard)["metrics"]["altitude_error_max"]
    assert metric["value"] is None
    assert metric["s"] is None
    assert metric["valid"] is False
    assert metric["note"] == "the path has no heights"
    assert to_json(yard)["wind"]["from_deg"] is None
    assert to_json(yard)["path"]["origin"] is None


def test_infeasible_stretches(route, steep_leg):
    offers = (900.0, 69.0, 68.0, 67.0, 900.0, 65.0)
    turns = [Turn(40.0 * i, 10.0 * i, i, math.radians(5.0), offer, 530.0) for i, offer in enumerate(offers)]
    told = to_json(dataclasses.replace(route, feasibility=Feasibility(tuple(turns), (steep_leg,))))["feasibility"]
    assert told["turns"] == 6
    first, second = told["infeasible"]
    assert first == {
        "s": 40.0, "s_end": 120.0, "x": 30.0, "y": 3.0, "turn": pytest.approx(15.0), "available": 67.0,
        "required": 530.0, "missing": 463.0,
    }  # fmt: skip
    assert (second["s"], second["s_end"]) == (200.0, 200.0)
    assert told["steep"][0]["missing"] == pytest.approx(0.04)


def test_no_requirements(route):
    assert to_json(dataclasses.replace(route, verdict=Verdict(())))["decided_by"] is None
