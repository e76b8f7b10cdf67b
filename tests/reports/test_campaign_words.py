import dataclasses

import numpy as np
import pytest

from campaigns.attempt import Measured
from campaigns.case import Case
from campaigns.statistics import statistics
from campaigns.store import Row
from campaigns.summary import CaseResult
from reports.words.campaign_words import case_line, mark, share_words, spread_words
from reports.words.words import reason, sentence
from tracking.profile import PIECES

UNITS = {"cross_track_p95": ("m", "lower")}


def row(trial, good=True, value=0.1, error="", profile=0.0):
    return Row(
        trial, 100 + trial, error, "machinery" if error else "", good, good, 0.1 if good else -0.1, "cross_track_max",
        "completed", {} if error else {"cross_track_p95": Measured(value, None, None)},
        b"" if error else np.full(PIECES, profile, np.float32).tobytes(),
    )  # fmt: skip


def result_of(rows, **keys):
    case = Case(path="line.csv", vehicle="truck", name="road", trials=len(rows), **keys)
    better = {name: direction for name, (_, direction) in UNITS.items()}
    return CaseResult(1, case, statistics(rows, better), UNITS)


def trials(good, bad):
    return [row(trial, trial <= good, 0.1 + 1e-6 * trial) for trial in range(1, good + bad + 1)]


def test_trials_that_do_not_differ_have_no_interval():
    rows = [row(trial) for trial in (1, 2, 3)]
    assert share_words(result_of(rows)) == "3 of 3 trials trackworthy, all alike: nothing in them is random"
    lost = [row(1), row(2), row(3, good=False)]
    assert share_words(result_of(lost)).startswith("2 of 3 trials trackworthy (9.43 ")


@pytest.mark.parametrize(
    ("good", "bad", "words"),
    [
        # Clopper and Pearson's exact intervals; where all are alike, their closed form 0.025^(1/n)
        (20, 0, "20 of 20 trials trackworthy (83.2 to 100 %)"),
        (0, 20, "0 of 20 trials trackworthy (0 to 16.8 %)"),
        (18, 2, "18 of 20 trials trackworthy (68.3 to 98.8 %)"),
        (1, 0, "1 of 1 trials trackworthy (2.5 to 100 %)"),
    ],
)
def test_a_share_comes_with_its_interval(good, bad, words):
    assert share_words(result_of(trials(good, bad))) == words


@pytest.mark.parametrize(
    ("good", "bad", "keys", "shown"),
    [
        (4, 0, {}, "pass "),
        (3, 1, {}, "FAIL "),
        (3, 1, {"pass_share": 0.75}, "pass "),
        (3, 1, {"pass_share": 0.76}, "FAIL "),
        (3, 1, {"expect": "not-trackworthy"}, "pass "),
        (3, 1, {"expect": "not-trackworthy", "pass_share": 0.75}, "FAIL "),
        (4, 0, {"expect": "not-trackworthy"}, "FAIL "),
    ],
)
def test_a_case_is_marked_by_its_verdict_against_the_expected_one(good, bad, keys, shown):
    assert mark(result_of(trials(good, bad), **keys)) == shown


@pytest.mark.parametrize("expect", ["trackworthy", "not-trackworthy"])
def test_a_trial_that_failed_to_run_makes_an_error_of_the_case(expect):
    rows = [row(1), row(2, error="the simulator stopped"), row(3, error="no path")]
    result = result_of(rows, expect=expect, pass_share=0.0)
    assert case_line(result, None) == "error road: 2 of 3 trials: the simulator stopped"
    assert case_line(result_of([row(1, error="no path")]), None) == "error road: no path"


def test_the_headline_is_the_median_the_p95_and_the_worst():
    rows = [row(trial, value=0.01 * trial) for trial in range(1, 102)]
    (first, _) = spread_words(result_of(rows))
    assert first == "95 % of the way within 0.51 m (median), 0.96 m (p95), 1.01 m (worst)"


def test_steady_bias_stands_apart_from_the_spread():
    rows = [row(1, profile=0.2), row(2, profile=0.4)]
    assert spread_words(result_of(rows))[-1] == "bias 0.3 m, spread 0.1 m"


def test_without_the_headline_metric_bias_and_spread_remain():
    rows = [dataclasses.replace(row(1), metrics={}), dataclasses.replace(row(2), metrics={})]
    assert spread_words(result_of(rows)) == ["bias 0 m, spread 0 m"]


def test_one_trial_is_told_as_a_run(yard):
    assert case_line(result_of([row(1)]), yard) == f"pass  road: {sentence(yard)}"
    assert case_line(result_of([row(1, good=False)]), None) == "FAIL  road: NOT TRACKWORTHY"


def test_many_trials_are_told_with_the_worst_and_why(sharp_yard):
    rows = [row(1), row(2, good=False), row(3)]
    line = case_line(result_of(rows), sharp_yard)
    assert line.startswith("FAIL  road: 2 of 3 trials trackworthy (9.43 to 99.2 %); 95 % of the way within 0.1 m")
    assert line.endswith(f"; worst: trial 2, {reason(sharp_yard)}")
    assert "worst: trial" not in case_line(result_of(rows), None)
