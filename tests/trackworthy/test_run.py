import json
import os
import re
import sqlite3
import subprocess
import sys
from contextlib import contextmanager

import pytest

from campaigns.campaign import CAMPAIGNS_FOLDER
from campaigns.lanes import Lanes
from reports.terminal import table
from small_campaigns import Here
from trackworthy.__main__ import main

CASE = '[[case]]\npath = "line.csv"\nvehicle = "truck"\n'
# Up to 0.9 m beside its path, in a corridor of 0.5 m: some trials are trackworthy, some are not
BESIDE = CASE + "speed = 10\ntrials = 8\nconditions.cross_track_offset = { uniform = [0.1, 0.9] }\n"


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "line.csv").write_text("x,y\n0,0\n30,0\n60,0\n")
    (tmp_path / "corner.csv").write_text("x,y\n0,0\n60,0\n60,60\n")


@pytest.fixture
def here(monkeypatch):
    """Trials in this process, one after the other; gives how many each run tried."""
    from campaigns import execute

    tried, run_trials = [], execute.run_trials

    @contextmanager
    def lanes(machines, timeout):
        yield Lanes(Here(), 1)

    def counted(campaign, tasks, *others):
        tried.append(len(tasks))
        return run_trials(campaign, tasks, *others)

    monkeypatch.setattr(execute.Machines, "lanes", lanes)
    monkeypatch.setattr(execute, "run_trials", counted)
    return tried


@pytest.fixture
def no_report(monkeypatch):
    """Results without figures and PDF, which take longer than short trials."""
    monkeypatch.setattr("reports.write.write_report", lambda *_: [])


def campaign(tmp_path, text):
    (tmp_path / "mine.toml").write_text('name = "mine"\n' + text)
    return "mine.toml"


def test_quickstart_is_as_expected_and_writes_its_report(tmp_path, capfd):
    assert main(["run", "quickstart", "-o", "out"]) == 0
    out = capfd.readouterr().out
    assert "4 of 4 cases as expected" in out
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")
    assert len(list((tmp_path / "out" / "figures").glob("[1-4]-*.png"))) == 4
    verdicts = [
        case["trackworthy"] == 1 for case in json.loads((tmp_path / "out" / "summary.json").read_text())["cases"]
    ]
    assert verdicts == [True, True, True, False]


def test_without_a_name_it_runs_the_papers(capfd):
    assert main(["run", "--dry-run"]) == 0
    assert "truck, arcs target-vehicle-71m 60km/h" in capfd.readouterr().out


def test_quickstart_ships_with_the_program():
    assert (CAMPAIGNS_FOLDER / "quickstart" / "valley-survey.plan").is_file()


@pytest.mark.usefixtures("here")
def test_an_unexpected_verdict_is_exit_code_1(tmp_path, capfd):
    assert main(["run", campaign(tmp_path, CASE.replace("line", "corner") + 'speed = "60km/h"\n')]) == 1
    assert "FAIL" in capfd.readouterr().out
    assert (tmp_path / "runs" / "mine" / "report.pdf").is_file()


@pytest.mark.usefixtures("here", "no_report")
def test_a_case_that_cannot_be_tried_costs_itself_only(tmp_path, capfd):
    assert main(["run", campaign(tmp_path, CASE + "speed = [10, 400, 9]\n")]) == 2
    out = capfd.readouterr().out
    assert out.count("pass") == 2
    assert "the truck cannot drive at 400 m/s" in out
    summary = json.loads((tmp_path / "runs" / "mine" / "summary.json").read_text())
    assert [case["errors"] for case in summary["cases"]] == [0, 1, 0]


def test_lists_multiply_out(tmp_path):
    from campaigns.campaign import load_campaign

    loaded = load_campaign(campaign(tmp_path, CASE + 'speed = ["30km/h", 12]\ncontroller = ["l1", "lqr"]\n'))
    assert [case.name for case in loaded.cases] == [
        "line 30km/h l1",
        "line 30km/h lqr",
        "line 12 l1",
        "line 12 lqr",
    ]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (CASE + "speeed = 10\n", "did you mean 'speed'"),
        (CASE.replace("line", "nowhere"), "nowhere.csv"),
        (CASE + CASE, "two cases are called 'line'"),
        (CASE + 'expect = "perhaps"\n', "expect"),
        ("case = []\n", "no cases"),
        ("[[case]\n", "TOML"),
        (CASE + 'speed = "fast"\n', "fast"),
    ],
)
def test_a_wrong_campaign_is_one_line_and_exit_code_2(tmp_path, capfd, text, told):
    assert main(["run", campaign(tmp_path, text)]) == 2
    captured = capfd.readouterr()
    assert captured.out == ""
    assert len(captured.err.strip().splitlines()) == 1
    assert told in captured.err


def test_an_unknown_campaign_names_those_there_are(capfd):
    assert main(["run", "slowstart"]) == 2
    assert "quickstart" in capfd.readouterr().err


@pytest.mark.usefixtures("here")
def test_one_case_can_be_repeated_alone(tmp_path, capfd):
    name = campaign(tmp_path, CASE + "speed = [10, 12]\n")
    assert main(["run", name, "--case", "line 12"]) == 0
    assert "1 of 1 case as expected" in capfd.readouterr().out
    assert (tmp_path / "runs" / "mine-line-12" / "report.pdf").is_file()
    assert main(["run", name, "--case", "line 13"]) == 2
    assert "no case 'line 13'; did you mean 'line 12'?" in capfd.readouterr().err


@pytest.mark.usefixtures("here", "no_report")
def test_notes_on_mission_files_are_told_once(capfd):
    assert main(["run", "quickstart", "--case", "valley survey"]) == 0
    assert capfd.readouterr().err.count("NAV_TAKEOFF") == 1


def stored(folder):
    """(trial, trackworthy, passed, metrics) of every row."""
    db = sqlite3.connect(folder / "results.sqlite")
    rows = db.execute("SELECT trial, trackworthy, passed, metrics FROM trials ORDER BY case_name, trial").fetchall()
    db.close()
    return [(trial, bool(good), bool(passed), json.loads(metrics)) for trial, good, passed, metrics in rows]


def everything(folder):
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}


# What is going to be run


def test_a_dry_run_shows_cases_and_trials_and_makes_nothing(tmp_path, capfd, here):
    name = campaign(tmp_path, BESIDE.replace("speed = 10", 'speed = [10, "45km/h"]') + CASE.replace("line", "corner"))
    before = everything(tmp_path)
    assert main(["run", name, "--dry-run", "-o", "out"]) == 0
    out, error = capfd.readouterr()
    lines = [line.split() for line in out.splitlines()]
    assert lines == [
        ["line", "10", "8", "line.csv,", "truck,", "lqr,", "10", "m/s"],
        ["line", "45km/h", "8", "line.csv,", "truck,", "lqr,", "12.5", "m/s"],
        ["corner", "1", "corner.csv,", "truck,", "lqr,", "12.5", "m/s"],
        ["3", "cases,", "17", "trials"],
    ]
    assert error == ""
    assert everything(tmp_path) == before
    assert here == []


def test_a_dry_run_of_one_case_shows_that_alone(tmp_path, capfd):
    name = campaign(tmp_path, CASE + "speed = [10, 12]\ntrials = 3\n")
    assert main(["run", name, "--dry-run", "--case", "line 12"]) == 0
    assert capfd.readouterr().out.splitlines()[-1] == "1 case, 3 trials"


def test_a_dry_run_of_a_wrong_campaign_is_exit_code_2(tmp_path):
    assert main(["run", campaign(tmp_path, CASE.replace("line", "nowhere")), "--dry-run"]) == 2


# One trial again


@pytest.mark.usefixtures("here", "no_report")
def test_a_replayed_trial_is_the_stored_one_and_is_shown_whole(tmp_path, capfd, monkeypatch):
    name = campaign(tmp_path, BESIDE)
    main(["run", name, "-o", "out"])
    rows, shown = stored(tmp_path / "out"), []
    print_outcome = table.print_outcome
    monkeypatch.setattr(table, "print_outcome", lambda outcome: (shown.append(outcome), print_outcome(outcome)))
    assert {good for _, good, *_ in rows} == {True, False}
    for trial, good, _, metrics in rows[:3]:
        capfd.readouterr()
        assert main(["run", name, "--case", "line", "--trial", str(trial)]) == (0 if good else 1)
        out, error = capfd.readouterr()
        again = {metric.name: metric.value if metric.valid else None for metric in shown[-1].metrics.values()}
        assert again == {metric: value for metric, (value, _, _) in metrics.items()}
        assert "cross_track_max" in out
        assert out.splitlines()[-1].startswith("TRACKWORTHY" if good else "NOT TRACKWORTHY")
        picture = tmp_path / "runs" / "mine-line" / f"trial-{trial}.png"
        assert picture.read_bytes().startswith(b"\x89PNG")
        assert f"saved runs/mine-line/trial-{trial}.png" in error
    assert len(list((tmp_path / "runs" / "mine-line" / "tracks").glob("*.parquet"))) == 3


@pytest.mark.usefixtures("here", "no_report")
def test_a_replay_leaves_the_results_in_its_folder_as_they_are(tmp_path):
    name = campaign(tmp_path, BESIDE)
    main(["run", name, "-o", "out"])
    before = everything(tmp_path / "out")
    main(["run", name, "-o", "out", "--trial", "1"])
    assert before.items() <= everything(tmp_path / "out").items()


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--case", "line 10", "--trial", "9"), "9 is no trial of 'line 10'; 1 to 8"),
        (("--case", "line 10", "--trial", "0"), "0 is no trial of 'line 10'; 1 to 8"),
        (("--case", "line 10", "--trial", "-1"), "-1 is no trial of 'line 10'; 1 to 8"),
        (("--case", "line 10", "--trial", "one"), "invalid int value: 'one'"),
        (("--trial", "1"), "it is a trial of one case; name that with --case"),
        (("--case", "line 10", "--case", "line 12", "--trial", "1"), "it is a trial of one case"),
        (("--jobs", "0"), "--jobs: 0 is no number of processes; give 1 or more"),
        (("-j", "-2"), "--jobs: -2 is no number of processes"),
        (("--case", "line"), "it has no case 'line'; did you mean 'line 12'?"),
    ],
)
def test_wrong_options_are_one_line_and_exit_code_2(tmp_path, capfd, arguments, told):
    name = campaign(tmp_path, BESIDE.replace("speed = 10", "speed = [10, 12]"))
    try:
        code = main(["run", name, "-o", "out", *arguments])
    except SystemExit as stop:
        code = stop.code
    out, error = capfd.readouterr()
    assert (code, out) == (2, "")
    assert len(error.strip().splitlines()) == 1
    assert told in error
    assert not (tmp_path / "out").exists()


# The folder of the results


@pytest.mark.usefixtures("no_report")
def test_a_finished_campaign_run_again_tries_nothing(tmp_path, capfd, here):
    name = campaign(tmp_path, BESIDE)
    code = main(["run", name, "-o", "out"])
    first, summary = capfd.readouterr(), (tmp_path / "out" / "summary.json").read_bytes()
    assert main(["run", name, "-o", "out"]) == code
    again = capfd.readouterr()
    assert here == [8, 0]
    assert again.out == first.out
    assert again.err == "all 8 trials are done; the report follows\n"
    assert (tmp_path / "out" / "summary.json").read_bytes() == summary


@pytest.mark.usefixtures("no_report")
def test_fresh_tries_all_again(tmp_path, capfd, here):
    name = campaign(tmp_path, BESIDE)
    main(["run", name, "-o", "out"])
    before = stored(tmp_path / "out")
    campaign(tmp_path, BESIDE.replace("speed = 10", "speed = 11"))
    capfd.readouterr()
    assert main(["run", name, "-o", "out"]) == 2
    assert "start anew with --fresh" in capfd.readouterr().err
    assert stored(tmp_path / "out") == before
    assert main(["run", name, "-o", "out", "--fresh"]) in (0, 1)
    assert here == [8, 8]
    after = stored(tmp_path / "out")
    assert len(after) == 8
    assert after != before


@pytest.mark.usefixtures("here")
def test_a_folder_that_is_not_there_is_made(tmp_path):
    assert main(["run", campaign(tmp_path, CASE), "-o", "deep/er/out"]) == 0
    assert (tmp_path / "deep" / "er" / "out" / "report.pdf").is_file()


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize(
    "options",
    [
        (),
        ("--trial", "1"),
    ],
)
@pytest.mark.parametrize("place", ["line.csv", "line.csv/inside", "/proc/inside"])
def test_a_folder_that_cannot_be_made_is_one_line_and_exit_code_2(tmp_path, capfd, place, options):
    assert main(["run", campaign(tmp_path, CASE), "-o", place, *options]) == 2
    error = capfd.readouterr().err
    assert len(error.strip().splitlines()) == 1
    assert error.startswith(f"trackworthy: {place}: cannot be written to: ")
    assert error.endswith("; give another with -o\n")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_inside_a_read_only_one_is_one_line_and_exit_code_2(tmp_path, capfd):
    (tmp_path / "locked").mkdir(mode=0o500)
    assert main(["run", campaign(tmp_path, CASE), "-o", "locked/out"]) == 2
    assert "locked/out: cannot be written to: Permission denied" in capfd.readouterr().err


# The verdict on many trials


@pytest.fixture
def share(tmp_path, here, no_report):
    """The share of trials of `BESIDE` that are trackworthy."""
    main(["run", campaign(tmp_path, BESIDE), "-o", "first"])
    rows = stored(tmp_path / "first")
    found = sum(good for _, good, *_ in rows) / len(rows)
    assert 0.0 < found < 1.0
    return found


def test_pass_share_and_expect_decide_over_many_trials(tmp_path, capfd, share):
    above = share + 0.01
    settings = [
        ("", "FAIL"), (f"pass_share = {share}", "pass"), (f"pass_share = {above}", "FAIL"),
        ('expect = "not-trackworthy"', "pass"), (f'expect = "not-trackworthy"\npass_share = {share}', "FAIL"),
        (f'expect = "not-trackworthy"\npass_share = {above}', "pass"),
    ]  # fmt: skip
    blocks = (BESIDE + f'name = "{i}"\n{keys}\n' for i, (keys, _) in enumerate(settings))
    capfd.readouterr()
    assert main(["run", campaign(tmp_path, "".join(blocks)), "-o", "out"]) == 1
    *lines, last = capfd.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [word for _, word in settings]
    assert all(f": {round(8 * share)} of 8 trials trackworthy (" in line for line in lines)
    assert last == "3 of 6 cases as expected; report: out/report.pdf, out/report.html"
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())["cases"]
    assert [case["share"] for case in summary] == [share] * 6
    assert [case["passed"] for case in summary] == [word == "pass" for _, word in settings]


def test_expected_not_to_be_trackworthy_is_exit_code_0(tmp_path, share):
    assert main(["run", campaign(tmp_path, BESIDE + 'expect = "not-trackworthy"\n'), "-o", "out"]) == 0
    assert main(["run", campaign(tmp_path, BESIDE + f"pass_share = {share}\n"), "-o", "out", "--fresh"]) == 0


# Progress


def test_piped_progress_is_plain_lines_and_ends_with_all(tmp_path):
    (tmp_path / "line.csv").write_text("x,y\n0,0\n5,0\n10,0\n")
    short = BESIDE.replace("trials = 8", "trials = 100").replace("speed = 10", "speed = [9, 10]")
    command = [sys.executable, "-m", "trackworthy", "run", campaign(tmp_path, short), "-o", "out", "-j", "1"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
    assert ended.returncode == 1
    lines = ended.stderr.splitlines()
    plain = r"\d+/200 trials, (\d+ s left, )?[012]/2 cases, [\d.]+ trials/s(, \d+ trials? not as expected)?"
    assert all(re.fullmatch(plain, line) for line in lines)
    missed = sum(not passed for _, _, passed, _ in stored(tmp_path / "out"))
    assert lines[-1].startswith("200/200 trials, 2/2 cases, ")
    assert lines[-1].endswith(f", {missed} trial{'' if missed == 1 else 's'} not as expected")
    assert missed > 0
    assert "\x1b" not in ended.stdout + ended.stderr
