"""Cases whose path one of our planners gives: by name with settings, once or for each trial, and perhaps none."""

import json
from typing import ClassVar

import msgspec
import numpy as np
import pytest

from campaigns.campaign import load_campaign
from campaigns.ready import make_ready
from campaigns.resolved import write_resolved
from planners import files
from planners.all_planners import ALL_PLANNERS
from planners.errors import InputError
from planners.facts import PlanFacts
from planners.path import Path
from planners.planner import NOT_FOUND, Plan
from small_campaigns import InThisProcess, run_here, write_campaign
from trackworthy.__main__ import main

SCENARIO = 'name = "yard"\nsize = [100.0, 60.0]\nstart = [10.0, 30.0]\ngoal = [90.0, 30.0]\n'
PLANNED = """
[[case]]
name = "planned"
scenario = "yard.toml"
planner = "random"
vehicle = "truck"
speed = 8
"""
EXACT = PLANNED.replace("random", "exact")
EACH = PLANNED + "trials = 4\nreplan = true\n"
CALLS = []


class Random(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """By way of a random point up to `bend` [map units] aside; of `lose` of the seeds it finds nothing."""

    name: ClassVar[str] = "random"
    summary: ClassVar[str] = "for tests"

    bend: float = 1.0
    lose: float = 0.0
    fail: str = ""
    clearance: float = 0.0

    def plan(self, scenario, rng):
        CALLS.append(scenario.name)
        if self.fail == "input":
            raise InputError(scenario.name, "its start is in an obstacle", "move it")
        if self.fail:
            raise ZeroDivisionError("a fault of ours")
        aside, luck = rng.random(2)
        if luck < self.lose:
            return Plan(outcome=NOT_FOUND, reason="all of them lost their way")
        start, goal = scenario.starts[0], scenario.goals[0]
        middle = (start + goal) / 2 + [0.0, aside * self.bend * scenario.unit]
        return Plan(paths=(Path(np.array([start, middle, goal])),))


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("planners.all_planners.ALL_PLANNERS", (*ALL_PLANNERS, Random))
    CALLS.clear()
    (tmp_path / "yard.toml").write_text(SCENARIO)


@pytest.fixture
def here(monkeypatch):
    """Plans and trials in this process, where the planner for tests is."""
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))


@pytest.fixture
def no_report(monkeypatch):
    """Results without figures and PDF."""
    monkeypatch.setattr("reports.write.write_report", lambda *_: [])


@pytest.fixture
def campaign(tmp_path):
    """Writes a campaign of these cases; gives its file."""
    return lambda *cases: write_campaign(tmp_path, "".join(cases))


def facts(folder):
    """The facts of every plan, in the order of their keys."""
    return [
        msgspec.json.decode(file.read_bytes(), type=PlanFacts) for file in sorted((folder / "plans").glob("*.json"))
    ]


def summary(folder):
    return {case["name"]: case for case in json.loads((folder / "summary.json").read_text())["cases"]}


# By name, with settings


def test_two_problems_of_one_movingai_file_are_two_cases(tmp_path):
    (tmp_path / "hall.map").write_text("type octile\nheight 20\nwidth 20\nmap\n" + 20 * (20 * "." + "\n"))
    lines = [f"0\thall.map\t20\t20\t2\t2\t{x}\t10\t16.0\n" for x in (16, 17)]
    (tmp_path / "hall.map.scen").write_text("version 1\n" + "".join(lines))
    both = PLANNED.replace('name = "planned"\n', "").replace('"yard.toml"', '["hall.map.scen:1", "hall.map.scen:2"]')
    file = write_campaign(tmp_path, both.replace("random", "astar-eight"))
    one, other = make_ready(load_campaign(file))
    assert [ready.case.name for ready in (one, other)] == ["hall 1", "hall 2"]
    assert one.plans[0].key != other.plans[0].key
    assert one.plans[0].scenario.goals.tolist() != other.plans[0].scenario.goals.tolist()
    write_resolved(load_campaign(file), (one, other), tmp_path / "again")
    again = make_ready(load_campaign(tmp_path / "again" / "campaign.toml"))
    assert [ready.plans[0].key for ready in again] == [one.plans[0].key, other.plans[0].key]


def test_a_planner_by_name_plans_in_a_worker_and_leaves_its_facts(tmp_path, campaign):
    finished = run_here(campaign(EXACT), tmp_path / "out")
    path = finished.outcomes["planned"].path
    assert path.points.tolist() == [[10.0, 30.0], [90.0, 30.0]]
    (told,) = facts(tmp_path / "out")
    assert (told.planner, told.scenario, told.length) == ("exact", "yard", 80.0)
    (file,) = (tmp_path / "out" / "plans").glob("*.json")
    assert file.read_text().startswith('{\n  "planner": "exact",\n')
    assert file.with_suffix(".csv").exists()


@pytest.mark.usefixtures("here")
def test_planners_and_settings_multiply_out(tmp_path, campaign):
    several = PLANNED.replace('"random"', '["exact", "random"]') + "set.clearance = [0, 1.5]\n"
    names = [result.case.name for result in run_here(campaign(several), tmp_path / "out").results]
    assert names == [f"planned {planner} clearance {room}" for planner in ("exact", "random") for room in ("0", "1.5")]
    assert len(facts(tmp_path / "out")) == 4


@pytest.mark.usefixtures("here")
def test_settings_written_out_are_the_same_plan_as_defaults(tmp_path, campaign):
    other = PLANNED.replace('"planned"', '"other"') + "set = { bend = 1 }\n"
    run_here(campaign(PLANNED, other), tmp_path / "out")
    assert len(CALLS) == 1


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize(("old", "new"), [("goal = [90.0", "goal = [80.0"), ("bend = 2", "bend = 3")])
def test_whatever_decides_the_path_makes_another_campaign(tmp_path, campaign, old, new):
    file = campaign(PLANNED + "set.bend = 2\n")
    run_here(file, tmp_path / "out")
    for changed in (file, tmp_path / "yard.toml"):
        changed.write_text(changed.read_text().replace(old, new))
    with pytest.raises(InputError, match="'planned' is not the same"):
        run_here(file, tmp_path / "out")


@pytest.mark.parametrize(
    ("case", "told"),
    [
        (PLANNED.replace('"random"', '"rendom"'), "'planned': planner: there is no planner 'rendom'; did you mean"),
        (PLANNED + "set.bond = 2\n", "planner random: unknown key 'bond'; did you mean 'bend'?"),
        (EXACT + "set.clearance = -1\n", "planner exact: clearance: expected float >= 0"),
        (PLANNED.replace('"random"', '{ command = ["x", "{output}"] }') + "set.bend = 1\n", "set: settings are those"),
        (PLANNED.replace('planner = "random"', 'path = "road.csv"') + "set.bend = 1\n", "set: settings are those"),
        (PLANNED.replace('planner = "random"', 'path = "road.csv"') + "replan = true\n", "replan: a path from a file"),
    ],
)
def test_wrong_settings_are_one_line_with_the_case(campaign, case, told, capfd):
    file = campaign(case)
    assert main(["run", str(file)]) == 2
    error = capfd.readouterr().err
    assert error.startswith(f"trackworthy: {file}: case 'planned': ")
    assert told in error
    assert len(error.strip().splitlines()) == 1


def test_a_dry_run_names_the_planner(campaign, capfd):
    assert main(["run", str(campaign(PLANNED)), "--dry-run"]) == 0
    assert "planned       1  planned by random on yard.toml, truck" in capfd.readouterr().out


# A plan for each trial


@pytest.mark.usefixtures("here")
def test_each_trial_flies_the_plan_of_its_own_seed(tmp_path, campaign):
    loaded = load_campaign(str(campaign(EACH)))
    (ready,) = make_ready(loaded)
    finished = run_here(campaign(EACH), tmp_path / "out")
    assert len({plan.seed for plan in ready.plans}) == len(CALLS) == 4
    assert [result.statistics.tried for result in finished.results] == [4]
    worst = finished.results[0].worst.trial
    stored = files.read(ready.plans[worst - 1].file(tmp_path / "out")).path
    assert np.array_equal(finished.outcomes["planned"].path.points, stored.points)


def test_plans_of_trials_are_paired_and_not_that_of_the_case(campaign):
    other = EACH.replace('"planned"', '"other"').replace("random", "exact").replace("speed = 8", 'controller = "l1"')
    windy = EACH.replace('"planned"', '"windy"') + "conditions.latency = 0.1\n"
    once = PLANNED.replace('"planned"', '"once"')
    ready = make_ready(load_campaign(str(campaign(EACH, other, windy, once))))
    seeds = [[plan.seed for plan in one.plans] for one in ready]
    assert seeds[0] == seeds[1] == seeds[2]
    assert not set(seeds[3]) & set(seeds[0])
    assert [plan.key for plan in ready[0].plans] == [plan.key for plan in ready[2].plans]


@pytest.mark.usefixtures("here")
def test_more_trials_go_on_from_the_plans_there_are(tmp_path, campaign):
    file = campaign(EACH)
    run_here(file, tmp_path / "out")
    file.write_text(file.read_text().replace("trials = 4", "trials = 6"))
    run_here(file, tmp_path / "out")
    assert len(CALLS) == 6
    run_here(file, tmp_path / "whole")
    assert (tmp_path / "out" / "summary.json").read_bytes() == (tmp_path / "whole" / "summary.json").read_bytes()


@pytest.mark.usefixtures("no_report")
def test_the_same_bytes_in_workers(tmp_path, campaign, monkeypatch):
    file = campaign(EXACT + "trials = 3\nreplan = true\nconditions.position_noise = 0.02\n")
    with monkeypatch.context() as patch:
        patch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))
        run_here(file, tmp_path / "here")
    assert main(["run", str(file), "-o", "far", "-j", "2"]) == 0
    assert (tmp_path / "far" / "summary.json").read_bytes() == (tmp_path / "here" / "summary.json").read_bytes()


@pytest.mark.usefixtures("here")
def test_the_folder_alone_runs_again(tmp_path, campaign):
    run_here(campaign(EACH + "set.bend = 2\n"), tmp_path / "out")
    before = (tmp_path / "out" / "summary.json").read_bytes()
    assert "bend = 2.0\nlose = 0.0\n" in (tmp_path / "out" / "campaign.toml").read_text()
    for again in ("out", "elsewhere"):
        run_here(tmp_path / "out" / "campaign.toml", tmp_path / again)
        assert (tmp_path / again / "summary.json").read_bytes() == before
    assert len(CALLS) == 8  # ours plan anew elsewhere: they may have changed


@pytest.mark.usefixtures("here")
def test_a_replayed_trial_plans_its_own_path_only(tmp_path, campaign, capfd):
    file = campaign(EACH)
    finished = run_here(file, tmp_path / "out")
    worst = finished.results[0].worst
    CALLS.clear()
    main(["run", str(file), "-o", "again", "--trial", str(worst.trial)])
    assert len(CALLS) == 1
    (plan,) = (tmp_path / "again" / "plans").glob("*.csv")
    assert np.array_equal(files.read(plan).path.points, finished.outcomes["planned"].path.points)


# No path


@pytest.mark.usefixtures("here")
def test_no_path_is_an_answer_and_not_an_error(tmp_path, campaign, capfd):
    never = PLANNED + 'set.lose = 1\ntrials = 3\nexpect = "not-trackworthy"\n'
    assert main(["run", str(campaign(never)), "-o", "out"]) == 0
    found = summary(tmp_path / "out")["planned"]
    assert (found["verdict"], found["errors"], found["share"]) == ("not-trackworthy", 0, 0.0)
    assert found["worst_trial"] is None
    assert found["no_path"] == {"trials": 3, "reason": "all of them lost their way"}
    assert (found["metrics"].keys(), found["metrics"]["completion"]["worst"]) == ({"completion"}, 0.0)
    told = "0 of 3 trials trackworthy (0 to 70.8 %); 3 of 3 trials found no path: all of them lost their way\n"
    assert told in capfd.readouterr().out
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")
    (fact,) = facts(tmp_path / "out")
    assert (fact.outcome, fact.reason, fact.length) == (NOT_FOUND, "all of them lost their way", None)
    assert not list((tmp_path / "out" / "plans").glob("*.csv"))


@pytest.mark.usefixtures("here")
def test_no_path_is_not_planned_again(tmp_path, campaign):
    file = campaign(PLANNED + "set.lose = 1\n")
    run_here(file, tmp_path / "out")
    (result,) = run_here(file, tmp_path / "out").results
    assert len(CALLS) == 1
    assert (result.verdict, result.passed) == ("not-trackworthy", False)


@pytest.mark.usefixtures("here")
def test_some_trials_without_a_path_count_in_the_share_and_in_nothing_else(tmp_path, campaign, capfd):
    some = PLANNED + "set.lose = 0.5\ntrials = 8\nreplan = true\npass_share = 0.1\n"
    assert main(["run", str(campaign(some)), "-o", "out"]) == 0
    found = summary(tmp_path / "out")["planned"]
    lost = sum(fact.outcome == NOT_FOUND for fact in facts(tmp_path / "out"))
    assert 0 < lost < 7
    assert found["no_path"]["trials"] == lost
    assert found["share"] == found["trackworthy"] / 8
    assert found["trackworthy"] <= 8 - lost
    assert found["metrics"]["cross_track_max"]["trials"] == 8 - lost
    assert found["metrics"]["completion"]["trials"] == 8
    assert found["band"] is not None
    out = capfd.readouterr().out
    assert f"; {lost} of 8 trials found no path: all of them lost their way; 95 % of the way" in out
    assert (tmp_path / "out" / "figures" / "1-planned-trials.png").exists()


@pytest.mark.usefixtures("here")
def test_a_trial_without_a_path_is_replayed_as_that(campaign, capfd):
    file = str(campaign(PLANNED + "set.lose = 1\n"))
    assert main(["run", file, "-o", "out", "--trial", "1"]) == 1
    assert "NOT TRACKWORTHY  planned: no path to fly: all of them lost their way" in capfd.readouterr().out


@pytest.mark.usefixtures("here", "no_report")
@pytest.mark.parametrize(
    ("fail", "code", "told"),
    [("input", 2, "planner random: yard: its start is in an obstacle; move it"), ("crash", 3, "a fault of ours")],
)
def test_a_planner_that_fails_is_an_error_of_its_kind(tmp_path, campaign, fail, code, told, capfd):
    assert main(["run", str(campaign(PLANNED + f'set.fail = "{fail}"\n', EXACT.replace("planned", "other")))]) == code
    found = summary(tmp_path / "runs" / "small")
    assert told in found["planned"]["first_error"]
    assert found["other"]["passed"]
    assert main(["run", "small.toml", "--case", "planned", "--trial", "1"]) == code
    assert told in capfd.readouterr().err


@pytest.mark.usefixtures("here", "no_report")
def test_one_case_one_trial_without_a_path(campaign, capfd):
    assert main(["run", str(campaign(PLANNED + "set.lose = 1\n"))]) == 1
    assert "FAIL  planned: NOT TRACKWORTHY  found no path: all of them lost their way\n" in capfd.readouterr().out


@pytest.mark.usefixtures("here", "no_report")
def test_the_gate_takes_trials_without_a_path(tmp_path, campaign, capfd):
    file = str(campaign(EACH))
    assert main(["run", file, "-o", "good"]) == 0
    assert main(["check", "good", "--baseline", "base.json", "--update"]) == 0
    worse = campaign(EACH + "set.lose = 1\n")
    assert main(["run", str(worse), "-o", "worse"]) == 1
    assert main(["check", "worse", "--baseline", "base.json"]) == 1
    assert "was trackworthy (4 of 4 trials), is not-trackworthy (0 of 4 trials)" in capfd.readouterr().out
