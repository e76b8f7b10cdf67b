"""`trackworthy check` as users and CI call it."""

import json
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET

import pytest

from campaigns import attempt as attempting
from planners.errors import TrackworthyError
from small_campaigns import ROAD, run_here, write_campaign
from trackworthy.__main__ import main

NAME = "a|b `c` <i> 5 %"
FEW = ROAD.replace("trials = 20", "trials = 3").replace('"road"', json.dumps(NAME))


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """A folder of results that are trackworthy."""
    folder = tmp_path_factory.mktemp("good")
    run_here(write_campaign(folder, FEW), folder / "out")
    return folder / "out"


@pytest.fixture(scope="module")
def broken(tmp_path_factory):
    """The same campaign, where one trial of three could not be run."""
    folder = tmp_path_factory.mktemp("broken")
    replay, tries = attempting.replay, []

    def failing(job, seed):
        tries.append(seed)
        if len(tries) == 2:
            raise TrackworthyError("the simulator stopped")
        return replay(job, seed)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(attempting, "replay", failing)
        run_here(write_campaign(folder, FEW), folder / "out")
    return folder / "out"


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("GITHUB_STEP_SUMMARY", raising=False)


@pytest.fixture
def check(capfd):
    """Runs the command; gives exit code, standard output and standard error."""

    def call(*arguments):
        try:
            code = main(["check", *map(str, arguments)])
        except SystemExit as stop:
            code = stop.code
        return (code, *capfd.readouterr())

    return call


@pytest.fixture
def baseline(good, tmp_path, check):
    """A baseline of the good results."""
    file = tmp_path / "baseline.json"
    assert check(good, "--baseline", file, "--update")[0] == 0
    return file


@pytest.fixture
def stricter(baseline):
    """A baseline from when errors were half as large."""
    content = json.loads(baseline.read_text())
    metrics = content["cases"][NAME]["metrics"]
    metrics["cross_track_p95"] = [value / 2 for value in metrics["cross_track_p95"]]
    file = baseline.with_name("stricter.json")
    file.write_text(json.dumps(content))
    return file


def one_line(error):
    assert len(error.strip().splitlines()) == 1
    return error


def test_what_was_made_the_baseline_passes(good, tmp_path, check):
    code, out, err = check(good, "--baseline", "b.json", "--update")
    assert (code, out) == (0, "")
    assert one_line(err) == "b.json: the baseline is now that of 1 case\n"
    code, out, err = check(good, "--baseline", "b.json")
    assert (code, err) == (0, "")
    assert out.startswith("AS GOOD AS THE BASELINE  ")


def test_a_regression_is_exit_code_1_and_its_command_repeats_a_trial(good, stricter, check):
    code, out, err = check(good, "--baseline", stricter)
    assert (code, err) == (1, "")
    assert "cross_track_p95" in out
    assert out.splitlines()[-1].startswith("NOT AS THE BASELINE  1 worse; ")
    (command,) = (line for line in out.splitlines() if line.startswith("  trackworthy run "))
    assert f"{good}/campaign.toml --case '{NAME}' --trial " in command


def test_after_an_update_a_regression_is_the_baseline(good, stricter, check):
    assert check(good, "--baseline", stricter)[0] == 1
    assert check(good, "--baseline", stricter, "--update")[0] == 0
    assert check(good, "--baseline", stricter)[0] == 0


def test_more_errors_than_before_are_exit_code_3(broken, baseline, check):
    code, out, _ = check(broken, "--baseline", baseline)
    assert code == 3
    told = "1 of 3 trials failed to run, 0 did before: the simulator stopped"
    assert out.splitlines()[0] == f"errors  {NAME}: {told}"


def test_results_with_errors_make_no_baseline(broken, check, tmp_path):
    code, _, err = check(broken, "--baseline", tmp_path / "b.json", "--update")
    assert code == 2
    assert "failed to run (" in err
    assert "a baseline is of results without errors" in err
    assert not (tmp_path / "b.json").exists()


@pytest.mark.parametrize("content", ["x,y\n0,0\n", "[1]", '{"cases": {}}'])
def test_update_overwrites_nothing_but_a_baseline(good, check, tmp_path, content):
    (tmp_path / "mine").write_text(content)
    code, _, err = check(good, "--baseline", tmp_path / "mine", "--update")
    assert code == 2
    assert "is there and is not a baseline" in err
    assert (tmp_path / "mine").read_text() == content


def test_a_campaign_with_other_cases_is_exit_code_1(good, baseline, check):
    content = json.loads(baseline.read_text())
    content["cases"]["old"] = content["cases"].pop(NAME)
    baseline.write_text(json.dumps(content))
    code, out, _ = check(good, "--baseline", baseline)
    assert code == 1
    assert "vanished  old: " in out
    assert f"appeared  {NAME}: " in out


@pytest.mark.parametrize("options", [(), ("--format", "json"), ("--format", "github")])
def test_a_missing_baseline_is_one_line_and_exit_code_2(good, check, options):
    code, out, err = check(good, "--baseline", "nowhere.json", *options)
    assert (code, out) == (2, "")
    assert one_line(err) == (
        "trackworthy: nowhere.json: there is no such baseline; make one of good results: "
        "trackworthy check DIR --baseline FILE --update\n"
    )


def test_a_missing_folder_is_one_line_and_exit_code_2(baseline, check, tmp_path):
    (tmp_path / "empty").mkdir()
    for folder in ("nowhere", "empty"):
        code, out, err = check(folder, "--baseline", baseline)
        assert (code, out) == (2, "")
        assert f"{folder}: holds no results; run a campaign first" in one_line(err)


def test_a_file_in_place_of_the_folder_is_told_as_that(baseline, check):
    code, _, err = check(baseline, "--baseline", baseline)
    assert code == 2
    assert "--fresh" not in one_line(err)


def test_a_missing_folder_does_not_become_the_baseline(baseline, check):
    before = baseline.read_bytes()
    assert check("nowhere", "--baseline", baseline, "--update")[0] == 2
    assert baseline.read_bytes() == before


def test_a_baseline_that_cannot_be_written_is_one_line_and_exit_code_2(good, check):
    code, _, err = check(good, "--baseline", "nowhere/b.json", "--update")
    assert code == 2
    assert "the folder nowhere does not exist" in one_line(err)


def test_wrong_usage_is_one_line_and_exit_code_2(good, check):
    for arguments in ((good,), (good, "--baseline", "b.json", "--format", "yaml"), ("--baseline", "b.json")):
        code, out, err = check(*arguments)
        assert (code, out) == (2, "")
        one_line(err)


def test_json_is_one_object_and_nothing_else(good, baseline, stricter, check):
    code, out, err = check(good, "--baseline", stricter, "--format", "json")
    told = json.loads(out)
    assert (code, err, told["passed"]) == (1, "", False)
    (finding,) = told["findings"]
    assert (finding["case"], finding["metric"]) == (NAME, "cross_track_p95")
    assert finding["new"] == pytest.approx(2 * finding["old"], rel=1e-4)
    assert finding["new"] - finding["old"] > finding["limit"]
    code, out, _ = check(good, "--baseline", baseline, "--format", "json")
    assert (code, json.loads(out)["passed"], json.loads(out)["findings"]) == (0, True, [])


def test_junit_has_a_failure_and_an_error(good, broken, baseline, stricter, check):
    code, out, _ = check(good, "--baseline", stricter, "--format", "junit")
    (suite,) = ET.fromstring(out)
    assert (code, suite.get("failures"), suite.get("errors")) == (1, "1", "0")
    assert int(suite.get("tests")) == len(suite) > 10
    code, out, _ = check(broken, "--baseline", baseline, "--format", "junit")
    (suite,) = ET.fromstring(out)
    assert (code, suite.get("failures"), suite.get("errors")) == (3, "0", "1")


def test_github_annotates_and_appends_its_summary(good, stricter, check, tmp_path, monkeypatch):
    summary = tmp_path / "summary.md"
    summary.write_text("before\n", encoding="utf-8")
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(summary))
    code, out, err = check(good, "--baseline", stricter, "--format", "github")
    assert (code, err) == (1, "")
    (line,) = out.splitlines()
    assert line.startswith("::error title=worse%3A a|b `c` <i> 5 %25::cross_track_p95 was ")
    text = summary.read_text(encoding="utf-8")
    assert text.startswith("before\n### trackworthy check: small\n")
    assert check(good, "--baseline", stricter, "--format", "github")[0] == 1
    assert summary.read_text(encoding="utf-8").count("### trackworthy check") == 2


def test_github_without_a_summary_prints_it_after_the_annotations(good, stricter, check):
    code, out, _ = check(good, "--baseline", stricter, "--format", "github")
    assert code == 1
    first, second, *_ = out.splitlines()
    assert first.startswith("::error ")
    assert second == "### trackworthy check: small"


def test_a_moved_folder_is_checked_where_it_is(good, baseline, check, tmp_path):
    shutil.copytree(good, tmp_path / "moved")
    assert check("moved", "--baseline", baseline)[0] == 0


def test_as_a_process(good, baseline, stricter):
    def run(*arguments):
        command = [sys.executable, "-m", "trackworthy", "check", str(good), "--format", "json", *arguments]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    passed, failed, missing = (run("--baseline", file) for file in (baseline, stricter, "nowhere.json"))
    assert [one.returncode for one in (passed, failed, missing)] == [0, 1, 2]
    assert [one.stderr for one in (passed, failed)] == ["", ""]
    assert [json.loads(one.stdout)["passed"] for one in (passed, failed)] == [True, False]
    assert missing.stdout == ""
