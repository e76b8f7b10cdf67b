"""`trackworthy compare` as users call it."""

import json
import shutil
import sqlite3

import pytest

from small_campaigns import ROAD, run_here, write_campaign
from trackworthy.__main__ import main

NAME = "a|b [m] `c` <i> 5 %"
LQR = ROAD.replace("trials = 20", "trials = 4").replace('"road"', json.dumps(NAME))
STANLEY = LQR.replace("speed =", 'controller = "stanley"\nspeed =')


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """Results of the same case under two controllers."""
    found = []
    for name, block in (("lqr", LQR), ("stanley", STANLEY)):
        folder = tmp_path_factory.mktemp(name)
        run_here(write_campaign(folder, block), folder / "out")
        found.append(folder / "out")
    return found


@pytest.fixture
def compare(capfd, monkeypatch):
    """Runs the command; gives exit code, standard output and standard error."""

    def call(*arguments, columns=80):
        monkeypatch.setenv("COLUMNS", str(columns))
        try:
            code = main(["compare", *map(str, arguments)])
        except SystemExit as stop:
            code = stop.code
        return (code, *capfd.readouterr())

    return call


@pytest.mark.parametrize("columns", [80, 120])
def test_the_table_tells_what_was_changed_and_what_came_of_it(folders, compare, columns):
    code, out, err = compare(*folders, columns=columns)
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert "set in every case: controller lqr → stanley" in lines
    assert NAME in lines
    (p95,) = (line.split() for line in lines if line.startswith("cross_track_p95"))
    assert p95[-2:] == ["m", "better"]
    assert float(p95[3].replace("−", "-")) == pytest.approx(float(p95[2]) - float(p95[1]), abs=1e-4)
    assert lines[-1] == "B: 1 better, 0 worse, 0 the same; 0 verdicts changed"
    rule = next(line for line in lines if line.startswith("──"))
    assert len(rule) <= 80
    assert max(map(len, lines[lines.index(rule) - 1 : lines.index(rule) + 4])) <= 80


def test_the_other_way_round_is_worse(folders, compare):
    out = compare(*reversed(folders))[1]
    assert out.splitlines()[-1] == "B: 0 better, 1 worse, 0 the same; 0 verdicts changed"


def test_the_same_folder_twice_is_all_the_same_and_says_so(folders, compare):
    code, out, err = compare(folders[0], folders[0])
    assert code == 0
    assert out.splitlines()[-1] == "B: 0 better, 0 worse, 1 the same; 0 verdicts changed"
    assert err == f"{folders[0]} and {folders[0]} are the same folder\n"


def test_json_is_one_object_with_paired_differences(folders, compare):
    code, out, err = compare(*folders, "--format", "json")
    told = json.loads(out)
    assert (code, err) == (0, "")
    assert told["summary"] == {"better": 1, "worse": 0, "mixed": 0, "the same": 0, "verdicts_changed": 0}
    (pair,) = told["pairs"]
    assert pair["changes"] == [{"key": "controller", "a": "lqr", "b": "stanley"}]
    p95 = next(one for one in pair["differences"] if one["metric"] == "cross_track_p95")
    assert (p95["pairs"], p95["unit"], p95["better"]) == (4, "m", "lower")
    assert p95["change"] == pytest.approx(p95["b"] - p95["a"])
    assert p95["interval"][0] <= p95["change"] <= p95["interval"][1] < 0.0


def test_markdown_obeys_no_name(folders, compare):
    code, out, _ = compare(*folders, "--format", "md")
    assert code == 0
    assert "#### a\\|b \\[m\\] \\`c\\` \\<i\\> 5 %" in out
    assert "| metric | A | B | B − A | 95 % interval | | |" in out
    assert "**B: 1 better, 0 worse, 0 the same; 0 verdicts changed**" in out


def test_by_setting_matches_cases_of_other_names(folders, compare, tmp_path):
    shutil.copytree(folders[1], tmp_path / "b")
    file = tmp_path / "b" / "campaign.toml"
    file.write_text(file.read_text(encoding="utf-8").replace(NAME, "other"), encoding="utf-8")
    with sqlite3.connect(tmp_path / "b" / "results.sqlite") as db:
        db.execute("UPDATE trials SET case_name = 'other'")
    db.close()
    assert f"\n{NAME} → other\n" in compare(folders[0], tmp_path / "b")[1]
    code, out, _ = compare(folders[0], tmp_path / "b", "--by", "name")
    assert code == 0
    assert f"only in A: {NAME}" in out
    assert out.splitlines()[-1] == "nothing to compare: no case of B belongs to one of A"


def refused(told):
    code, out, err = told
    assert (code, out) == (2, "")
    assert len(err.strip().splitlines()) == 1
    return err


def test_a_folder_without_results_is_one_line(folders, compare, tmp_path):
    assert "nowhere: holds no results; run a campaign first" in refused(compare(folders[0], "nowhere"))
    assert f"{tmp_path}: holds no results" in refused(compare(tmp_path, folders[0]))
    refused(compare(folders[0]))
    refused(compare(*folders, "--format", "pdf"))


def test_unfinished_results_are_one_line(folders, compare, tmp_path):
    shutil.copytree(folders[0], tmp_path / "half")
    with sqlite3.connect(tmp_path / "half" / "results.sqlite") as db:
        db.execute("DELETE FROM trials WHERE rowid IN (SELECT rowid FROM trials LIMIT 1)")
    db.close()
    assert "3 of 4 trials of" in refused(compare(folders[0], tmp_path / "half"))


def test_metrics_of_another_definition_are_one_line(folders, compare, tmp_path):
    shutil.copytree(folders[0], tmp_path / "old")
    file = tmp_path / "old" / "manifest.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), "schema_version": 0}))
    told = refused(compare(tmp_path / "old", folders[0]))
    assert "its metrics have schema 0, those of this version 1; run the campaign again" in told


def test_a_campaign_of_searches_only_is_one_line(folders, compare, tmp_path):
    shutil.copytree(folders[0], tmp_path / "search")
    search = '\n[[smallest_scale]]\nscenario = "target-vehicle-71m"\nplanner = "astar-arc"\nvehicle = "truck"\n'
    text = f'name = "s"\n{search}between = [0.5, 2]\n'
    (tmp_path / "search" / "campaign.toml").write_text(text)
    assert "its campaign has no cases to compare" in refused(compare(tmp_path / "search", folders[0]))
