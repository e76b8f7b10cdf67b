import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from campaigns.case import Case
from campaigns.conditions import ConditionKeys, WindKeys
from campaigns.distribution import Distribution
from campaigns.seeds import SEED_BITS, digest, plan_seed, trial_seed
from planners.typed_toml import convert

CASE = Case(path="line.csv", vehicle="c172x", scenario="valley.toml", conditions=ConditionKeys(wind="10@270"))


def changed(**settings):
    return msgspec.structs.replace(CASE, **settings)


@pytest.mark.parametrize(
    "settings",
    [
        {"vehicle": "truck"},
        {"controller": "l1"},
        {"speed": "40m/s"},
        {"altitude": 500.0},
        {"planner": "straight"},
        {"plan_seed": 5},
        {"path": "other.csv"},
        {"name": "another name"},
        {"corridor": 12.0},
        {"corners": "fly-by"},
        {"steering_hz": 2.0},
        {"require": ("cross_track_p95 <= 1",)},
        {"expect": "not-trackworthy"},
        {"trials": 500},
        {"pass_share": 0.5},
        {"scenario": "moved/to/valley.toml"},
        {"scenario": "valley"},
    ],
    ids=str,
)
def test_the_same_weather_meets_all_that_is_compared(settings):
    assert trial_seed(1, changed(**settings), 1) == trial_seed(1, CASE, 1)


@pytest.mark.parametrize(
    "settings",
    [
        {"scenario": "mountain.toml"},
        {"scenario": None},
        {"conditions": ConditionKeys(wind="10@271")},
        {"conditions": ConditionKeys(wind="10@270", latency=0.1)},
        {"conditions": ConditionKeys(wind="10@270", turbulence="severe")},
        {"conditions": ConditionKeys(wind=WindKeys(Distribution(normal=(10.0, 1.0)), 270.0))},
    ],
    ids=str,
)
def test_another_scenario_or_other_conditions_have_weather_of_their_own(settings):
    assert trial_seed(1, changed(**settings), 1) != trial_seed(1, CASE, 1)


def test_another_campaign_seed_or_trial_has_weather_of_its_own():
    assert trial_seed(2, CASE, 1) != trial_seed(1, CASE, 1)
    assert trial_seed(1, CASE, 2) != trial_seed(1, CASE, 1)
    assert trial_seed(1, CASE, 2) != trial_seed(2, CASE, 1)


def test_numbers_count_and_not_how_they_are_written():
    """`mass = 1` and `mass = 1.0` are the same number, and the key may be left out where it is the default."""
    seeds = {
        trial_seed(1, convert({"path": "p", "vehicle": "v", "conditions": conditions}, Case, "file"), 1)
        for conditions in ({}, {"mass": 1}, {"mass": 1.0}, {"latency": 0, "mass": 1})
    }
    assert len(seeds) == 1


@given(st.integers(-(2**63), 2**63), st.integers(1, 1_000_000))
def test_a_seed_fits_in_the_whole_numbers_of_a_double(campaign_seed, trial):
    assert SEED_BITS == 53
    seed = trial_seed(campaign_seed, CASE, trial)
    assert 0 <= seed < 2**53
    assert int(float(seed)) == seed


def test_seeds_do_not_collide_and_use_every_bit():
    """10,000 of 2^53: the chance of two alike is 6e-9. Each bit is set in half of them, within five deviations."""
    seeds = [trial_seed(campaign_seed, CASE, trial) for campaign_seed in range(10) for trial in range(1, 1001)]
    assert len(set(seeds)) == len(seeds)
    for bit in range(53):
        assert abs(sum(seed >> bit & 1 for seed in seeds) - 5000) < 5 * 50


def test_a_plan_has_a_seed_of_its_own():
    one = plan_seed(1, CASE)
    assert one != trial_seed(1, CASE, 0)
    assert plan_seed(1, changed(plan_seed=1)) != one
    assert plan_seed(2, CASE) != one
    assert plan_seed(1, changed(scenario="mountain.toml")) != one
    for settings in (
        {"vehicle": "truck"},
        {"conditions": ConditionKeys()},
        {"trials": 7},
        {"scenario": "x/valley.toml"},
    ):
        assert plan_seed(1, changed(**settings)) == one


def test_the_hash_is_sha_256_of_the_parts():
    """By another program: `printf '["a",1]' | sha256sum`."""
    assert digest("a", 1) == "135f17a475a61afdeeaf3759ad2e45ad1c7abb192395abe47e41fc8e395dc1a9"
    assert digest({"b": 1, "a": 2}) == digest({"a": 2, "b": 1})
    assert digest("ab", "c") != digest("a", "bc")


def test_seeds_are_pinned():
    """These must never change: another hash changes the weather of every campaign
    that anybody has run, and all results with it. It needs a new schema version and a line in the changelog.
    """
    assert trial_seed(1, CASE, 1) == 4994446542207622
    assert trial_seed(0, Case(path="p.csv", vehicle="truck"), 7) == 8202011520414068
    assert plan_seed(1, CASE) == 463167958
