import json

import pytest

from campaigns.campaign import CAMPAIGNS_FOLDER
from trackworthy.__main__ import main

CASE = '[[case]]\npath = "line.csv"\nvehicle = "truck"\n'


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "line.csv").write_text("x,y\n0,0\n30,0\n60,0\n")
    (tmp_path / "corner.csv").write_text("x,y\n0,0\n60,0\n60,60\n")


def campaign(tmp_path, text):
    (tmp_path / "mine.toml").write_text('name = "mine"\n' + text)
    return "mine.toml"


def test_quickstart_is_as_expected_and_writes_its_report(tmp_path, capfd):
    assert main(["run", "-o", "out"]) == 0
    out = capfd.readouterr().out
    assert "4 of 4 cases as expected" in out
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")
    assert len(list((tmp_path / "out" / "figures").glob("*.png"))) == 4
    verdicts = [
        case["trackworthy"] == 1 for case in json.loads((tmp_path / "out" / "summary.json").read_text())["cases"]
    ]
    assert verdicts == [True, True, True, False]


def test_quickstart_ships_with_the_program():
    assert (CAMPAIGNS_FOLDER / "quickstart" / "valley-survey.plan").is_file()


def test_an_unexpected_verdict_is_exit_code_1(tmp_path, capfd):
    assert main(["run", campaign(tmp_path, CASE.replace("line", "corner") + 'speed = "60km/h"\n')]) == 1
    assert "FAIL" in capfd.readouterr().out
    assert (tmp_path / "runs" / "mine" / "report.pdf").is_file()


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


def test_one_case_can_be_repeated_alone(tmp_path, capfd):
    name = campaign(tmp_path, CASE + "speed = [10, 12]\n")
    assert main(["run", name, "--case", "line 12"]) == 0
    assert "1 of 1 cases as expected" in capfd.readouterr().out
    assert (tmp_path / "runs" / "mine-line-12" / "report.pdf").is_file()
    assert main(["run", name, "--case", "line 13"]) == 2
    assert "no case 'line 13'; did you mean 'line 12'?" in capfd.readouterr().err


def test_notes_on_mission_files_are_told_once(capfd):
    assert main(["run", "--case", "valley survey"]) == 0
    assert capfd.readouterr().err.count("NAV_TAKEOFF") == 1
