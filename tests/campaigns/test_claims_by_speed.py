"""Claims on plans for one speed stand by these, with what became of them when they were driven."""

import json
import math

import pytest

from campaigns.campaign import load_campaign
from campaigns.claims import Claim
from planners.all_planners import ALL_PLANNERS
from planners.errors import InputError
from planners.units import STANDARD_GRAVITY
from reports.pages.plan_driven import driven
from reports.pages.plan_rows import labels, plan_row
from sample_planner import LATERAL, SCENARIO, SpeedArc
from small_campaigns import InThisProcess, run_here, write_campaign

CASE = """
[[case]]
name = "bend"
scenario = "bend.toml"
planner = "speed-arc"
vehicle = "truck"
speed = ["30km/h", "36km/h"]
expect = "either"
"""
STRICT = CASE.replace('"bend"\n', '"strict"\n', 1) + 'require = ["lateral_acceleration_max<=1"]\n'
CLAIMS = "".join(
    f"""
[[claim]]
planner = "speed-arc"
source = "paper at {speed}"
speed = "{speed}"
length = {length}
straight = 60.0
"""
    for speed, length in (("30km/h", 90.0), ("36km/h", 93.0))
)
STRAIGHT = 50.0 * 2.0**0.5  # [m] from start to goal


@pytest.fixture(autouse=True)
def _planner(tmp_path, monkeypatch):
    monkeypatch.setattr("planners.all_planners.ALL_PLANNERS", (*ALL_PLANNERS, SpeedArc))
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))
    (tmp_path / "bend.toml").write_text(SCENARIO)


def test_a_claim_stands_by_the_plans_for_its_speed_and_these_by_their_verdicts(tmp_path):
    finished = run_here(write_campaign(tmp_path, CASE + STRICT + CLAIMS), tmp_path / "out")
    slow, fast = finished.plans
    assert [[claim.source for claim in one.claims] for one in (slow, fast)] == [
        ["paper at 30km/h"],
        ["paper at 36km/h"],
    ]
    assert (slow.cases, fast.cases) == (("bend 30km/h", "strict 30km/h"), ("bend 36km/h", "strict 36km/h"))
    assert labels(finished.plans) == ["speed-arc, 30 km/h", "speed-arc, 36 km/h"]
    row = plan_row(fast, "speed-arc, 36 km/h", finished.results)
    assert row["about"] == ""
    assert float(row["straight"][0]) == pytest.approx(fast.statistics.length.median / STRAIGHT, abs=1e-3)
    assert [claim["straight"] for claim in row["claims"]] == ["1.55"]
    assert row["driven"] == [{"vehicle": "", "share": "1 of 2", "why": "lateral acceleration", "all": False}]
    told = json.loads((tmp_path / "out" / "summary.json").read_text())["plans"]
    assert [one["planned_for"] for one in told] == pytest.approx([30 / 3.6, 10.0])
    assert [one["driven_at"] for one in told] == [one["planned_for"] for one in told]
    assert [one["lateral_acceleration_needed"] for one in told] == pytest.approx([LATERAL] * 2, rel=1e-3)
    assert row["needs"] == {"g": "0.408", "at": "", "over": False}
    assert [one["straight_length"] for one in told] == pytest.approx([STRAIGHT] * 2)
    assert (told[1]["claims"][0]["speed"], told[1]["claims"][0]["straight"]) == ("36km/h", 60.0)


def test_plans_that_are_not_found_are_not_followed(tmp_path):
    finished = run_here(write_campaign(tmp_path, CASE + "set.most = 9\n"), tmp_path / "out")
    slow, fast = finished.plans
    assert driven(slow, finished.results) == [{"vehicle": "", "share": "1 of 1", "why": "", "all": True}]
    assert driven(fast, finished.results) == [{"vehicle": "", "share": "0 of 1", "why": "no path", "all": False}]
    assert driven(fast, []) == []
    assert (fast.driven_at, fast.needed) == (10.0, None)
    assert plan_row(fast, "speed-arc, 36 km/h")["needs"] == {"g": "", "at": "", "over": False}
    assert labels(finished.plans) == ["speed-arc, 30 km/h", "speed-arc, 36 km/h"]
    assert plan_row(slow, "speed-arc, 30 km/h")["about"] == "most = 9"


def test_trials_are_counted_by_vehicle_where_there_are_several(tmp_path):
    loose = CASE.replace('"bend"\n', '"loose"\n', 1).replace('vehicle = "truck"', 'vehicle = "truck-dynamic"')
    finished = run_here(write_campaign(tmp_path, STRICT + loose), tmp_path / "out")
    assert [one["vehicle"] for one in driven(finished.plans[1], finished.results)] == ["truck", "truck-dynamic"]
    strict, *_ = driven(finished.plans[1], finished.results)
    assert strict == {"vehicle": "truck", "share": "0 of 1", "why": "lateral acceleration", "all": False}


def test_a_plan_for_no_speed_is_judged_at_the_slowest_it_is_driven_at(tmp_path):
    """A corner of d alone needs v d / 0.5 s; as a claim of that turn does."""
    grid = CASE.replace("speed-arc", "astar-four")
    claim = '\n[[claim]]\nplanner = "astar-four"\nsource = "paper"\nturn = 90.0\n'
    (one,) = run_here(write_campaign(tmp_path, grid + claim), tmp_path / "out").plans
    worst = 30.0 / 3.6 * (math.pi / 2) / 0.5
    assert (one.planned_for, one.driven_at) == (None, pytest.approx(30.0 / 3.6))
    assert one.needed == pytest.approx(worst)
    row = plan_row(one, "astar-four")
    assert row["needs"] == row["claims"][0]["needs"] == {"g": "2.67", "at": "at 30 km/h", "over": True}


@pytest.mark.parametrize(("kmh", "turn", "g"), [(30, 36.0, 1.07), (45, 30.0, 1.33), (60, 18.0, 1.07)])
def test_what_paper_004_claims_needs_far_more_than_its_limit(kmh, turn, g):
    """Its Tables 3 and 4, beside its own 0.6 g."""
    claim = Claim(planner="astar-arc-paper", source="paper", speed=f"{kmh}km/h", turn=turn)
    assert claim.needed(1.0) / STANDARD_GRAVITY == pytest.approx(g, abs=5e-3)
    assert Claim(planner="astar-arc-paper", source="paper", speed=f"{kmh}km/h").needed(1.0) is None
    assert Claim(planner="exact", source="paper", turn=turn).needed(None) is None


def test_one_speed_may_be_written_in_several_ways_and_a_vehicles_own_is_not_known_yet(tmp_path):
    as_number = CASE.replace('["30km/h", "36km/h"]', "[8.333, 10]")
    assert len(load_campaign(str(write_campaign(tmp_path, as_number + CLAIMS))).claims) == 2
    unsaid = CASE.replace('speed = ["30km/h", "36km/h"]\n', "")
    assert len(load_campaign(str(write_campaign(tmp_path, unsaid + CLAIMS))).claims) == 2


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (('speed = "36km/h"', 'speed = "60km/h"'), "claim[1]: no case plans for 60km/h with speed-arc; use 30km/h, 36"),
        (('speed = "36km/h"', 'speed = "36mph"'), "claim[1]: speed: unknown unit 'mph' in '36mph'"),
        (("straight = 60.0", "straight = 0"), "claim[0].straight: "),
    ],
)
def test_a_wrong_claim_names_its_place(tmp_path, change, told):
    file = write_campaign(tmp_path, (CASE + CLAIMS).replace(*change))
    with pytest.raises(InputError) as error:
        load_campaign(str(file))
    assert str(error.value).startswith(f"{file}: {told}")


def test_a_claim_for_a_speed_is_about_a_planner_that_plans_for_one(tmp_path):
    file = write_campaign(tmp_path, (CASE + CLAIMS).replace('planner = "speed-arc"', 'planner = "exact"'))
    with pytest.raises(InputError, match=r"claim\[0\]: exact plans for no speed; leave speed out"):
        load_campaign(str(file))
