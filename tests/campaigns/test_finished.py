"""Results come back from their folder as they were when they were run."""

import shutil

import numpy as np
import pytest

from campaigns import finished
from campaigns.finished import read_finished
from campaigns.lanes import Lanes
from campaigns.tracks import read_tracks
from planners.errors import InputError
from small_campaigns import Here, run_here, write_campaign

CASES = """
[[case]]
name = "road"
path = "road.csv"
vehicle = "truck"
speed = "45km/h"
trials = 3
conditions.cross_track_offset = { normal = [0, 0.05] }

[[case]]
name = "air"
path = "air.csv"
vehicle = "c172x"
conditions.wind = "10@270"

[[case]]
name = "fleet"
path = "road.csv"
others = ["beside.csv"]
vehicle = "truck"
separation = "5m"
expect = "either"
"""


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """The campaign as it was run."""
    folder = tmp_path_factory.mktemp("finished")
    file = write_campaign(folder, CASES)
    beside = np.loadtxt(folder / "road.csv", delimiter=",", skiprows=1) + np.array([0.0, 12.0])
    np.savetxt(folder / "beside.csv", beside, delimiter=",", header="x,y", comments="")
    return run_here(file, folder / "results")


@pytest.fixture
def copy(ran, tmp_path):
    """The folder of its results, elsewhere."""
    return shutil.copytree(ran.folder, tmp_path / "moved")


def again(folder):
    return read_finished(folder, Lanes(Here(), 1))


def same(one, other):
    assert one.verdict == other.verdict
    assert one.metrics == other.metrics
    assert (one.track.columns, one.track.ended, one.track.frame) == (
        other.track.columns, other.track.ended, other.track.frame,
    )  # fmt: skip
    assert np.array_equal(one.track.data, other.track.data, equal_nan=True)


def test_nothing_is_flown_again(ran, copy, monkeypatch):
    monkeypatch.setattr("tracking.trial.follow", lambda *_: pytest.fail("it was flown"))
    found = again(copy)
    assert found.outcomes.keys() == ran.outcomes.keys() == {"road", "air", "fleet"}
    for name, outcome in found.outcomes.items():
        same(outcome, ran.outcomes[name])
    ours, theirs = found.outcomes["fleet"].fleet, ran.outcomes["fleet"].fleet
    assert (ours.departures, ours.member, ours.remedy) == (theirs.departures, theirs.member, theirs.remedy)
    for one, other in zip(ours.members, theirs.members, strict=True):
        same(one, other)
    assert found.called == ran.called
    assert [one.statistics.metrics for one in found.results] == [one.statistics.metrics for one in ran.results]


def test_what_was_not_kept_is_flown_again(ran, copy):
    shutil.rmtree(copy / "tracks")
    for name, outcome in again(copy).outcomes.items():
        same(outcome, ran.outcomes[name])


def test_other_code_flies_nothing_again(ran, copy, monkeypatch):
    monkeypatch.setattr(finished, "fingerprint", lambda: "other")
    assert again(copy).outcomes.keys() == ran.outcomes.keys()
    shutil.rmtree(copy / "tracks")
    found = again(copy)
    assert found.outcomes == {}
    assert len(found.results) == 3


def test_a_damaged_track_is_flown_again(ran, copy):
    for file in (copy / "tracks").iterdir():
        file.write_bytes(file.read_bytes()[:100])
        with pytest.raises(InputError, match=r"parquet: is not the track of a trial .*--fresh"):
            read_tracks(file)
    for name, outcome in again(copy).outcomes.items():
        same(outcome, ran.outcomes[name])


def test_a_folder_without_results_or_with_some(tmp_path, copy):
    with pytest.raises(InputError, match="holds no results"):
        again(tmp_path)
    text = (copy / "campaign.toml").read_text()
    (copy / "campaign.toml").write_text(text.replace("trials = 3", "trials = 5"))
    with pytest.raises(InputError, match="3 of 5 trials of 'road' are done"):
        again(copy)
