import dataclasses
from types import SimpleNamespace

import msgspec
import numpy as np
import pytest

from campaigns.conditions import CALM, WindKeys
from campaigns.tracks import ends, to_parquet, whole_track
from reports.html.kept import Kept, kept_trials, replayed
from reports.html.runs import worst_runs
from reports.html.spread import spread_data
from reports.html.world import World


@pytest.fixture
def kept_fleet(apart_fleet, tmp_path):
    file = tmp_path / "track.parquet"
    file.write_bytes(to_parquet(whole_track(apart_fleet), ends(apart_fleet)))
    return Kept(SimpleNamespace(case=SimpleNamespace(conditions=CALM)), 7, 11, file)


def test_a_fleet_comes_back_with_its_departures(kept_fleet, apart_fleet):
    told = list(replayed(kept_fleet, apart_fleet))
    assert [departure for _, departure in told] == list(apart_fleet.fleet.departures)
    for (member, _), flown in zip(told, apart_fleet.fleet.members, strict=True):
        assert np.array_equal(member.track.data, flown.track.data)
        assert member.seed == 11
        assert member.path is flown.path


def test_each_trial_has_its_own_wind(kept_fleet, apart_fleet):
    keys = msgspec.structs.replace(CALM, wind=WindKeys(10.0, 270.0))
    kept = dataclasses.replace(kept_fleet, result=SimpleNamespace(case=SimpleNamespace(conditions=keys)))
    wind = next(replayed(kept, apart_fleet))[0].conditions.wind
    assert (wind.east, wind.north) == pytest.approx((10.0, 0.0))


def test_a_fleet_is_replayed_whole(finished, apart_fleet):
    name = finished.results[0].case.name
    world = World()
    case = worst_runs(dataclasses.replace(finished, outcomes={name: apart_fleet}), world, 10**6)[name]
    vehicles = case["runs"][0]["vehicles"]
    assert [one["number"] for one in vehicles] == [1, 2, 3]
    assert [one["departure"] for one in vehicles] == pytest.approx(apart_fleet.fleet.departures, abs=1e-3)
    assert case["decides"] == apart_fleet.fleet.member
    assert len(world.paths) == 3
    assert len(world.maps) == 1


def test_less_room_is_fewer_samples(finished):
    counts = []
    for room in (10**7, 10**5):
        cases = worst_runs(finished, World(), room)
        counts.append(sum(one["runs"][0]["vehicles"][0]["samples"] for one in cases.values()))
    assert counts[1] < counts[0]


def test_the_first_trial_of_every_case_comes_first(finished):
    kept = kept_trials(finished)
    assert len(kept) == sum(result.case.trials - 1 for result in finished.results)
    assert [one.result.number for one in kept[:2]] == [1, 2]
    assert all(one.trial != one.result.worst.trial for one in kept)


def test_trials_are_numbers(finished):
    result = finished.results[0]
    told = spread_data(result, finished.outcomes[result.case.name])
    first = told["metrics"][0]
    column = result.statistics.names.index("cross_track_p95")
    assert first["values"] == pytest.approx(result.statistics.values[:, column], rel=1e-4)
    assert (first["unit"], told["trials"]) == ("m", [1, 2, 3])
    completion = next(one for one in told["metrics"] if one["words"] == "completion")
    assert (completion["unit"], completion["limit"], completion["comparison"]) == ("%", 100.0, ">=")
    assert spread_data(finished.results[2], finished.outcomes[finished.results[2].case.name]) is None
