"""How large a difference is, how sure, and what it is called."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from campaigns.difference import (
    BETTER,
    CHANCE,
    LESS,
    MIXED,
    MORE,
    SAME,
    SMALL,
    WORSE,
    Sample,
    above_zero,
    change_interval,
    difference,
    overall,
    paired,
    shares_differ,
)
from campaigns.limits import Limit

NONE = Limit()
OPPOSITE = {BETTER: WORSE, WORSE: BETTER, SAME: SAME, CHANCE: CHANCE, SMALL: SMALL}


def sample(values, seeds=None):
    values = np.array(values, dtype=float)
    return Sample(values, tuple(range(len(values))) if seeds is None else tuple(seeds))


def held(before, after, direction="lower", limit=NONE, chance=0.05):
    return difference("x", "m", direction, before, after, limit, chance)


def test_pairs_are_of_the_same_seed_in_whatever_order():
    old, new = paired(sample([1, 2, 3], [7, 8, 9]), sample([30, 10, 40], [9, 7, 5]))
    assert old.tolist() == [1, 3]
    assert new.tolist() == [10, 30]
    found = held(sample([1, 2, 3], [7, 8, 9]), sample([30, 10, 40], [9, 7, 5]))
    assert (found.pairs, found.before, found.after, found.change) == (2, 2.0, 20.0, 18.0)


def test_a_paired_difference_is_sure_where_the_weather_hides_it_from_two_samples():
    weather = np.random.default_rng(1).normal(0.0, 10.0, 20)
    shift = weather + 1.0 + 0.01 * np.arange(20)
    assert held(sample(weather), sample(shift)).outcome == WORSE
    assert held(sample(weather), sample(shift, range(100, 120))).outcome == CHANCE


def test_the_interval_of_a_mean_of_two_values_is_the_whole_range():
    # Means of two draws from {0, 1} are 0 and 1 in one case of four each
    assert change_interval((np.array([0.0, 1.0]),)) == (0.0, 1.0)


def test_one_trial_has_a_plain_difference():
    found = held(sample([1.0]), sample([1.5]), limit=Limit(0.1))
    assert (found.change, found.interval, found.pairs, found.outcome) == (0.5, None, 1, WORSE)
    assert held(sample([1.0]), sample([1.5]), limit=Limit(0.6)).outcome == SMALL


def test_what_matters_is_measured_by_the_larger_value():
    assert held(sample([100.0]), sample([109.0]), limit=Limit(0.0, 0.1)).outcome == SMALL
    assert held(sample([100.0]), sample([112.0]), limit=Limit(0.0, 0.1)).outcome == WORSE
    assert held(sample([112.0]), sample([100.0]), limit=Limit(0.0, 0.1)).outcome == BETTER


@pytest.mark.parametrize(
    ("direction", "up", "down"), [("lower", WORSE, BETTER), ("higher", BETTER, WORSE), ("neither", MORE, LESS)]
)
def test_words_follow_the_direction(direction, up, down):
    assert held(sample([1.0]), sample([2.0]), direction).outcome == up
    assert held(sample([2.0]), sample([1.0]), direction).outcome == down


VALUES = st.lists(st.floats(-100.0, 100.0), min_size=1, max_size=12)


@given(VALUES, VALUES, st.booleans())
def test_the_other_way_round_is_the_negative(a, b, common):
    one, two = sample(a), sample(b, range(len(b)) if common else range(100, 100 + len(b)))
    there, back = held(one, two, limit=Limit(0.5, 0.1)), held(two, one, limit=Limit(0.5, 0.1))
    assert there.change == -back.change
    assert there.limit == back.limit
    assert back.outcome == OPPOSITE[there.outcome]
    if there.interval is not None and a != b:
        assert there.interval == pytest.approx((-back.interval[1], -back.interval[0]), abs=1e-9)


@given(VALUES)
def test_a_sample_does_not_differ_from_itself(values):
    found = held(sample(values), sample(values))
    assert (found.change, found.outcome) == (0.0, SAME)


@pytest.mark.parametrize("trials", [3, 10])
@pytest.mark.parametrize("common", [True, False])
def test_chance_alone_is_seldom_called_a_difference(trials, common):
    rng = np.random.default_rng(5)
    seeds = range(trials) if common else range(100, 100 + trials)
    found = [held(sample(rng.normal(size=trials)), sample(rng.normal(size=trials), seeds)) for _ in range(300)]
    alarms = sum(one.outcome != CHANCE for one in found)
    assert alarms <= 24  # of 300 at 5 %: more are less likely than 1 %


def test_shares_by_exact_tests():
    # McNemar: 5 of 5 discordant pairs one way, 2 / 2^5; Fisher's tea: 3 of 4 against 1 of 4, 34 / 70
    assert shares_differ((np.array([1.0] * 5 + [0.0] * 9),)) == pytest.approx(0.0625)
    assert shares_differ((np.zeros(4),)) == 1.0
    tea = (np.array([1.0, 1.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0, 0.0]))
    assert shares_differ(tea) == pytest.approx(34 / 70)


def test_five_verdicts_of_twenty_may_be_chance_and_six_are_not():
    good = np.ones(20)
    for bad, outcome in ((5, CHANCE), (6, WORSE)):
        now = np.concatenate((np.zeros(bad), np.ones(20 - bad)))
        assert held(sample(good), sample(now), "higher").outcome == outcome


def test_student_by_hand():
    # Mean 2, variance 1, N = 3: t = 2 sqrt(3), and with two degrees of freedom P(T > t) = (1 - t / sqrt(2 + t^2)) / 2
    t = 2.0 * np.sqrt(3.0)
    assert above_zero((np.array([1.0, 2.0, 3.0]),)) == pytest.approx((1.0 - t / np.sqrt(2.0 + t * t)) / 2.0)
    assert above_zero((np.array([2.0, 2.0]),)) == 0.0
    assert above_zero((np.array([-2.0, -2.0]),)) == 1.0


def test_several_metrics_come_to_one_word():
    better, worse = held(sample([2.0]), sample([1.0])), held(sample([1.0]), sample([2.0]))
    same = held(sample([1.0]), sample([1.0]))
    assert [overall(x) for x in ([], [same], [same, better], [worse], [better, worse])] == [
        SAME, SAME, BETTER, WORSE, MIXED,
    ]  # fmt: skip
