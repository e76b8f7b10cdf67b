"""Fleets on the command line: planned into numbered files, tracked together."""

import json

import numpy as np
import pytest

from planners import files
from planners.path import Path


@pytest.fixture(autouse=True)
def _crossing(tmp_path, monkeypatch):
    """Two paths that cross at right angles, halfway along both."""
    monkeypatch.chdir(tmp_path)
    files.write(Path([[0.0, 0.0], [4000.0, 0.0]]), "east.csv")
    files.write(Path([[2000.0, -2000.0], [2000.0, 2000.0]]), "north.csv")


def test_a_plan_for_three_is_saved_in_three_files_that_fly_together(run):
    code, _, told = run("plan", "mars-hazards-15", "--planner", "exact", "-o", "route.csv")
    assert code == 0
    assert [line for line in told.splitlines() if line.startswith("saved")] == [
        f"saved route-{number}.csv" for number in (1, 2, 3)
    ]
    assert files.read("route-2.csv").path.xy[0].tolist() == [62500.0, 2500.0]


def test_paths_that_meet_are_not_trackworthy_until_they_are_separated(run):
    settings = ("--vehicle", "c172x", "--separation", "500")
    code, said, _ = run("track", "east.csv", "north.csv", *settings, "--json")
    told = json.loads(said)
    assert (code, told["decided_by"]) == (1, "separation_min")
    assert told["metrics"]["separation_min"]["who"] == "1 and 2"
    code, said, _ = run("track", "east.csv", "north.csv", *settings, "--departures", "separated", "--json")
    assert code == 0
    assert json.loads(said)["fleet"]["departures"] == told["fleet"]["remedy"]


def test_each_track_of_a_fleet_is_exported_into_a_file_of_its_own(run, tmp_path):
    run("track", "east.csv", "north.csv", "--vehicle", "c172x", "--export", "flown.csv")
    assert sorted(file.name for file in tmp_path.glob("flown*")) == ["flown-1.csv", "flown-2.csv"]


def test_no_export_takes_the_place_of_a_path_it_reads(run):
    kept = files.read("east.csv").path
    files.write(kept, "route-1.csv")
    files.write(files.read("north.csv").path, "route-2.csv")
    code, _, error = run("track", "route-1.csv", "route-2.csv", "--vehicle", "c172x", "--export", "route.csv")
    assert code == 2
    assert "route-1.csv: it would overwrite what is read" in error
    assert np.array_equal(files.read("route-1.csv").path.points, kept.points)


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        (("--separation", "-5"), "separation: -5 is no distance to keep; give 0 or more"),
        (("--planet", "venus"), "planet: there is no planet 'venus'; use earth, mars"),
        (("--vehicle", "truck", "--planet", "mars"), "planet: the truck drives on earth only"),
    ],
)
def test_what_is_wrong_is_told_in_one_line(run, wrong, told):
    code, said, error = run("track", "east.csv", "north.csv", "--vehicle", "c172x", *wrong)
    assert (code, said) == (2, "")
    assert error.startswith(f"trackworthy: {told}")
    assert error.count("\n") == 1


def test_a_c172x_on_mars_is_seen_to_fail(run):
    code, said, _ = run("track", "east.csv", "--vehicle", "c172x", "--planet", "mars", "--altitude", "1500")
    assert code == 1
    assert "the run ended early: stall" in said.splitlines()[-1]


def test_planets_and_modes_are_listed(run):
    assert [line.split()[0] for line in run("list", "planets")[1].splitlines()] == ["earth", "mars"]
    modes = run("list", "modes")[1]
    assert modes.count("Dutch roll") == 2
    assert "doubles" in next(line for line in modes.split("ares")[1].splitlines() if "spiral" in line)
