import io
from types import SimpleNamespace

import pytest
from rich.console import Console

from campaigns.attempt import Attempt
from campaigns.runner import Task
from reports.terminal import progress

GOOD, BAD, FAILED = Attempt(1, passed=True), Attempt(1), Attempt(1, error="it stopped", kind="machinery")


def task(case, trial):
    return Task(SimpleNamespace(number=case), trial, 0, f"{case}-{trial}")


@pytest.fixture
def clock(monkeypatch):
    """A clock that the results of a campaign push on."""
    hand = SimpleNamespace(now=1000.0)
    monkeypatch.setattr(progress, "time", SimpleNamespace(monotonic=lambda: hand.now))
    return hand


def run(clock, tasks, results, total, seconds=1.0):
    """What comes out of `watched`, each result taking some seconds."""

    def arriving():
        for one, result in zip(tasks, results, strict=True):
            clock.now += seconds
            yield one, result

    return list(progress.watched(arriving(), tasks, total))


def lines(capsys):
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "\x1b" not in captured.err
    return captured.err.splitlines()


def test_every_result_is_passed_on_in_order(clock):
    tasks = [task(1, trial) for trial in range(5)]
    results = [Attempt(seed, passed=True) for seed in range(5)]
    assert run(clock, tasks, results, 5) == results


def test_a_line_every_ten_seconds_and_one_at_the_end(clock, capsys):
    tasks = [task(case, trial) for case in (1, 2) for trial in range(20)]
    run(clock, tasks, [GOOD] * 40, 40)
    assert lines(capsys) == [
        "10/40 trials, 30 s left, 0/2 cases, 1 trials/s",
        "20/40 trials, 20 s left, 1/2 cases, 1 trials/s",
        "30/40 trials, 10 s left, 1/2 cases, 1 trials/s",
        "40/40 trials, 2/2 cases, 1 trials/s",
    ]


def test_what_went_wrong_is_counted_errors_apart_from_verdicts(clock, capsys):
    tasks = [task(1, trial) for trial in range(20)]
    run(clock, tasks, [BAD, BAD, *[GOOD] * 10, FAILED, *[GOOD] * 7], 20)
    assert lines(capsys) == [
        "10/20 trials, 10 s left, 0/1 cases, 1 trials/s, 2 trials not as expected",
        "20/20 trials, 1/1 cases, 1 trials/s, 2 trials not as expected, 1 error",
    ]


def test_hundreds_of_quick_trials_are_one_line(clock, capsys):
    tasks = [task(1, trial) for trial in range(400)]
    run(clock, tasks, [GOOD] * 400, 400, seconds=0.005)
    assert lines(capsys) == ["400/400 trials, 1/1 cases, 200 trials/s"]


def test_a_thousand_trials_a_second_is_written_out(clock, capsys):
    tasks = [task(1, trial) for trial in range(400)]
    run(clock, tasks, [GOOD] * 400, 400, seconds=0.0005)
    assert lines(capsys) == ["400/400 trials, 1/1 cases, 2000 trials/s"]


def test_earlier_trials_count_as_done_but_not_for_the_rate(clock, capsys):
    tasks = [task(1, trial) for trial in range(20)]
    run(clock, tasks, [GOOD] * 20, 100)
    assert lines(capsys) == [
        "90/100 trials, 10 s left, 0/1 cases, 1 trials/s",
        "100/100 trials, 1/1 cases, 1 trials/s",
    ]


def test_with_nothing_to_do_that_is_said(clock, capsys):
    assert run(clock, [], [], 100) == []
    assert lines(capsys) == ["all 100 trials are done; the report follows"]


def test_a_terminal_shows_a_bar_that_leaves_nothing_behind(clock, monkeypatch):
    file = io.StringIO()
    console = Console(file=file, force_terminal=True, width=100)
    monkeypatch.setattr(progress, "Console", lambda stderr: console)
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    tasks = [task(1, trial) for trial in range(3)]
    assert run(clock, tasks, [GOOD, BAD, FAILED], 5) == [GOOD, BAD, FAILED]
    shown = file.getvalue()
    assert "5/5" in shown
    assert "1 trial not as expected, 1 error" in shown
    assert shown.endswith("\x1b[2K")  # the line is erased
