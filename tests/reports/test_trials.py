import dataclasses
import json
import re

import numpy as np
import pytest
from PIL import Image

from campaigns.conditions import ConditionKeys, WindKeys
from campaigns.distribution import Distribution
from reports.figures.style import save, style
from reports.figures.track_figure import track_figure
from reports.figures.trials_data import strips
from reports.figures.trials_figure import trials_figure
from reports.pages.pdf_rows import counts, summary_rows
from reports.pages.pdf_trials import trials_data
from reports.words.campaign_words import case_verdict_words
from reports.words.condition_words import condition_words
from reports.words.names import listed
from reports.words.trials_words import worst_name
from sample_results import result_of
from small_reports import pdf_of
from tracking.profile import PIECES


def drawn(result, outcome):
    with style():
        return trials_figure(result, outcome)


def line(axes, label):
    return next(line for line in axes.lines if line.get_label() == label)


def area(axes, label):
    """Lower and upper edge of a filled band, by its places."""
    band = next(one for one in axes.collections if one.get_label() == label)
    points = band.get_paths()[0].vertices
    places = np.unique(points[:, 0])
    edges = [points[points[:, 0] == x, 1] for x in places]
    return places, np.array([e.min() for e in edges]), np.array([e.max() for e in edges])


def test_the_band_drawn_is_the_band_given(yard):
    result = result_of(yard)
    band, axes = result.statistics.band, drawn(result, yard).axes[0]
    places, low, high = area(axes, "95 % bootstrap band")
    assert places == pytest.approx((np.arange(PIECES) + 0.5) * yard.path.length / PIECES)
    assert low == pytest.approx(band.low)
    assert high == pytest.approx(band.high)
    assert line(axes, "median").get_ydata() == pytest.approx(band.median)


def test_bias_and_spread_are_those_given(yard):
    result = result_of(yard)
    band, axes = result.statistics.band, drawn(result, yard).axes[1]
    _, low, high = area(axes, "± spread of the trials")
    assert line(axes, "bias: mean of the trials").get_ydata() == pytest.approx(band.bias)
    assert low == pytest.approx(band.bias - band.spread)
    assert high == pytest.approx(band.bias + band.spread)


def test_the_worst_trial_and_the_corridor_are_drawn(sharp_yard):
    result = result_of(sharp_yard, bad=2)
    axes = drawn(result, sharp_yard).axes[0]
    assert worst_name(result) == "worst of 8: trial 8"
    assert line(axes, "worst of 8: trial 8").get_ydata().max() == pytest.approx(
        np.abs(sharp_yard.track["cross_track"]).max()
    )
    assert line(axes, "corridor 0.5 m").get_ydata() == [0.5, 0.5]
    assert axes.get_ylim()[1] > 0.5


def test_dots_are_the_shares_of_the_limits(yard):
    result = result_of(yard, bad=2)
    shown = {one.metric: one for one in strips(result.statistics, yard)}
    assert list(shown)[:2] == ["cross_track_p95", "cross_track_max"]
    errors = result.statistics.values[:, result.statistics.names.index("cross_track_max")]
    assert shown["cross_track_max"].used == pytest.approx(errors / yard.corridor)
    assert shown["cross_track_max"].missed == 2
    assert shown["cross_track_max"].stated
    assert shown["cross_track_p95"].limit == yard.corridor
    assert not shown["cross_track_p95"].stated
    assert "completion" not in shown


def test_dots_far_beyond_the_limit_stand_at_the_edge(yard):
    result = result_of(yard, bad=1)
    axes = drawn(result, yard).axes[2]
    places = np.concatenate([dots.get_offsets()[:, 0] for dots in axes.collections])
    assert axes.get_xlim() == (0.0, 2.0)
    assert places.max() == 2.0
    assert len(places) == 8 * len(axes.get_yticks())
    assert "beyond 200 %" in axes.get_xlabel()


@pytest.mark.parametrize("name", ["route", "yard", "sharp_yard"])
def test_nothing_runs_out_of_the_figure_or_into_its_neighbour(name, request):
    outcome = request.getfixturevalue(name)
    with style():
        figure = trials_figure(result_of(outcome, trials=1000), outcome)
        drawn = figure.get_tightbbox()
        assert drawn.x0 >= 0.0
        assert drawn.y0 >= 0.0
        assert drawn.x1 <= figure.get_size_inches()[0]
        assert drawn.y1 <= figure.get_size_inches()[1]
        for axes in figure.axes[:2]:
            assert axes.get_legend().get_window_extent().x0 > axes._left_title.get_window_extent().x1


@pytest.mark.parametrize(("suffix", "trials"), [("png", 8), ("svg", 8), ("svg", 2000)])
def test_figure_is_the_same_bytes_and_small(yard, suffix, trials, tmp_path):
    files = [tmp_path / f"{name}.{suffix}" for name in "ab"]
    for file in files:
        with style():
            save(trials_figure(result_of(yard, trials), yard), file)
    assert files[0].read_bytes() == files[1].read_bytes()
    assert files[0].stat().st_size < 1_000_000
    if suffix == "png":
        with Image.open(files[0]) as image:
            assert image.width == 1600


def test_figure_says_the_verdict_of_the_case(sharp_yard):
    assert not sharp_yard.verdict.trackworthy
    result = result_of(sharp_yard, pass_share=0.5)
    words = "\n".join(text.get_text() for text in drawn(result, sharp_yard).texts)
    assert "✓ TRACKWORTHY" in words
    assert "7 of 8 trials trackworthy" in words
    assert "at least 50 % must be" in words


def test_track_figure_of_a_trial_says_which(yard):
    with style():
        words = "\n".join(text.get_text() for text in track_figure(yard, trial="worst of 8: trial 8").texts)
    assert "worst of 8: trial 8 · truck" in words


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ({"bad": 0}, "TRACKWORTHY"),
        ({"bad": 1}, "NOT TRACKWORTHY"),
        ({"bad": 1, "pass_share": 0.5}, "TRACKWORTHY"),
        ({"bad": 1, "expect": "not-trackworthy"}, "NOT TRACKWORTHY (as expected)"),
        ({"bad": 0, "expect": "not-trackworthy"}, "TRACKWORTHY (expected not to be)"),
        ({"errors": 1}, "FAILED TO RUN"),
    ],
)
def test_verdict_words(yard, case, words):
    assert case_verdict_words(result_of(yard, **case)) == words


def named(outcome, name):
    return dataclasses.replace(outcome, name=name)


def test_rows_say_the_verdict_of_the_case_and_name_the_worst(sharp_yard):
    result = result_of(sharp_yard, pass_share=0.5)
    (row,) = summary_rows([sharp_yard], [result], {sharp_yard.name: 0})
    assert (row["verdict"], row["passed"]) == ("trackworthy", True)
    assert row["why"].startswith("7 of 8 trials trackworthy (47.3 to 99.7 %)")
    assert "95 % of the way within" in row["more"][0]
    assert row["more"][1].startswith("worst of 8: trial 8, not trackworthy: cross-track error")


def test_counts_are_of_cases(yard, sharp_yard):
    outcomes = [named(sharp_yard, name) for name in ("good", "poor", "broken")]
    good, poor, broken = outcomes
    results = [
        result_of(good, pass_share=0.5),
        result_of(poor),
        result_of(broken, errors=3),
        result_of(named(yard, "never ran"), trials=4, bad=0, errors=4),
    ]
    rows = summary_rows(outcomes, results, {"good": 0, "poor": 1, "broken": 2})
    assert [row["verdict"] for row in rows] == ["trackworthy", "not-trackworthy", "error", "error"]
    assert [row["page"] for row in rows] == [0, 1, 2, None]
    assert rows[2]["why"] == "3 of 8 trials failed to run: it fell over"
    assert counts(rows) == {"total": 4, "passed": 1, "failed": 1, "worthy": 1, "unworthy": 1, "errors": 2}


def test_a_case_of_one_trial_is_told_by_its_run(yard):
    result = result_of(yard, trials=1, bad=0)
    assert summary_rows([yard], [result], {yard.name: 0}) == summary_rows([yard], [], {})


def test_a_case_without_a_page_has_a_row(yard):
    (row,) = summary_rows([], [result_of(yard)], {})
    assert (row["vehicle"], row["conditions"], row["page"]) == ("truck", ["8 m/s (28.8 km/h)"], None)
    assert row["verdict"] == "not-trackworthy"


def test_the_table_says_how_many_trials_meet_each_requirement(yard):
    told = trials_data(result_of(yard, bad=2), yard, "f.svg")
    metrics = {row["words"]: row for row in told["metrics"]}
    error = metrics[listed("cross_track_max")]
    assert (error["limit"], error["kept"], error["met"]) == ("≤ 0.5 m", "6 of 8", False)
    assert error["worst"] == "1.15 m"
    assert error["trial"] == "8"
    assert metrics["completion"]["kept"] == "8 of 8"
    assert metrics[listed("cross_track_p95")]["limit"] == ""


def pages(file):
    return len(re.findall(rb"/Type\s*/Page\b", file.read_bytes()))


def test_pdf_of_trials(yard, sharp_yard, tmp_path):
    once = named(yard, "once")
    results = [
        result_of(yard, conditions=ConditionKeys(friction=Distribution(uniform=(0.6, 0.9)))),
        result_of(once, trials=1, bad=0),
        result_of(sharp_yard, trials=4, bad=0, errors=3),
        result_of(named(yard, "never ran"), trials=1, bad=0, errors=1),
    ]
    for name in ("a.pdf", "b.pdf"):
        pdf_of([yard, once, sharp_yard], tmp_path / name, "Trials", commands=["x"] * 3, results=results)
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    assert pages(tmp_path / "a.pdf") == 1 + 1 + 2 + (2 + 1 + 2) + 1  # first, matrix, scenario, cases, appendix


def test_what_is_told_is_json(route):
    json.dumps(trials_data(result_of(route), route, ""), allow_nan=False)


def test_conditions_in_words():
    keys = ConditionKeys(
        wind=WindKeys(Distribution(weibull=(2.0, 6.0)), Distribution(uniform=(0.0, 360.0))),
        cross_track_offset=Distribution(normal=(0.0, 0.1)),
        latency=0.1,
    )
    assert condition_words(keys) == [
        "wind Weibull of shape 2, scale 6 m/s, from 0 to 360°",
        "start to the left by 0 ± 0.1 m",
        "latency 0.1 s",
    ]
    assert condition_words(ConditionKeys(wind="8@320")) == ["wind 8 m/s from 320°"]
    assert condition_words(ConditionKeys()) == []
