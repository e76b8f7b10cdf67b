import math
from dataclasses import replace

import numpy as np
import pytest

from campaigns.tracks import whole_track
from planners.path import Path
from tracking.fleet import member_seed
from tracking.profile import error_profile
from tracking.trial import Trial, run_trial

EAST = Path(np.array([[-2000.0, 0.0], [2000.0, 0.0]]), name="east")
NORTH = Path(np.array([[0.0, -2000.0], [0.0, 2000.0]]), name="north")
BENT = Path(np.array([[3000.0, 0.0], [4000.0, 0.0], [4000.0, 1000.0]]), name="a corner")
CROSSING = Trial("crossing", EAST, "c172x", others=(NORTH,), separation=400.0)


@pytest.fixture(scope="module")
def together():
    return run_trial(CROSSING)


def test_two_that_meet_are_not_trackworthy_and_are_told_delays_that_help(together):
    metric = together.metrics["separation_min"]
    assert metric.value < 20.0
    assert metric.t == pytest.approx(2000.0 / together.speed, abs=1.0)
    assert metric.who == "1 and 2"
    assert not together.verdict.trackworthy
    assert together.verdict.decisive.metric.name == "separation_min"
    assert together.fleet.departures == (0.0, 0.0)
    # V delay / sqrt(2) on square tracks; the first waits, as its seconds weigh less
    assert together.fleet.remedy == (math.ceil(math.sqrt(2.0) * 400.0 / together.speed), 0.0)


def test_separated_they_are_trackworthy(together):
    apart = run_trial(replace(CROSSING, departures="separated"))
    assert apart.verdict.trackworthy
    assert apart.fleet.departures == together.fleet.remedy
    assert apart.fleet.remedy == ()
    assert apart.metrics["separation_min"].value >= 400.0
    assert apart.metrics["departure_delay_max"].value == max(apart.fleet.departures)
    for one, other in zip(apart.fleet.members, together.fleet.members, strict=True):
        assert np.array_equal(one.track.data, other.track.data)


def test_each_flies_as_it_does_alone(together):
    alone = run_trial(Trial("north", NORTH, "c172x", seed=member_seed(0, 1)))
    assert np.array_equal(together.fleet.members[1].track.data, alone.track.data)


def test_metrics_are_those_of_the_worst_member_and_it_decides():
    fleet = run_trial(replace(CROSSING, others=(BENT,), separation=0.0))
    alone = [run_trial(Trial("alone", path, "c172x", seed=member_seed(0, i))) for i, path in enumerate((EAST, BENT))]
    for name in ("cross_track_max", "turn_margin", "completion", "altitude_error_max"):
        values = [one.metrics[name].value for one in alone if one.metrics[name].valid]
        assert fleet.metrics[name].value == (max if alone[0].metrics[name].better == "lower" else min)(values)
    assert not fleet.verdict.trackworthy
    assert fleet.fleet.member == 1
    assert fleet.track is fleet.fleet.members[1].track
    assert fleet.seed == 0
    assert np.abs(error_profile(fleet)).max() == np.abs(error_profile(alone[1])).max()


def test_the_users_separation_counts_for_verdict_and_delays():
    fleet = run_trial(replace(CROSSING, departures="separated", require=("separation_min>=1km",)))
    assert fleet.fleet.required == 1000.0
    assert fleet.verdict.trackworthy
    assert fleet.metrics["separation_min"].value >= 1000.0


def test_all_tracks_are_kept_with_number_and_departure(together):
    whole = whole_track(together)
    first, second = (member.track for member in together.fleet.members)
    assert len(whole) == len(first) + len(second)
    assert np.array_equal(whole["x"][whole["vehicle"] == 2.0], second["x"])
    assert set(whole["departure"]) == {0.0}


def test_members_have_air_of_their_own():
    seeds = [member_seed(seed, member) for seed in range(20) for member in range(3)]
    assert len(set(seeds)) == len(seeds)
    assert max(seeds) < 2**53
