import json
import math
import shutil
import subprocess
import sys

import pytest

from campaigns.campaign import CAMPAIGNS_FOLDER
from planners import files
from planners.frame import Frame
from planners.path import Path
from sample_paths import arcs, circle, right_angle, road_weave

G = 9.80665


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copytree(CAMPAIGNS_FOLDER / "quickstart", tmp_path, dirs_exist_ok=True)


def write(path, name="path.csv"):
    files.write(path, name)
    return name


def test_a_path_that_can_be_followed_exits_with_0(run):
    code, out, _ = run("track", write(road_weave(10.0)), "--vehicle", "truck", "--speed", "10")
    assert code == 0
    assert out.splitlines()[-1].startswith("TRACKWORTHY")


def test_a_right_angle_at_60_kmh_is_not_trackworthy_and_says_where_and_why(run):
    code, out, _ = run("track", write(right_angle(80.0)), "--vehicle", "truck", "--speed", "60km/h", "--json")
    result = json.loads(out)
    assert code == 1
    assert result["trackworthy"] is False
    (stretch,) = result["feasibility"]["infeasible"]
    assert stretch["s"] == pytest.approx(80.0)
    assert stretch["required"] == pytest.approx((60 / 3.6) ** 2 / (0.6 * G), rel=1e-3)
    assert stretch["available"] == pytest.approx(0.5 / (math.sqrt(2) - 1), rel=1e-3)


def test_turns_of_100_m_radius_are_too_tight_for_a_c172x(run):
    code, out, _ = run("track", write(arcs(100.0, 1500.0)), "--vehicle", "c172x", "--json")
    result = json.loads(out)
    assert code == 1
    assert len(result["feasibility"]["infeasible"]) == 4
    for stretch in result["feasibility"]["infeasible"]:
        assert stretch["available"] == pytest.approx(100.0, rel=0.05)
        assert stretch["required"] == pytest.approx(55.0**2 / G, rel=0.01)


def test_a_07_g_circle_breaks_the_06_g_requirement_and_nothing_else(run):
    """The tyres hold 0.8 g, so the truck stays on the circle: it is the requirement that it fails."""
    speed = 12.5
    path = write(circle(speed**2 / (0.7 * G), 1.0, 0.5, run_up=40.0))
    code, out, _ = run("track", path, "--vehicle", "truck", "--speed", speed, "--json", "--corridor", "1")
    result = json.loads(out)
    missed = [margin["metric"] for margin in result["requirements"] if not margin["met"]]
    assert code == 1
    assert missed == ["lateral_acceleration_max"]
    assert result["metrics"]["lateral_acceleration_max"]["value"] > 0.65 * G


def test_expecting_the_failure_makes_it_pass_and_the_reverse(run):
    corner = write(right_angle(80.0))
    fast = ("track", corner, "--vehicle", "truck", "--speed", "60km/h")
    assert run(*fast, "--expect", "not-trackworthy")[0] == 0
    fine = ("track", write(road_weave(10.0), "fine.csv"), "--vehicle", "truck", "--speed", "10")
    assert run(*fine, "--expect", "not-trackworthy")[0] == 1


def test_json_is_one_object_on_standard_output_and_nothing_else(run):
    code, out, err = run("track", "valley-survey.plan", "--vehicle", "c172x", "--corners", "fly-by", "--json")
    assert code == 0
    assert json.loads(out)["vehicle"]["name"] == "c172x"
    assert "NAV_TAKEOFF" in err
    assert "rounded with a radius of" in err


def test_requirements_can_be_set_and_missed(run):
    track = ("track", write(road_weave(10.0)), "--vehicle", "truck", "--speed", "10")
    assert run(*track, "--require", "cross_track_p95<=0.2")[0] == 0
    assert run(*track, "--require", "cross_track_p95<=0.001")[0] == 1
    assert run(*track, "--require", "lateral_acceleration_max<=0.3g")[0] == 1


def test_the_flown_track_is_exported_in_every_format(run, tmp_path):
    exports = [word for suffix in ("csv", "kml", "geojson", "tlog") for word in ("--export", f"out.{suffix}")]
    code, _, err = run("track", "valley-survey.plan", "--vehicle", "c172x", "--corners", "fly-by", *exports)
    assert code == 0
    for suffix in ("csv", "kml", "geojson", "tlog"):
        assert (tmp_path / f"out.{suffix}").stat().st_size > 1000
    assert (tmp_path / "valley-survey-c172x.png").read_bytes().startswith(b"\x89PNG")
    assert "saved valley-survey-c172x.png" in err


def test_wind_and_fence_reach_the_flight(run):
    _, out, _ = run("track", "valley-survey.plan", "--vehicle", "c172x", "--wind", "8@320", "--json")
    result = json.loads(out)
    assert result["wind"]["speed"] == pytest.approx(8.0)
    assert result["metrics"]["clearance_min"]["valid"]


SURVEY = ("valley-survey.plan", "--vehicle", "c172x")
COURSE = ("proving-ground.csv", "--vehicle", "truck")
BAD_INPUT = {
    "a missing file": (("nowhere.csv", "--vehicle", "truck"), "", "nowhere.csv"),
    "NaN": (("bad.csv", "--vehicle", "truck"), "x,y\n0,0\n1,nan\n", "bad.csv"),
    "an empty file": (("bad.csv", "--vehicle", "truck"), "", "bad.csv"),
    "one point": (("bad.csv", "--vehicle", "truck"), "x,y\n0,0\n", "two points"),
    "duplicate points": (("bad.csv", "--vehicle", "truck"), "x,y\n0,0\n5,5\n5,5\n", "same place"),
    "a latitude out of range": (("bad.csv", "--vehicle", "c172x"), "lat,lon\n91,0\n92,0\n", "latitude"),
    "mixed units": (("bad.csv", "--vehicle", "c172x"), "x,lon\n0,0\n1,1\n", "bad.csv"),
    "a foreign unit": (("bad.csv", "--vehicle", "c172x"), "lat,lon,alt_ft\n0,0,10\n1,1,10\n", "alt_ft"),
    "an unknown suffix": (("bad.xyz", "--vehicle", "truck"), "", ".csv"),
    "an unknown vehicle": (("proving-ground.csv", "--vehicle", "boat"), "", "truck"),
    "an unknown controller": ((*COURSE, "--controller", "mpc"), "", "lqr"),
    "an unknown scenario": ((*COURSE, "--scenario", "moon"), "", "moon"),
    "a speed below stall": ((*SURVEY, "--speed", "40kt"), "", "stall speed"),
    "a speed with a wrong unit": ((*SURVEY, "--speed", "100mph"), "", "mph"),
    "a wind that is none": ((*SURVEY, "--wind", "strong"), "", "speed@direction"),
    "a wind too strong": ((*SURVEY, "--wind", "70@0"), "", "cannot be held"),
    "an unknown metric": ((*COURSE, "--require", "beauty<=3"), "", "beauty"),
    "a requirement in a wrong unit": ((*COURSE, "--require", "cross_track_max<=3deg"), "", "wrong unit"),
    "no corridor": ((*COURSE, "--corridor", "0"), "", "corridor"),
    "an altitude under ground": ((*SURVEY, "--altitude", "-5"), "", "altitude"),
    "a start in an obstacle": (("bad.csv", "--vehicle", "truck", "--scenario", "proving-ground.toml"),
                               "x,y\n150,100\n300,100\n", "start"),
    "an export without a place": ((*COURSE, "--export", "track.kml"), "", "export CSV"),
    "an export of an unknown kind": ((*SURVEY, "--export", "track.xyz"), "", ".tlog"),
    "a picture in no folder": ((*COURSE, "--picture", "nowhere/a.png"), "", "nowhere"),
    "a picture of an unknown kind": ((*COURSE, "--picture", "a.bmp"), "", ".png"),
    "a missing option": (("proving-ground.csv",), "", "--vehicle"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD_INPUT)
def test_bad_input_is_one_line_and_exit_code_2(run, tmp_path, name):
    arguments, content, told = BAD_INPUT[name]
    for file in ("bad.csv", "bad.xyz"):
        (tmp_path / file).write_text(content)
    code, out, err = run("track", *arguments)
    complaints = [line for line in err.splitlines() if line.startswith("trackworthy")]
    assert code == 2
    assert out == ""
    assert len(complaints) == 1
    assert told in complaints[0]
    assert "Traceback" not in err


def test_a_file_beyond_the_size_limit_is_refused_before_it_is_read(run, tmp_path):
    with (tmp_path / "huge.csv").open("wb") as huge:
        huge.truncate(files.MAX_FILE_BYTES + 1)  # sparse: no disk is filled
    code, _, err = run("track", "huge.csv", "--vehicle", "truck")
    assert code == 2
    assert "64 MiB" in err


def test_a_model_that_jsbsim_does_not_have(run, tmp_path):
    from sim.aircraft_file import AIRCRAFT_FOLDER

    text = (AIRCRAFT_FOLDER / "c172x.toml").read_text().replace('model = "c172x"', 'model = "c173"')
    (tmp_path / "mine.toml").write_text(text)
    code, _, err = run("track", "valley-survey.plan", "--vehicle", "mine.toml")
    assert code == 2
    assert "no model 'c173'" in err


def test_a_simulator_that_crashes_is_exit_code_3(run, monkeypatch):
    def crash(*_):
        raise RuntimeError("the tyres came off")

    monkeypatch.setattr("sim.truck.Truck.step", crash)
    code, out, err = run("track", *COURSE)
    assert code == 3
    assert out == ""
    assert "the tyres came off" in err
    assert "Traceback" not in err


def test_convert_keeps_the_place_within_a_centimetre(run):
    frame = Frame(47.0, 8.0)
    path = Path([[0.0, 0.0, 500.0], [60_000.0, 80_000.0, 700.0], [90_000.0, 10_000.0, 600.0]], frame=frame)
    write(path, "a.csv")
    for source, target in (("a.csv", "b.plan"), ("b.plan", "c.waypoints"), ("c.waypoints", "d.geojson")):
        assert run("convert", source, target)[0] == 0
    back = files.read("d.geojson").path
    assert back.frame is not None
    here = frame.to_local(*back.frame.to_geographic(back.xy).T)
    assert here == pytest.approx(path.xy, abs=0.01)


def test_convert_says_what_it_skips(run):
    code, _, err = run("convert", "valley-survey.plan", "out.csv")
    assert code == 0
    assert "NAV_TAKEOFF" in err
    assert "geofence is not written" in err


@pytest.mark.parametrize("what", ["vehicles", "controllers", "scenarios", "campaigns", "formats", "metrics"])
def test_list_shows_what_there_is(run, what):
    code, out, _ = run("list", what)
    assert code == 0
    assert len(out.splitlines()) >= 1


def test_list_names_every_metric_that_can_be_required(run):
    _, out, _ = run("list", "metrics")
    names = [line.split()[0] for line in out.splitlines()]
    assert {"cross_track_p95", "bank_max", "lateral_acceleration_max", "clearance_min", "range_used"} <= set(names)


def test_nothing_that_is_read_is_overwritten(run, tmp_path):
    before = (tmp_path / "valley-survey.plan").read_text()
    assert run("convert", "valley-survey.plan", "valley-survey.plan")[0] == 2
    write(road_weave(10.0), "mine.csv")
    code, _, err = run("track", "mine.csv", "--vehicle", "truck", "--export", "./mine.csv")
    assert code == 2
    assert "overwrite" in err
    assert (tmp_path / "valley-survey.plan").read_text() == before
    assert (tmp_path / "mine.csv").read_text().startswith("x,y")


def test_it_runs_as_a_module():
    help_text = subprocess.run(
        [sys.executable, "-m", "trackworthy", "--help"], capture_output=True, text=True, check=True
    ).stdout
    assert "exit codes" in help_text
