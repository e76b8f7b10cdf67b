"""Plans summed up by planner, and what papers claim of them."""

import json
import math

import pytest

from campaigns.campaign import load_campaign
from campaigns.plan_statistics import FAILED, Spread, statistics_of
from planners.errors import InputError
from planners.facts import PlanFacts
from planners.planner import NO_PATH, NOT_FOUND
from small_campaigns import InThisProcess, run_here, write_campaign

YARD = 'name = "yard"\nsize = [60.0, 60.0]\nunit = 0.5\nstart = [10.0, 10.0]\ngoal = [50.0, 50.0]\n'
WALL = "[[obstacle]]\npolygon = [[-1.0, 25.0], [61.0, 25.0], [61.0, 30.0], [-1.0, 30.0]]\n"
CASE = """
[[case]]
name = "one"
scenario = "yard.toml"
planner = "exact"
set = { clearance = 1.0 }
vehicle = "truck"
speed = 10
replan = true
trials = 3
[[case]]
name = "two"
scenario = "yard.toml"
planner = "exact"
vehicle = "truck"
speed = 10
"""
CLAIM = """
[[claim]]
planner = "exact"
source = "paper 0"
length = 56.6
turn = 0
iterations = 1
survivors = [1, 1]
beside = { plan = "Fig. 1" }
"""


def facts(seed, length=None, **others):
    return PlanFacts(planner="p", scenario="s", seed=seed, map_unit=2.0, length=length, **others)


def found(seed, length, turn, radius, alive, converged):
    return facts(
        seed, length, exact_length=100.0, turn_angle_max_deg=1.0, turn_angle_1_unit_deg=turn,
        turn_angle_5_units_deg=2.0 * turn, smallest_radius=radius, population=10, best=(length,) * 2,
        survivors=(0, alive), converged=converged,
    )  # fmt: skip


@pytest.fixture(autouse=True)
def _yard(tmp_path, monkeypatch):
    """With planners in this process."""
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))
    (tmp_path / "yard.toml").write_text(YARD)


def run(tmp_path, text, folder="out", head='seed = 1\nnote = "a note"'):
    file = write_campaign(tmp_path, text, head=head)
    return run_here(file, tmp_path / folder)


def test_median_and_worst_of_those_that_found_a_path():
    told = statistics_of([
        found(1, 110.0, 3.0, 50.0, 8, 1), found(2, 130.0, 9.0, 20.0, 9, 2), found(3, 120.0, 6.0, 30.0, 10, 2),
        facts(4, outcome=NOT_FOUND, population=10, survivors=(0, 0)), facts(5, outcome=NO_PATH), None,
    ])  # fmt: skip
    assert (told.seeds, told.found) == (6, 3)
    assert told.missing == {FAILED: 1, NO_PATH: 1, NOT_FOUND: 1}
    assert (told.length.median, told.length.worst) == (120.0, 130.0)
    assert (told.length_ratio.median, told.length_ratio.worst) == (1.2, 1.3)
    assert (told.turn_1_deg, told.turn_5_deg, told.smallest_radius, told.cornered) == (9.0, 18.0, 20.0, 0)
    assert (told.survivors, told.population, told.iterations, told.converged) == (8.5, 10, 2, 2)


def test_corners_have_no_radius_and_straight_lines_no_smallest_one():
    corners, straight = facts(1, 10.0, turn_angle_max_deg=90.0), facts(2, 10.0, turn_angle_max_deg=0.0)
    curved = facts(3, 10.0, turn_angle_max_deg=5.0, smallest_radius=7.0)
    endless = facts(4, 10.0, turn_angle_max_deg=0.0, smallest_radius=math.inf)
    told = statistics_of([corners, straight, curved, endless])
    assert (told.cornered, told.smallest_radius) == (1, 7.0)
    assert statistics_of([straight, endless]).smallest_radius is None


def test_nothing_found_is_nothing_told():
    told = statistics_of([facts(1, outcome=NO_PATH, exact_length=None)])
    assert (told.found, told.length, told.length_ratio, told.survivors, told.converged) == (0,) + (None,) * 4


def test_plans_are_by_planner_settings_and_scenario_and_the_claim_by_the_first(tmp_path):
    finished = run(tmp_path, CASE + CLAIM)
    first, second = finished.plans
    assert (first.planner.clearance, first.case, first.statistics.seeds, first.statistics.found) == (1.0, "one", 3, 3)
    assert (second.planner.clearance, second.case, second.statistics.seeds) == (0.0, "two", 1)
    assert first.statistics.length.worst == pytest.approx(20.0 * math.sqrt(2.0))
    assert [claim.length for claim in first.claims] == [56.6]
    assert second.claims == ()
    told = json.loads((tmp_path / "out" / "summary.json").read_text())["plans"]
    assert [one["settings"] for one in told] == [{"clearance": 1.0}, {"clearance": 0.0}]
    assert [one["scenario"] for one in told] == ["yard", "yard"]
    assert told[0]["length"]["median"] == pytest.approx(20.0 * math.sqrt(2.0))
    assert told[0]["claims"][0]["survivors"] == [1, 1]


def test_the_same_bytes_resumed_and_from_the_folder_alone(tmp_path):
    run(tmp_path, CASE + CLAIM)
    before = (tmp_path / "out" / "summary.json").read_bytes()
    run(tmp_path, CASE + CLAIM)
    assert (tmp_path / "out" / "summary.json").read_bytes() == before
    again = tmp_path / "again"
    run_here(tmp_path / "out" / "campaign.toml", again)
    assert (again / "summary.json").read_bytes() == before
    assert load_campaign(str(again / "campaign.toml")).claims == load_campaign(str(tmp_path / "small.toml")).claims
    assert load_campaign(str(again / "campaign.toml")).note == "a note"


def test_a_claim_holds_on_the_scenario_it_names(tmp_path):
    there = CLAIM.replace('source = "paper 0"', 'source = "there"\nscenario = "other"\nlongest = 60.0')
    (tmp_path / "other.toml").write_text(YARD.replace("yard", "other"))
    other = CASE.replace('name = "two"\nscenario = "yard.toml"', 'name = "two"\nscenario = "other.toml"')
    assert other != CASE
    first, second = run(tmp_path, other + CLAIM + there).plans
    assert [claim.source for claim in first.claims] == ["paper 0"]
    assert [(claim.source, claim.longest) for claim in second.claims] == [("there", 60.0)]


def test_fleets_are_summed_up_with_their_longest_path_and_their_steps():
    one = facts(1, 100.0, lengths=(60.0, 40.0), longest=60.0, turn_angle_max_deg=10.0, stages=(("a", 120.0),))
    two = facts(2, 104.0, lengths=(58.0, 46.0), longest=58.0, turn_angle_max_deg=12.0, stages=(("a", 124.0),))
    told = statistics_of([one, two, None])
    assert (told.paths, told.longest, told.turn_max_deg) == (2, Spread(59.0, 60.0), 12.0)
    assert told.stages == (("a", 122.0),)
    assert statistics_of([facts(1, 5.0, lengths=(5.0,))]).paths == 1


def test_another_claim_is_the_same_campaign(tmp_path):
    run(tmp_path, CASE + CLAIM)
    assert run(tmp_path, CASE + CLAIM.replace("56.6", "57")).plans[0].claims[0].length == 57.0


def test_a_scenario_without_a_way_is_told_so(tmp_path):
    (tmp_path / "yard.toml").write_text(YARD + WALL)
    first, _ = run(tmp_path, CASE).plans
    assert (first.statistics.found, first.statistics.missing) == (0, {NO_PATH: 3})


@pytest.mark.parametrize(
    ("claim", "told"),
    [
        (CLAIM.replace('"exact"', '"exat"'), "claim[0]: no case plans with 'exat'; did you mean 'exact'?"),
        (CLAIM + CLAIM.replace('"exact"', '"aco-basic"'), "claim[1]: no case plans with 'aco-basic'; use exact"),
        (CLAIM.replace("source", 'scenario = "yart"\nsource'), "claim[0]: no case plans on 'yart' with exact; did you"),
        (CLAIM.replace("length", "lenght"), "claim[0]: unknown key 'lenght'; did you mean 'length'?"),
        (CLAIM.replace('source = "paper 0"', ""), "claim[0]: 'source' is missing; add source = ..."),
        (CLAIM.replace("turn = 0", "turn = 181"), "claim[0].turn: "),
        (CLAIM.replace("56.6", "-1"), "claim[0].length: "),
        (CLAIM.replace("[1, 1]", "[1]"), "claim[0].survivors: "),
        (CLAIM.replace("plan =", "plot ="), "claim[0].beside: unknown key 'plot'; use plan, ants, comparison, roadmap"),
    ],
)
def test_a_wrong_claim_names_file_and_place(tmp_path, claim, told):
    file = write_campaign(tmp_path, CASE + claim)
    with pytest.raises(InputError) as error:
        load_campaign(str(file))
    assert str(error.value).startswith(f"{file}: {told}")


def test_a_claim_where_nothing_is_planned(tmp_path):
    file = write_campaign(tmp_path, '[[case]]\npath = "road.csv"\nvehicle = "truck"\n' + CLAIM)
    with pytest.raises(InputError, match="no case plans with 'exact'; add a case with that planner"):
        load_campaign(str(file))
