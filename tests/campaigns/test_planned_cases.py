"""Cases whose path is planned by a program of the user's: once, kept, and never a reason to lose other cases."""

import json
import shutil
import sys

import numpy as np
import pytest

from campaigns.campaign import load_campaign
from campaigns.lanes import Lanes
from campaigns.ready import make_ready
from planners import files
from planners.errors import InputError
from small_campaigns import Here, run_here, write_campaign
from trackworthy.__main__ import main

SCENARIO = 'name = "yard"\nsize = [100.0, 60.0]\nstart = [10.0, 30.0]\ngoal = [90.0, 30.0]\n'
# Goes from start to goal by way of a point that depends on the seed, and notes that it was called
PLANNER = """
import json, sys
task, seed = json.load(open(sys.argv[1])), int(sys.argv[3])
open("calls", "a").write(f"{seed}\\n")
(x, y), (to_x, to_y) = task["starts"][0], task["goals"][0]
middle = (x + to_x) / 2, (y + to_y) / 2 + seed % 1000 / 2000
with open(sys.argv[2], "w") as output:
    output.write("x,y\\n")
    output.writelines(f"{a},{b}\\n" for a, b in [(x, y), middle, (to_x, to_y)])
"""
MODULE = """
def plan(scenario, seed):
    open("calls", "a").write(f"{seed}\\n")
    return [scenario["starts"][0], [50.0, 30.0], scenario["goals"][0]]
"""
COMMAND = json.dumps([sys.executable, "planner.py", "{scenario}", "{output}", "{seed}"])
PLANNED = f"""
[[case]]
name = "planned"
scenario = "yard.toml"
planner = {{ command = {COMMAND}, timeout = 10 }}
vehicle = "truck"
speed = 8
"""
ROAD = """
[[case]]
name = "road"
path = "line.csv"
vehicle = "truck"
speed = 8
trials = 2
"""


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "line.csv").write_text("x,y\n0,0\n20,0\n40,0\n")
    (tmp_path / "yard.toml").write_text(SCENARIO)
    (tmp_path / "planner.py").write_text(PLANNER)


@pytest.fixture
def here(monkeypatch):
    """Plans and trials in this process, which starts planners all the same."""
    from contextlib import contextmanager

    @contextmanager
    def lanes(machines, timeout):
        yield Lanes(Here(), 1)

    monkeypatch.setattr("campaigns.execute.Machines.lanes", lanes)


@pytest.fixture
def no_report(monkeypatch):
    """Results without figures and PDF."""
    monkeypatch.setattr("reports.write.write_report", lambda *_: [])


@pytest.fixture
def campaign(tmp_path):
    """Writes a campaign of these cases; gives its file."""
    return lambda *cases: write_campaign(tmp_path, "".join(cases))


def calls(tmp_path):
    """The seeds with which the planner was called."""
    file = tmp_path / "calls"
    return [int(line) for line in file.read_text().split()] if file.exists() else []


def summary(folder):
    return {case["name"]: case for case in json.loads((folder / "summary.json").read_text())["cases"]}


def test_a_path_is_planned_once_and_shared_by_cases_and_trials(tmp_path, campaign):
    """Here in a worker process, as in every run of the program."""
    several = PLANNED.replace("speed = 8", 'speed = [6, 8]\ncontroller = ["lqr", "l1"]\ntrials = 3')
    finished = run_here(campaign(several), tmp_path / "out")
    (seed,) = calls(tmp_path)
    assert [result.statistics.tried for result in finished.results] == [3] * 4
    expected = [[10.0, 30.0], [50.0, 30.0 + seed % 1000 / 2000], [90.0, 30.0]]
    for outcome in finished.outcomes.values():
        assert np.array_equal(outcome.path.points, expected)
    (kept,) = (tmp_path / "out" / "plans").iterdir()
    assert np.array_equal(files.read(kept).path.points, expected)


@pytest.mark.usefixtures("here")
def test_a_resumed_run_does_not_plan_again(tmp_path, campaign):
    file = campaign(PLANNED)
    run_here(file, tmp_path / "out")
    before = (tmp_path / "out" / "summary.json").read_bytes()
    run_here(file, tmp_path / "out")
    assert len(calls(tmp_path)) == 1
    assert (tmp_path / "out" / "summary.json").read_bytes() == before
    file.write_text(file.read_text() + "trials = 4\n")
    assert run_here(file, tmp_path / "out").results[0].statistics.tried == 4
    assert len(calls(tmp_path)) == 1


@pytest.mark.usefixtures("here")
def test_a_changed_planner_is_another_campaign_and_plans_anew(tmp_path, campaign):
    file = campaign(PLANNED)
    run_here(file, tmp_path / "out")
    (tmp_path / "planner.py").write_text(PLANNER.replace("/ 2000", "/ 1000"))
    with pytest.raises(InputError, match=r"the campaign or its files have changed: .*--fresh"):
        run_here(file, tmp_path / "out")
    assert len(calls(tmp_path)) == 1
    finished = run_here(file, tmp_path / "out", fresh=True)
    first, second = calls(tmp_path)
    assert first == second
    assert finished.outcomes["planned"].path.points[1, 1] == pytest.approx(30.0 + first % 1000 / 1000)
    assert len(list((tmp_path / "out" / "plans").iterdir())) == 1


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize(
    ("old", "new"), [("goal = [90.0", "goal = [80.0"), ('"{seed}"', '"7"'), ("seed = 1", "seed = 2")]
)
def test_whatever_decides_the_path_makes_another_campaign(tmp_path, campaign, old, new):
    file = campaign(PLANNED)
    run_here(file, tmp_path / "out")
    for changed in (file, tmp_path / "yard.toml"):
        changed.write_text(changed.read_text().replace(old, new))
    with pytest.raises(InputError, match="have changed: "):
        run_here(file, tmp_path / "out")


@pytest.mark.usefixtures("here")
def test_a_changed_planner_is_told_as_its_case(tmp_path, campaign):
    file = campaign(ROAD, PLANNED)
    run_here(file, tmp_path / "out")
    (tmp_path / "planner.py").write_text(PLANNER.replace("/ 2000", "/ 1000"))
    with pytest.raises(InputError, match="'planned'"):
        run_here(file, tmp_path / "out")


@pytest.mark.usefixtures("here")
def test_a_planner_may_get_a_longer_timeout_as_it_is_told_to(tmp_path, campaign):
    (tmp_path / "planner.py").write_text(f"import time; time.sleep(0.5)\n{PLANNER}")
    file = campaign(PLANNED.replace("timeout = 10", "timeout = 0.2"), ROAD)
    (failed, road) = run_here(file, tmp_path / "out").results
    assert "give it a longer timeout" in failed.statistics.first_error
    file.write_text(file.read_text().replace("timeout = 0.2", "timeout = 10"))
    assert [result.passed for result in run_here(file, tmp_path / "out").results] == [True, road.passed]


@pytest.mark.usefixtures("here")
def test_a_planner_in_python_that_changes_is_another_campaign(tmp_path, campaign):
    (tmp_path / "mine.py").write_text(MODULE)
    file = campaign(PLANNED.replace(f"command = {COMMAND}", 'python = "mine:plan"'))
    assert run_here(file, tmp_path / "out").results[0].passed
    assert len(calls(tmp_path)) == 1
    (tmp_path / "mine.py").write_text(MODULE.replace("30.0", "31.0"))
    with pytest.raises(InputError, match="have changed: "):
        run_here(file, tmp_path / "out")


@pytest.mark.usefixtures("here")
def test_two_plan_seeds_are_two_cases_with_a_path_each(tmp_path, campaign):
    finished = run_here(campaign(PLANNED + "plan_seed = [1, 2]\n"), tmp_path / "out")
    assert [result.case.name for result in finished.results] == ["planned plan_seed 1", "planned plan_seed 2"]
    seeds = calls(tmp_path)
    assert len(set(seeds)) == 2
    middles = [outcome.path.points[1, 1] for outcome in finished.outcomes.values()]
    assert sorted(middles) == sorted(30.0 + seed % 1000 / 2000 for seed in seeds)
    assert middles[0] != middles[1]


@pytest.mark.usefixtures("here")
def test_the_same_planner_elsewhere_gets_the_same_seed(tmp_path, campaign):
    (tmp_path / "other.py").write_text(PLANNER)
    other = PLANNED.replace("planned", "other").replace("planner.py", "other.py")
    run_here(campaign(PLANNED, other), tmp_path / "out")
    first, second = calls(tmp_path)
    assert first == second


# Planners that fail

FAILING = [
    ('print("no way out"); sys.exit(4)', "it failed with exit code 4: no way out", "no way out"),
    ("print('soon', flush=True); __import__('time').sleep(60)", "stopped after 1 s without a path", "soon"),
    ("print('ready'); open(sys.argv[2], 'w').write('hello')", "path.csv: ", "ready"),
    ("print('nothing found')", "it ended without writing path.csv", "nothing found"),
]


@pytest.mark.usefixtures("here", "no_report")
@pytest.mark.parametrize(("text", "told", "printed"), FAILING)
def test_a_planner_that_fails_costs_its_own_case_only(tmp_path, campaign, text, told, printed, capfd):
    (tmp_path / "planner.py").write_text(f"import sys\n{text}\n")
    file = campaign(PLANNED.replace("timeout = 10", "timeout = 1") + "trials = 3\n", ROAD)
    assert main(["run", str(file), "-o", "out"]) == 3
    found = summary(tmp_path / "out")
    assert (found["planned"]["verdict"], found["planned"]["errors"]) == ("error", 3)
    assert (found["road"]["verdict"], found["road"]["errors"]) == ("trackworthy", 0)
    error = found["planned"]["first_error"]
    assert error.startswith(f"planner {sys.executable}"[:50])
    assert told in error
    (log,) = (tmp_path / "out" / "plans").glob("*.log")
    assert log.read_text() == printed
    assert error.endswith(f"; what it printed is in plans/{log.name}")
    assert f"error planned: 3 of 3 trials: {error}\n" in capfd.readouterr().out


@pytest.mark.usefixtures("here")
def test_the_same_command_tries_a_failed_planner_again(tmp_path, campaign, capfd):
    """It failed for want of something that lies beside it; its own file has not changed."""
    (tmp_path / "planner.py").write_text(f"open('data').read()\n{PLANNER}")
    file = campaign(PLANNED, ROAD)
    assert main(["run", str(file), "-o", "out"]) == 3
    assert "No such file or directory: 'data'" in summary(tmp_path / "out")["planned"]["first_error"]
    (tmp_path / "data").touch()
    assert main(["run", str(file), "-o", "out"]) == 0
    assert "2 of 2 cases as expected" in capfd.readouterr().out
    assert [file.suffix for file in (tmp_path / "out" / "plans").glob("*.error")] == []
    assert len(calls(tmp_path)) == 1
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.usefixtures("here")
def test_a_log_is_of_the_last_try(tmp_path, campaign):
    (tmp_path / "planner.py").write_text(f"open('data').read()\n{PLANNER}")
    file = campaign(PLANNED)
    run_here(file, tmp_path / "out")
    (log,) = (tmp_path / "out" / "plans").glob("*.log")
    assert "FileNotFoundError" in log.read_text()
    (tmp_path / "data").touch()
    assert run_here(file, tmp_path / "out").results[0].passed
    assert not log.exists()


@pytest.mark.usefixtures("here")
def test_what_a_good_planner_prints_is_kept_too(tmp_path, campaign):
    (tmp_path / "planner.py").write_text(f"{PLANNER}\nprint('a note')\n")
    assert run_here(campaign(PLANNED), tmp_path / "out").results[0].passed
    (log,) = (tmp_path / "out" / "plans").glob("*.log")
    assert log.read_text() == "a note"


@pytest.mark.usefixtures("here")
def test_a_folder_of_a_planner_that_is_not_there_is_told_as_that(tmp_path, campaign):
    file = campaign(PLANNED.replace("timeout = 10", 'folder = "nowhere"'))
    error = run_here(file, tmp_path / "out").results[0].statistics.first_error
    assert f"folder {tmp_path / 'nowhere'}" in error
    assert "interpreter" not in error


@pytest.mark.usefixtures("here")
def test_a_replayed_trial_tells_why_there_is_no_path(tmp_path, campaign, capfd):
    (tmp_path / "planner.py").write_text("import sys; sys.exit('no way out')")
    assert main(["run", str(campaign(PLANNED)), "-o", "out", "--trial", "1"]) == 3
    error = capfd.readouterr().err
    assert len(error.strip().splitlines()) == 1
    assert "no way out" in error


@pytest.mark.usefixtures("here", "no_report")
def test_a_path_into_the_edge_is_an_error_of_the_trials_and_bad_input(tmp_path, campaign):
    (tmp_path / "planner.py").write_text("import sys; open(sys.argv[2], 'w').write('x,y\\n-5,30\\n90,30\\n')")
    assert main(["run", str(campaign(PLANNED, ROAD)), "-o", "out"]) == 2
    found = summary(tmp_path / "out")
    assert "in an obstacle or over the edge" in found["planned"]["first_error"]
    assert found["road"]["errors"] == 0


# Replay, and the folder alone


@pytest.mark.usefixtures("here")
def test_a_trial_is_replayed_on_the_stored_path(tmp_path, campaign, capfd):
    """With the folder of the results; elsewhere the planner plans again."""
    (tmp_path / "planner.py").write_text(PLANNER.replace("seed % 1000", "len(open('calls').read()) * 10"))
    file = campaign(PLANNED + "trials = 2\n")
    finished = run_here(file, tmp_path / "out")
    stored = finished.outcomes["planned"]
    assert main(["run", str(file), "-o", "out", "--case", "planned", "--trial", "1"]) == 0
    assert len(calls(tmp_path)) == 1
    assert "planned" in capfd.readouterr().out
    assert main(["run", str(file), "-o", "elsewhere", "--case", "planned", "--trial", "1"]) == 0
    assert len(calls(tmp_path)) == 2
    (kept,) = (tmp_path / "out" / "plans").glob("*.csv")
    assert np.array_equal(files.read(kept).path.points, stored.path.points)


@pytest.mark.usefixtures("here")
def test_the_resolved_campaign_runs_again_with_the_same_planner(tmp_path, campaign):
    (tmp_path / "deep").mkdir()
    run_here(campaign(PLANNED + "trials = 2\n"), tmp_path / "out")
    before = (tmp_path / "out" / "summary.json").read_bytes()
    (tmp_path / "out").rename(tmp_path / "deep" / "moved")
    moved = tmp_path / "deep" / "moved"
    run_here(moved / "campaign.toml", moved)
    assert len(calls(tmp_path)) == 1
    run_here(moved / "campaign.toml", tmp_path / "again")
    assert len(calls(tmp_path)) == 1  # the folder brings its plan
    shutil.rmtree(moved / "plans")
    run_here(moved / "campaign.toml", tmp_path / "anew")
    first, second = calls(tmp_path)
    assert first == second
    for folder in (moved, tmp_path / "again", tmp_path / "anew"):
        assert (folder / "summary.json").read_bytes() == before


# Wrong cases


@pytest.mark.parametrize(
    ("case", "told"),
    [
        (PLANNED.replace(f"{{ command = {COMMAND}, timeout = 10 }}", '"astar"'), "there is no planner 'astar'"),
        (PLANNED.replace('scenario = "yard.toml"\n', ""), "a planner needs a scenario"),
        (PLANNED + 'path = "line.csv"\n', "a path or a planner is needed, one of them"),
        ('[[case]]\nname = "neither"\nscenario = "yard.toml"\nvehicle = "truck"\n', "a path or a planner is needed"),
        (PLANNED.replace("yard.toml", "nowhere.toml"), "nowhere.toml"),
        (PLANNED.replace("{output}", "path"), "the command does not say where to write the path"),
        (PLANNED.replace("timeout = 10", "timeout = 0"), "a timeout of 0"),
    ],
)
def test_a_wrong_planner_is_one_line_and_exit_code_2(tmp_path, campaign, case, told, capfd):
    assert main(["run", str(campaign(ROAD, case)), "-o", "out"]) == 2
    out, error = capfd.readouterr()
    assert out == ""
    assert len(error.strip().splitlines()) == 1
    assert told in error
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("change", [("", ""), ('name = "planned"\n', "")])
def test_a_planner_without_a_scenario_is_told_with_the_file(campaign, change, capfd):
    file = campaign(PLANNED.replace('scenario = "yard.toml"\n', "").replace(*change))
    assert main(["run", str(file)]) == 2
    assert capfd.readouterr().err.startswith(f"trackworthy: {file}: ")


def test_ready_cases_of_one_plan_share_its_key(campaign):
    loaded = load_campaign(str(campaign(PLANNED.replace("speed = 8", "speed = [6, 8]"), PLANNED.replace('d"', 'e"'))))
    keys = [plan.key for ready in make_ready(loaded) for plan in ready.plans]
    assert len(set(keys)) == 1
