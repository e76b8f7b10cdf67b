import io
from dataclasses import replace

import pytest
from rich.console import Console

from campaigns.comparison import Comparison
from campaigns.gate import APPEARED, ERRORS, VERDICT, WORSE, Check, Finding
from campaigns.limits import DEFAULT_LIMITS
from reports.terminal.check_text import conclusion, improved_words, print_check, told, with_unit

P95 = Comparison(
    case="road", metric="cross_track_p95", unit="m", old=0.123456, new=0.234567, worse=0.111111, limit=0.0061728,
    regressed=True, improved=False, trial=7, seed=8123456789012345,
)  # fmt: skip
COMMAND = "trackworthy run out/campaign.toml --case road --trial 7"
NASTY = ["a | b", "`ls`", "<script>alert(1)</script>", "50 %, a: b", "🚚 Lkw", "[bold]x[/]", r"back\slash", "'quoted'"]


def worse(one, command=COMMAND):
    return Finding(WORSE, one.case, f"{one.metric} is worse", one, one.trial, one.seed, command)


def check_of(*findings, improved=(), others=()):
    compared = [finding.comparison for finding in findings if finding.comparison]
    return Check("nightly", (*compared, *improved, *others), findings, improved)


def printed(check, width=80):
    file = io.StringIO()
    print_check(check, Console(file=file, width=width, highlight=False))
    return file.getvalue()


def row_of(text, metric):
    (row,) = (line for line in text.splitlines() if line.startswith(f"{metric} "))
    return row.split()


def test_a_worse_metric_is_a_row_of_old_new_change_limit_unit_and_trial():
    text = printed(check_of(worse(P95)))
    assert row_of(text, "metric") == ["metric", "was", "is", "worse", "by", "allowed", "trial"]
    assert row_of(text, "cross_track_p95") == ["cross_track_p95", "0.1235", "0.2346", "0.1111", "0.006173", "m", "7"]


def test_the_command_stands_alone_on_its_line_under_trial_and_seed():
    lines = printed(check_of(worse(replace(P95, case="road " * 30), f"{COMMAND} {'long ' * 40}end"))).splitlines()
    at = lines.index("worst in trial 7 (seed 8123456789012345):")
    assert lines[at + 1] == f"  {COMMAND} {'long ' * 40}end"


def test_metrics_that_one_trial_shows_share_its_command():
    rms = replace(P95, metric="cross_track_rms")
    text = printed(check_of(worse(P95), worse(rms)))
    assert text.count(COMMAND) == 1
    assert row_of(text, "cross_track_p95")
    assert row_of(text, "cross_track_rms")


def test_each_case_has_a_table_of_its_own():
    text = printed(check_of(worse(P95), worse(replace(P95, case="air", new=0.5), "other")))
    lines = [line.rstrip() for line in text.splitlines()]
    assert lines.index("road") < lines.index("air")
    assert [line.split()[2] for line in lines if line.startswith("cross_track_p95")] == ["0.2346", "0.5"]


@pytest.mark.parametrize("metric", DEFAULT_LIMITS)
def test_in_80_columns_no_value_is_wrapped_or_shortened(metric):
    one = replace(P95, metric=metric, unit="m/s^2", old=0.0012344, new=0.123446, worse=0.122214, limit=0.12, trial=99)
    text = printed(check_of(worse(one)))
    assert row_of(text, metric) == [metric, "0.001234", "0.1234", "0.1222", "0.12", "m/s²", "99"]
    assert max(map(len, text.split("\n\n")[0].splitlines())) <= 80


def test_the_longest_numbers_of_the_longest_metric_fit_as_well():
    one = replace(
        P95, metric="lateral_acceleration_demanded", unit="m/s^2", old=0.00012344, new=0.00099994, worse=0.00087654,
        limit=0.00034567, trial=99_999,
    )  # fmt: skip
    text = printed(check_of(worse(one)))
    assert row_of(text, one.metric) == [
        one.metric, "0.0001234", "0.0009999", "0.0008765", "0.0003457", "m/s²", "99999",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("value", "unit", "shown"),
    [
        (0.98764, "share", "98.76 %"),
        (0.00123456, "share", "0.1235 %"),
        (12.3456, "deg", "12.35°"),
        (1.5, "deg/s", "1.5°/s"),
        (5.88399, "m/s^2", "5.884 m/s²"),
        (2.0, "1", "2"),
        (1.23456, "g", "1.235 g"),
        (123456.7, "m", "123457 m"),
        (-4.25, "m", "−4.25 m"),
        (0.0, "s", "0 s"),
    ],
)
def test_values_have_four_digits_and_their_unit(value, unit, shown):
    assert with_unit(value, replace(P95, unit=unit)) == shown


def test_a_finding_is_told_with_old_new_change_and_limit():
    assert told(worse(P95)) == "cross_track_p95 was 0.1235 m, is 0.2346 m: worse by 0.1111 m, allowed 0.006173 m"
    assert told(Finding(APPEARED, "road", "the case is not in the baseline")) == "the case is not in the baseline"


@pytest.mark.parametrize("name", NASTY)
def test_any_name_is_printed_as_it_is(name):
    one = replace(P95, case=name)
    flipped = Finding(VERDICT, name, "was trackworthy, is not-trackworthy", None, 3, 5, f"run --case {name} --trial 3")
    text = printed(check_of(worse(one, f"run --case {name} --trial 7"), flipped, improved=(one,)))
    lines = [line.rstrip() for line in text.splitlines()]
    assert name in lines  # above its table
    assert f"verdict  {name}: was trackworthy, is not-trackworthy" in lines
    assert f"  run --case {name} --trial 7" in lines
    assert f"  run --case {name} --trial 3" in lines
    assert f"improved: {name}: cross_track_p95 0.1235 m to 0.2346 m; --update makes that the baseline" in lines


def test_a_word_between_colons_stays_one():
    one = replace(P95, case=":truck:")
    text = printed(check_of(worse(one, "run --case :truck: --trial 7"), improved=(one,)))
    assert "  run --case :truck: --trial 7\n" in text
    assert "improved: :truck:: cross_track_p95 " in text


def test_what_changed_about_a_case_is_a_line_with_its_kind():
    failed = Finding(ERRORS, "air", "2 of 5 trials failed to run, 0 did before: the simulator stopped " + 30 * "again ")
    lines = printed(check_of(failed)).splitlines()
    assert lines[0] == f"errors  air: {failed.message}"
    assert len(lines) == 2


def test_piped_there_is_no_colour():
    assert "\x1b" not in printed(check_of(worse(P95), Finding(ERRORS, "air", "failed")))


def test_the_last_line_is_the_answer():
    air = replace(P95, case="air", regressed=False)
    assert printed(check_of(others=(P95, air))) == "AS GOOD AS THE BASELINE  2 metrics of 2 cases compared\n"
    found = check_of(worse(P95), Finding(APPEARED, "new", "x"), Finding(ERRORS, "air", "x"), others=(air,))
    answer = "NOT AS THE BASELINE  1 worse, 2 other changes; 2 metrics of 2 cases compared"
    assert printed(found).splitlines()[-1] == answer
    one_other = check_of(Finding(APPEARED, "new", "x"), others=(P95,))
    assert conclusion(one_other) == "NOT AS THE BASELINE  1 other change; 1 metric of 1 case compared"


def test_no_more_than_three_improvements_are_named():
    names = ["cross_track_rms", "cross_track_p50", "cross_track_p95", "cross_track_p99", "cross_track_max"]
    better = tuple(replace(P95, metric=name, old=2.0, new=1.0, worse=-1.0) for name in names)
    words = improved_words(check_of(improved=better))
    assert words.startswith("road: cross_track_rms 2 m to 1 m; road: cross_track_p50 2 m to 1 m; ")
    assert words.endswith("cross_track_p95 2 m to 1 m and 2 more; --update makes that the baseline")
    assert "and" not in improved_words(check_of(improved=better[:3]))
