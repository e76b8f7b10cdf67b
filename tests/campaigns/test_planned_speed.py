"""Planners that plan for a speed take that of the case."""

import tomllib

import pytest

from campaigns.campaign import load_campaign
from campaigns.ready import make_ready
from planners.all_planners import ALL_PLANNERS
from sample_planner import LATERAL, SCENARIO, SpeedArc
from small_campaigns import InThisProcess, run_here, write_campaign
from trackworthy.__main__ import main

CASE = '\n[[case]]\nscenario = "bend.toml"\nplanner = "speed-arc"\nvehicle = "truck"\n'


@pytest.fixture(autouse=True)
def _planner(tmp_path, monkeypatch):
    monkeypatch.setattr("planners.all_planners.ALL_PLANNERS", (*ALL_PLANNERS, SpeedArc))
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))
    (tmp_path / "bend.toml").write_text(SCENARIO)


def ready(tmp_path, text):
    return make_ready(load_campaign(str(write_campaign(tmp_path, text))))


@pytest.mark.parametrize(
    ("keys", "planned", "driven"),
    [
        ("", 12.5, 12.5),  # the truck's own
        ('speed = "36km/h"\n', 10.0, 10.0),
        ('speed = 9\nset = { speed = "36km/h" }\n', 10.0, 9.0),
        ("set.speed = 10\n", 10.0, 12.5),
    ],
)
def test_it_plans_for_its_own_speed_or_the_cases_or_the_vehicles(tmp_path, keys, planned, driven):
    (one,) = ready(tmp_path, CASE + keys)
    assert one.inputs.planner.planned_speed == pytest.approx(planned)
    assert one.case.set["speed"] == pytest.approx(planned)
    assert one.case.speed == pytest.approx(driven)


def test_another_planner_knows_no_speed(tmp_path):
    (one,) = ready(tmp_path, CASE.replace("speed-arc", "exact") + "speed = 10\n")
    assert one.case.set == {"clearance": 0.0}


def test_every_speed_has_a_plan_of_its_own_and_each_is_driven_at_it(tmp_path):
    text = CASE + 'speed = ["30km/h", "45km/h"]\nrequire = ["completion>=0.9"]\n'
    one, two = ready(tmp_path, text)
    assert one.plans[0].key != two.plans[0].key
    assert one.plans[0].seed == two.plans[0].seed
    finished = run_here(tmp_path / "small.toml", tmp_path / "out")
    speeds = [finished.outcomes[result.case.name].speed for result in finished.results]
    assert speeds == pytest.approx([30 / 3.6, 12.5])
    assert [plan.statistics.smallest_radius for plan in finished.plans] == pytest.approx(
        [speed**2 / LATERAL for speed in speeds]
    )
    written = tomllib.loads((tmp_path / "out" / "campaign.toml").read_text())["case"]
    assert [case["set"]["speed"] for case in written] == pytest.approx(speeds)
    again = make_ready(load_campaign(str(tmp_path / "out" / "campaign.toml")))
    assert [case.digest for case in again] == [one.digest, two.digest]
    assert [case.plans[0].key for case in again] == [one.plans[0].key, two.plans[0].key]


def test_one_speed_however_it_is_written_is_one_plan(tmp_path):
    cases = ready(
        tmp_path, CASE + 'speed = ["45km/h", 12.5, "12.5m/s"]\n' + CASE + 'name = "x"\nset.speed = "45km/h"\n'
    )
    assert len({case.plans[0].key for case in cases}) == 1


@pytest.mark.parametrize(
    ("speed", "told"),
    [
        ('"30furlongs"', "set.speed: unknown unit 'furlongs' in '30furlongs'; use"),
        ("-3", "set.speed: -3.0 is not a speed"),
    ],
)
def test_a_wrong_speed_is_one_line_and_exit_code_2(tmp_path, speed, told, capfd):
    assert main(["run", str(write_campaign(tmp_path, f"{CASE}set.speed = {speed}\n"))]) == 2
    error = capfd.readouterr().err
    assert told in error
    assert len(error.strip().splitlines()) == 1
