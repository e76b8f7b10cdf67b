"""Which tracks a campaign keeps, and what their files say."""

import sqlite3

import numpy as np
import pyarrow.parquet as pq
import pytest

from campaigns.attempt import replay
from campaigns.campaign import load_campaign
from campaigns.ready import make_ready
from campaigns.runner import tasks_of
from campaigns.tracks import to_parquet
from planners.frame import Frame
from small_campaigns import run_here, write_campaign
from tracking.columns import UNITS
from tracking.metric import SCHEMA_VERSION
from tracking.track import Track

# The truck starts up to 0.9 m beside its path, in a corridor of 0.5 m: some trials are trackworthy, some are not
CASES = """
[[case]]
name = "beside"
path = "line.csv"
vehicle = "truck"
speed = 10
trials = 8
[case.conditions]
cross_track_offset = { uniform = [0.1, 0.9] }

[[case]]
name = "expected"
path = "line.csv"
vehicle = "truck"
speed = 10
trials = 8
expect = "not-trackworthy"
[case.conditions]
cross_track_offset = { uniform = [0.1, 0.9] }
"""
AIR = """
[[case]]
name = "air | über"
path = "air.csv"
vehicle = "c172x"
altitude = 800
"""


def run(folder, keep, cases=CASES):
    """The campaign's file and the folder of its results."""
    file = write_campaign(folder, cases, head=f'seed = 1\nkeep_tracks = "{keep}"')
    (folder / "line.csv").write_text("x,y\n0,0\n20,0\n40,0\n")
    run_here(file, folder / keep)
    return file, folder / keep


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("tracks")


@pytest.fixture(scope="module")
def whole(folder):
    """Every track is kept."""
    return run(folder, "all")


def rows(out):
    db = sqlite3.connect(out / "results.sqlite")
    found = db.execute("SELECT key, case_name, trial, trackworthy, passed, score FROM trials").fetchall()
    db.close()
    return found


def kept(out):
    """(case, trial) of every track file, by what the file itself says."""
    found = []
    for file in sorted((out / "tracks").glob("*")):
        about = pq.read_schema(file).metadata
        assert file.name == f"{about[b'key'].decode()[:16]}.parquet"
        found.append((about[b"case"].decode(), int(about[b"trial"])))
    return sorted(found)


def test_some_trials_are_trackworthy_and_some_are_not(whole):
    for case in ("beside", "expected"):
        assert {bool(good) for _, name, _, good, _, _ in rows(whole[1]) if name == case} == {True, False}


def test_all_keeps_every_trial(whole):
    assert kept(whole[1]) == sorted((case, trial) for case in ("beside", "expected") for trial in range(1, 9))


def test_failures_keeps_the_trials_that_are_not_as_expected(folder):
    _, out = run(folder, "failures")
    unexpected = sorted((name, trial) for _, name, trial, _, passed, _ in rows(out) if not passed)
    assert kept(out) == unexpected
    missed = {trial for _, name, trial, good, _, _ in rows(out) if name == "beside" and not good}
    assert {trial for case, trial in unexpected if case == "beside"} == missed
    assert {trial for case, trial in unexpected if case == "expected"} == set(range(1, 9)) - missed


def test_worst_keeps_the_lowest_relative_margin_of_each_case(folder, whole):
    file, out = run(folder, "worst")
    campaign = load_campaign(str(file))
    lowest = {}
    for ready in make_ready(campaign):
        margins = {
            task.trial: min(margin.relative for margin in replay(ready.job(task.trial), task.seed).verdict.margins)
            for task in tasks_of(campaign, ready)
        }
        lowest[ready.case.name] = min(margins, key=margins.get)
        assert sorted(margins.values())[0] < sorted(margins.values())[1] < 0.0
    assert kept(out) == sorted(lowest.items())


def test_of_a_longer_run_the_worst_so_far_is_kept_alone(tmp_path):
    file, out = run(tmp_path, "worst")
    before = kept(out)
    file.write_text(file.read_text().replace("trials = 8", "trials = 30"))
    run_here(file, out)
    worst = {name: min((row[5], row[2]) for row in rows(out) if row[1] == name)[1] for name in ("beside", "expected")}
    assert set(before).isdisjoint(worst.items())
    assert kept(out) == sorted(worst.items())


def test_none_keeps_nothing(folder):
    _, out = run(folder, "none")
    assert len(rows(out)) == 16
    assert not (out / "tracks").exists()


def test_a_file_has_the_values_of_its_trial(whole):
    file, out = whole
    campaign = load_campaign(str(file))
    (ready, _) = make_ready(campaign)
    for task in list(tasks_of(campaign, ready))[:3]:
        track = replay(ready.job(task.trial), task.seed).track
        table = pq.read_table(out / "tracks" / f"{task.key[:16]}.parquet")
        assert tuple(table.column_names) == track.columns
        for column in track.columns:
            assert np.array_equal(table[column].to_numpy(), track[column], equal_nan=True)
        about = {key.decode(): value.decode() for key, value in table.schema.metadata.items()}
        assert about == {
            "case": "beside", "trial": str(task.trial), "seed": str(task.seed), "key": task.key,
            "ended": track.ended, "schema_version": str(SCHEMA_VERSION),
        }  # fmt: skip


def test_every_column_of_every_vehicle_has_its_unit(tmp_path, whole):
    _, air = run(tmp_path, "all", AIR)
    for out, own in ((whole[1], "steering"), (air, "bank")):
        schema = pq.read_schema(next((out / "tracks").iterdir()))
        units = {field.name: field.metadata[b"unit"].decode() for field in schema}
        assert {
            "t": "s",
            "x": "m",
            "cross_track": "m",
            "heading": "rad",
            "ground_speed": "m/s",
        }.items() <= units.items()
        assert units[own] == "rad"
        assert {name for name, unit in units.items() if not unit} == set()
        assert {str(kind) for kind in schema.types} == {"double"}
    assert kept(air) == [("air | über", 1)]


def test_a_frame_is_written_so_that_it_comes_back():
    track = Track(("t", "mine"), np.array([[0.0, np.nan], [0.1, np.inf]]), "stall", Frame(48.1 + 1e-13, -11.6))
    table = pq.read_table(pa_file(to_parquet(track, {"case": "x"})))
    about = table.schema.metadata
    assert (float(about[b"origin_lat"]), float(about[b"origin_lon"])) == (48.1 + 1e-13, -11.6)
    assert (about[b"case"], about[b"ended"]) == (b"x", b"stall")
    assert [table.schema.field(name).metadata for name in ("t", "mine")] == [{b"unit": b"s"}, {b"unit": b""}]
    assert np.array_equal(table["mine"].to_numpy(), [np.nan, np.inf], equal_nan=True)
    assert "mine" not in UNITS


def pa_file(content):
    import pyarrow as pa

    return pa.BufferReader(content)
