"""Cases of several vehicles at once: planned for on one scenario, or from a file each."""

import json

import numpy as np
import pyarrow.parquet as pq
import pytest

from campaigns.campaign import load_campaign
from campaigns.case import Case
from campaigns.inputs import Reader
from campaigns.prepare import assemble
from campaigns.ready import make_ready
from planners import files
from planners.errors import InputError
from planners.frame import MARS_A, MARS_B, Frame
from planners.path import Path
from small_campaigns import InThisProcess, run_here, write_campaign

YARD = """
name = "yard"
size = [100.0, 60.0]
vehicles = [[10.0, 10.0], [10.0, 50.0]]
targets = [[90.0, 50.0], [90.0, 10.0]]
"""
PLANNED = """
[[case]]
name = "two"
scenario = "yard.toml"
planner = "exact"
vehicle = "truck"
speed = 8
"""


@pytest.fixture
def yard(tmp_path):
    (tmp_path / "yard.toml").write_text(YARD)
    return tmp_path


@pytest.fixture
def here(monkeypatch):
    """Plans in this process."""
    monkeypatch.setattr("campaigns.execute.Machines.lanes", lambda machines, timeout: InThisProcess().lanes(timeout))


def trial_of(folder, **settings):
    case = Case(**{"vehicle": "c172x", **settings})
    return assemble(case, Reader(folder).read(case))


def test_every_start_has_its_path_and_the_vehicles_are_judged_together(yard):
    """Planned in a worker process, as in every run of the program."""
    file = write_campaign(yard, PLANNED + 'require = ["separation_min>=30"]\n')
    finished = run_here(file, yard / "out")
    outcome = finished.outcomes["two"]
    starts = [member.path.xy[0].tolist() for member in outcome.fleet.members]
    assert starts == [[10.0, 10.0], [10.0, 50.0]]
    assert len(list((yard / "out" / "plans").glob("*.csv"))) == 2
    # Straight across, side by side, 40 m apart
    assert outcome.metrics["separation_min"].value == pytest.approx(40.0, abs=0.5)
    assert finished.results[0].passed
    told = json.loads((yard / "out" / "summary.json").read_text())["cases"][0]
    assert told["metrics"]["separation_min"]["worst"] == pytest.approx(40.0, abs=0.5)
    (track,) = (yard / "out" / "tracks").iterdir()
    table = pq.read_table(track)
    assert set(table["vehicle"].to_pylist()) == {1.0, 2.0}


@pytest.mark.usefixtures("here")
def test_the_folder_runs_again_to_the_same_bytes(yard):
    file = write_campaign(yard, PLANNED + "trials = 2\nconditions.position_noise = 0.05\nunit = 1.5\n")
    run_here(file, yard / "out")
    run_here(yard / "out" / "campaign.toml", yard / "again")
    first, again = ((yard / name / "summary.json").read_bytes() for name in ("out", "again"))
    assert first == again


@pytest.mark.usefixtures("here")
def test_members_have_noise_of_their_own(yard):
    file = write_campaign(yard, PLANNED + "conditions.position_noise = 0.05\n")
    one, two = run_here(file, yard / "out").outcomes["two"].fleet.members
    assert not np.array_equal(one.track["cross_track"][:50], two.track["cross_track"][:50])


@pytest.mark.usefixtures("here")
def test_a_unit_draws_the_map_to_another_scale(yard):
    file = write_campaign(yard, PLANNED + "unit = [1.0, 2.0]\n")
    finished = run_here(file, yard / "out")
    small, large = (finished.outcomes[f"two unit {unit}"] for unit in (1, 2))
    assert large.path.length == pytest.approx(2.0 * small.path.length)
    assert len({plan.key for ready in make_ready(load_campaign(str(file))) for plan in ready.plans}) == 2


def test_paths_from_files_are_brought_into_the_frame_of_the_first(tmp_path):
    files.write(Path([[0.0, 0.0], [3000.0, 0.0]], frame=Frame(47.0, 8.0)), tmp_path / "a.csv")
    files.write(Path([[0.0, 0.0], [3000.0, 0.0]], frame=Frame(47.02, 8.0)), tmp_path / "b.csv")
    trial = trial_of(tmp_path, path="a.csv", others=("b.csv",))
    (other,) = trial.others
    assert other.frame == trial.path.frame
    # 0.02 degrees of latitude at 47 degrees: a meridian radius of 6,369,6 km
    assert other.points[0] == pytest.approx([0.0, 2223.4], abs=2.0)


def test_a_path_in_metres_and_one_in_degrees_are_no_fleet(tmp_path):
    files.write(Path([[0.0, 0.0], [3000.0, 0.0]], frame=Frame(47.0, 8.0)), tmp_path / "a.csv")
    files.write(Path([[0.0, 0.0], [3000.0, 0.0]]), tmp_path / "b.csv")
    with pytest.raises(InputError, match="give all in metres, or all in degrees"):
        trial_of(tmp_path, path="a.csv", others=("b.csv",))


def test_others_need_one_they_are_beside(tmp_path):
    with pytest.raises(InputError, match="others: they are paths beside one"):
        Reader(tmp_path).read(Case(scenario="mars-gap", planner="exact", vehicle="ares", others=("b.csv",)))


def test_degrees_are_those_of_the_planet_flown_on(tmp_path):
    """Of 0.01 degrees of longitude on the equator, by the planet's equatorial radius."""
    files.write(Path([[0.0, 0.0], [1113.1949, 0.0]], frame=Frame(0.0, 0.0)), tmp_path / "a.csv")
    trial = trial_of(tmp_path, path="a.csv", vehicle="ares", planet="mars")
    assert (trial.path.frame.a, trial.path.frame.b) == (MARS_A, MARS_B)
    assert trial.path.length == pytest.approx(np.radians(0.01) * MARS_A, abs=0.01)


def test_degrees_are_those_of_the_vehicles_own_planet_if_nobody_says_otherwise(tmp_path):
    files.write(Path([[0.0, 0.0], [1113.1949, 0.0]], frame=Frame(0.0, 0.0)), tmp_path / "a.csv")
    assert trial_of(tmp_path, path="a.csv", vehicle="ares").path.frame.a == MARS_A


def test_a_map_with_an_origin_keeps_its_metres_on_another_planet(yard):
    """A path planned on it, or given by latitudes and longitudes there, lies among the same obstacles."""
    (yard / "yard.toml").write_text(YARD + "origin = [10.0, 20.0]\n")
    inputs = Reader(yard).read(Case(scenario="yard.toml", planner="exact", vehicle="c172x", planet="mars"))
    assert inputs.scenario.map.frame == Frame(10.0, 20.0, MARS_A, MARS_B)
    straight = Path([[10.0, 10.0], [90.0, 50.0]], frame=inputs.scenario.map.frame)
    trial = assemble(Case(scenario="yard.toml", planner="exact", vehicle="c172x", planet="mars"), inputs, (straight,))
    assert np.array_equal(trial.path.points, straight.points)
    assert trial.obstacles.frame == trial.path.frame


def test_a_planet_by_name_is_that_of_the_worker_too(tmp_path):
    file = write_campaign(tmp_path, '[[case]]\nname = "home"\npath = "air.csv"\nvehicle = "c172x"\nplanet = "earth"\n')
    assert run_here(file, tmp_path / "out").results[0].verdict == "trackworthy"


def test_one_vehicle_is_told_that_it_is_no_fleet(tmp_path):
    files.write(Path([[0.0, 0.0], [3000.0, 0.0]]), tmp_path / "a.csv")
    (note,) = trial_of(tmp_path, path="a.csv", name="lone", separation=500).notes
    assert note == "lone: separation, departures: not taken, it is one vehicle"


def test_the_scenario_says_where_it_lies_and_the_case_may_say_otherwise():
    planned = {"scenario": "mars-gap", "planner": "exact"}
    for planet, gravity in ((None, 3.71), ("earth", 9.80665)):
        inputs = Reader("").read(Case(vehicle="c172x", planet=planet, **planned))
        assert inputs.limits.lateral_acceleration == pytest.approx(gravity * np.tan(np.radians(45.0)))


def test_an_unknown_planet_is_told_with_its_file(tmp_path):
    (tmp_path / "far.toml").write_text(YARD + 'planet = "venus"\norigin = [0.0, 0.0]\n')
    with pytest.raises(InputError, match=r"far.toml: planet: there is no planet 'venus'; use earth, mars"):
        Reader(tmp_path).read(Case(scenario="far.toml", planner="exact", vehicle="truck"))


def test_many_corners_are_told_of_at_once(tmp_path):
    """Eight corners of 10 degrees, 5 km apart: cut by R (1 / cos(5 deg) - 1), R 1.2 times 55^2 / (g tan(45 deg))."""
    course = np.radians(10.0) * np.arange(9)
    steps = 5000.0 * np.column_stack([np.cos(course), np.sin(course)])
    files.write(Path(np.vstack([[0.0, 0.0], np.cumsum(steps, axis=0)])), tmp_path / "bow.csv")
    notes = trial_of(tmp_path, path="bow.csv", corners="fly-by").notes
    assert notes == ("bow.csv: 8 corners: rounded with a radius of 370 m or more, cut by at most 1.4 m, at 5.00 km",)
