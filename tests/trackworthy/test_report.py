"""`trackworthy report`, as a user runs it."""

import re
import shutil
import xml.etree.ElementTree as ET
from contextlib import contextmanager

import pytest

from campaigns.lanes import Lanes
from small_campaigns import Here
from trackworthy.__main__ import main

CAMPAIGN = """
name = "yard"
[[case]]
name = "straight"
path = "line.csv"
vehicle = "truck"
speed = 10
trials = 4
conditions.cross_track_offset = { uniform = [0.1, 0.9] }

[[case]]
name = "a corner | of *90* deg"
path = "corner.csv"
vehicle = "truck"
"""
ALL = ["figures", "junit.xml", "report.html", "report.pdf", "summary.md"]


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The folder of results that a run left."""
    folder = tmp_path_factory.mktemp("report")
    (folder / "line.csv").write_text("x,y\n0,0\n30,0\n60,0\n")
    (folder / "corner.csv").write_text("x,y\n0,0\n60,0\n60,60\n")
    (folder / "yard.toml").write_text(CAMPAIGN)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("campaigns.execute.Machines.lanes", _here)
        assert main(["run", str(folder / "yard.toml"), "-o", str(folder / "results")]) == 1
    return folder / "results"


@contextmanager
def _here(machines, timeout):
    yield Lanes(Here(), 1)


@pytest.fixture
def results(made, tmp_path, monkeypatch):
    """The same elsewhere, to be drawn in this process."""
    monkeypatch.setattr("campaigns.execute.Machines.lanes", _here)
    return shutil.copytree(made, tmp_path / "moved")


def content(folder):
    return {file.relative_to(folder): file.read_bytes() for name in ALL for file in _files(folder / name)}


def _files(place):
    return sorted(place.iterdir()) if place.is_dir() else [place]


def test_a_run_leaves_every_form_and_a_report_writes_the_same_bytes(made, results, capfd):
    before = content(made)
    for name in ALL:
        shutil.rmtree(results / name) if (results / name).is_dir() else (results / name).unlink()
    assert main(["report", str(results)]) == 0
    assert sorted(capfd.readouterr().out.split()) == [str(results / name) for name in ALL]
    assert content(results) == before


def test_one_form_alone(results, capfd):
    (results / "summary.md").unlink()
    (results / "report.pdf").unlink()
    assert main(["report", str(results), "--format", "md"]) == 0
    assert capfd.readouterr().out == f"{results / 'summary.md'}\n"
    assert not (results / "report.pdf").exists()


def test_letter_paper(results):
    assert main(["report", str(results), "--format", "pdf", "--paper", "letter"]) == 0
    boxes = re.findall(rb"/MediaBox\s*\[([^]]*)\]", (results / "report.pdf").read_bytes())
    assert {tuple(map(float, box.split())) for box in boxes} == {(0.0, 0.0, 612.0, 792.0)}


def test_the_summary_shows_the_worst_first_with_two_pictures(results):
    text = (results / "summary.md").read_text()
    assert "0 of 2 cases as expected" in text
    assert text.index("a corner") < text.index("straight")
    assert r"a corner \| of \*90\* deg" in text
    pictures = re.findall(r"\]\((figures/[^)]*)\)", text)
    assert len(set(pictures)) == 2
    assert all((results / name).is_file() for name in pictures)


def test_junit_has_a_test_for_each_case(results):
    suite = ET.parse(results / "junit.xml").getroot().find("testsuite")
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("2", "2", "0")
    failure = suite.findall("testcase")[1].find("failure")
    assert "cross-track error" in failure.get("message")
    assert "--case 'a corner | of *90* deg' --trial 1" in failure.text


def test_bad_usage_is_one_line(tmp_path, results, capfd):
    for arguments, told in (
        (["report", str(tmp_path / "none")], "holds no results; run a campaign first"),
        (["report", str(results), "-j", "0"], "--jobs: 0 is no number of processes"),
        (["report", str(results), "--format", "docx"], "invalid choice: 'docx'"),
    ):
        with pytest.raises(SystemExit) if "docx" in arguments else _nothing():
            assert main(arguments) == 2
        error = capfd.readouterr().err
        assert told in error
        assert error.count("\n") == 1


@contextmanager
def _nothing():
    yield
