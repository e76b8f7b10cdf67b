"""The top speed at which a path is trackworthy."""

import json
import math

import numpy as np
import pytest

from campaigns.campaign import load_campaign
from campaigns.execute import Machines, execute
from campaigns.ready import make_ready
from campaigns.search_ready import make_searches_ready
from campaigns.search_steps import find
from planners import files
from planners.all_planners import ALL_PLANNERS
from planners.errors import InputError
from planners.path import Path
from planners.units import STANDARD_GRAVITY
from sample_planner import LATERAL, SCENARIO, SpeedArc
from small_campaigns import InThisProcess, write_campaign
from trackworthy.__main__ import main

LIMIT = 0.6 * STANDARD_GRAVITY  # [m/s^2] that a truck may take
PLANNED = """
[[top_speed]]
name = "bend"
scenario = "bend.toml"
planner = "speed-arc"
vehicle = "truck"
speed = "36km/h"
between = ["18km/h", 20]
tolerance = 0.1
"""
DRAWN = '\n[[top_speed]]\npath = "circle.csv"\nvehicle = "truck"\nbetween = [5, 20]\ntolerance = 0.1\n'
RADIUS = 30.0  # [m] of the circle in the file


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("planners.all_planners.ALL_PLANNERS", (*ALL_PLANNERS, SpeedArc))
    (tmp_path / "bend.toml").write_text(SCENARIO)
    turn = np.linspace(0.0, math.pi, 200)
    files.write(Path(RADIUS * np.column_stack([np.sin(turn), 1.0 - np.cos(turn)])), tmp_path / "circle.csv")


@pytest.fixture
def here(monkeypatch):
    """Searches in this process, where the planner for tests is."""
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))


def named(name):
    """The search of that name that plans."""
    return PLANNED.replace('name = "bend"', f'name = "{name}"')


def ready(tmp_path, text):
    return make_searches_ready(load_campaign(str(write_campaign(tmp_path, text))))


def run(tmp_path, text, folder, machines):
    campaign = load_campaign(str(write_campaign(tmp_path, text)))
    searches = make_searches_ready(campaign)
    execute(campaign, make_ready(campaign), tmp_path / folder, machines, lambda one, *_: [*one], searches=searches)
    return (tmp_path / folder / "summary.json").read_bytes()


def test_the_top_speed_is_where_the_bend_asks_for_more_than_the_truck_may_take(tmp_path):
    """On an arc of radius R, v^2 / R reaches 0.6 g at v = sqrt(0.6 g R); the way in without an easement costs some.

    The arc is the one planned for 36 km/h at every speed that is tried.
    """
    (search,) = ready(tmp_path, PLANNED.replace("tolerance = 0.1", "tolerance = 0.02"))
    found = find(search)
    bound = math.sqrt(LIMIT * 10.0**2 / LATERAL)
    assert found.error == ""
    assert 0.7 * bound < found.at <= bound
    assert found.at < found.failing.at <= 1.02 * found.at
    assert found.failing.metric in ("lateral_acceleration_max", "cross_track_max")
    tried = {step.at: step.trackworthy for step in found.steps}
    assert list(tried)[:2] == [5.0, 20.0]
    assert all(held == (speed <= found.at) for speed, held in tried.items())


def test_a_wider_bend_may_be_taken_faster(tmp_path):
    slower, faster = (find(one) for one in ready(tmp_path, PLANNED.replace('"36km/h"', "[8, 10]")))
    assert faster.at / slower.at == pytest.approx(10 / 8, rel=0.1)  # v^2 / R is the same
    assert faster.at < faster.failing.at <= 1.1 * faster.at


def test_a_path_from_a_file_has_no_planned_speed_but_the_one_that_is_stated(tmp_path):
    one, two = ready(tmp_path, DRAWN + DRAWN + 'name = "stated"\nspeed = "36km/h"\n')
    assert (one.search.planned_for, two.search.planned_for) == (None, 10.0)
    found = find(one)
    assert 0.7 * math.sqrt(LIMIT * RADIUS) < found.at <= math.sqrt(LIMIT * RADIUS)
    assert find(two) == found


def test_the_planner_is_told_the_stated_speed_or_the_vehicles(tmp_path):
    own = named("own").replace('speed = "36km/h"\n', "")
    found = ready(tmp_path, PLANNED + own + named("set") + "set.speed = 9\n")
    assert [one.search.planned_for for one in found] == [10.0, 12.5, 9.0]
    assert len({one.key for one in found}) == 3


@pytest.mark.parametrize(("between", "at", "failing", "tries"), [("[19, 20]", None, 19.0, 1), ("[5, 6]", 6.0, None, 2)])
def test_ends_that_tell_all(tmp_path, between, at, failing, tries):
    (search,) = ready(tmp_path, PLANNED.replace('["18km/h", 20]', between))
    found = find(search)
    assert (found.at, found.failing and found.failing.at, len(found.steps)) == (at, failing, tries)


def test_where_nothing_is_planned_nothing_can_be_followed(tmp_path):
    (search,) = ready(tmp_path, PLANNED + "set.most = 5\n")
    found = find(search)
    assert (found.at, found.failing.reason) == (None, "no path: the bend is too narrow")


def test_lists_multiply_out_and_the_range_does_not(tmp_path):
    found = ready(tmp_path, PLANNED.replace('"36km/h"', '["30km/h", "45km/h"]') + 'controller = ["lqr", "l1"]\n')
    assert [one.search.name for one in found] == [
        f"bend {speed} {controller}" for speed in ("30km/h", "45km/h") for controller in ("lqr", "l1")
    ]
    assert {one.search.ends for one in found} == {(5.0, 20.0)}
    assert len({one.key for one in found}) == 4


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (('["18km/h", 20]', '["30km/h", "18km/h"]'), "top_speed 'bend': between: 8.33333 to 5 m/s is no range"),
        (('["18km/h", 20]', '["18mph", 20]'), "between: unknown unit 'mph' in '18mph'"),
        (('["18km/h", 20]', '["18km/h", 50]'), "5 to 50 m/s is not all within what the truck can do; stay within 1 to"),
        (('["18km/h", 20]', "20"), "top_speed[0]: between: "),
        (('between = ["18km/h", 20]', ""), "top_speed[0]: 'between' is missing"),
        (('speed = "36km/h"', 'expect_at_least = "fast"'), "expect_at_least: 'fast' is not a number"),
        (('speed = "36km/h"', "conditions.friction = { uniform = [0.6, 0.9] }"), "each speed is tried once"),
        (('scenario = "bend.toml"\n', ""), "a planner needs a scenario"),
        (('planner = "speed-arc"\n', ""), "a path or a planner is needed"),
        (('speed = "36km/h"', "trials = 3"), "unknown key 'trials'"),
    ],
)
def test_a_wrong_search_is_one_line_and_exit_code_2(tmp_path, change, told, capfd):
    text = PLANNED.replace(*change)
    assert text != PLANNED
    assert main(["run", str(write_campaign(tmp_path, text))]) == 2
    error = capfd.readouterr().err
    assert told in error
    assert len(error.strip().splitlines()) == 1


@pytest.mark.usefixtures("here")
def test_a_search_is_told_in_the_answer_the_summary_and_the_report(tmp_path, capfd):
    file = str(write_campaign(tmp_path, PLANNED + DRAWN))
    assert main(["run", file, "--dry-run"]) == 0
    told = capfd.readouterr().out
    assert "top speed of speed-arc on bend.toml, truck, lqr, 18km/h to 20" in told
    assert "top speed of circle.csv, truck, lqr, 5 to 20" in told
    assert main(["run", file, "-o", "out"]) == 0
    out, err = capfd.readouterr()
    assert "searching 2 top speeds" in err
    assert out.startswith("speed bend: top speed: ")
    assert " km/h), planned for 10 m/s (36 km/h); at " in out
    planned, drawn = json.loads((tmp_path / "out" / "summary.json").read_text())["top_speeds"]
    assert (planned["planner"], planned["path"], planned["planned_for"]) == ("speed-arc", None, 10.0)
    assert (drawn["planner"], drawn["path"], drawn["planned_for"]) == (None, "circle.csv", None)
    assert planned["top_speed"] < planned["failing"]["speed"] <= 1.1 * planned["top_speed"]
    assert (planned["between"], planned["passed"]) == ([5.0, 20.0], None)
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")
    before = (tmp_path / "out" / "summary.json").read_bytes()
    assert main(["run", "out/campaign.toml", "-o", "again"]) == 0
    assert (tmp_path / "again" / "summary.json").read_bytes() == before


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize(
    ("keys", "code", "told"),
    [
        ('expect_at_least = "30km/h"\n', 0, "pass  bend: top speed: "),
        ("expect_at_least = 19\n", 1, "FAIL  bend: top speed: "),
        ("set.most = 5\n", 0, "speed bend: top speed: none from 5 m/s (18 km/h) up, planned for 10 m/s (36 km/h); at"),
        ("between = [5, 6]\n", 0, "speed bend: top speed: at least 6 m/s (21.6 km/h), planned for 10 m/s (36 km/h)\n"),
    ],
)
def test_only_an_expectation_decides_the_exit_code(tmp_path, keys, code, told, capfd, monkeypatch):
    monkeypatch.setattr("reports.write.write_report", lambda *_: [])
    text = PLANNED.replace('between = ["18km/h", 20]\n', "") if "between" in keys else PLANNED
    assert main(["run", str(write_campaign(tmp_path, text + keys)), "-o", "out"]) == code
    assert capfd.readouterr().out.startswith(told)


def test_in_workers_it_is_the_same_and_what_was_found_is_kept(tmp_path):
    alone = run(tmp_path, DRAWN, "alone", InThisProcess())
    assert run(tmp_path, DRAWN, "workers", Machines(1)) == alone
    (kept,) = (tmp_path / "workers" / "searches").iterdir()
    kept.write_text(kept.read_text().replace('"at": ', '"at": 1', 1))  # as if another speed had been found
    assert run(tmp_path, DRAWN, "workers", InThisProcess()) != alone
    with pytest.raises(InputError, match="'top_speed circle' is not the same"):
        run(tmp_path, DRAWN.replace("tolerance = 0.1", "tolerance = 0.3"), "workers", InThisProcess())
