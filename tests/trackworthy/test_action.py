"""The GitHub action's own steps, run by bash as a runner would."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from small_campaigns import ROAD, run_here, write_campaign
from trackworthy.__main__ import main

yaml = pytest.importorskip("yaml")
ACTION = Path(__file__).parents[2] / "action.yml"


def steps():
    action = yaml.safe_load(ACTION.read_text())
    assert action["runs"]["using"] == "composite"
    return {step["name"]: step for step in action["runs"]["steps"] if "name" in step}


def run(step, folder, **inputs):
    """The script of a step with its inputs, in `folder`; it must take them from its environment only."""
    assert "${{" not in step["run"]
    values = {name: inputs[text.removeprefix("${{ inputs.").removesuffix(" }}")] for name, text in step["env"].items()}
    environment = {**os.environ, **values, "GITHUB_STEP_SUMMARY": str(folder / "summary.md")}
    environment["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{environment['PATH']}"
    command = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def test_a_good_build_passes_and_a_worse_one_is_stopped(tmp_path):
    file = write_campaign(tmp_path, ROAD.replace("trials = 20", "trials = 3"))
    inputs = {"campaign": file.name, "output": "out dir", "baseline": "baseline.json"}
    campaign, check = steps()["Run the campaign"], steps()["Check against the baseline"]
    ended = run(campaign, tmp_path, **inputs)
    assert ended.returncode == 0, ended.stderr
    assert run(check, tmp_path, **inputs).returncode == 2
    baseline = str(tmp_path / "baseline.json")
    assert main(["check", str(tmp_path / "out dir"), "--baseline", baseline, "--update"]) == 0
    assert run(check, tmp_path, **inputs).returncode == 0
    assert "AS GOOD AS THE BASELINE" in (tmp_path / "summary.md").read_text()

    file.write_text(file.read_text().replace('vehicle = "truck"', 'vehicle = "truck"\ncontroller = "pure-pursuit"'))
    run_here(file, tmp_path / "worse")
    ended = run(check, tmp_path, **{**inputs, "output": "worse"})
    assert ended.returncode == 1
    assert ended.stdout.startswith("::error title=")
    assert "cross\\_track\\_p95" in (tmp_path / "summary.md").read_text()
