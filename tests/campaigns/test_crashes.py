"""Simulators that crash, hang and raise cost their trials, and nothing else."""

import json
import os
import signal
import sqlite3
import subprocess
import sys
import time

import pytest

from small_campaigns import ROAD, run_here, stored, write_campaign

# Worker processes import the main script, so they get the faulty truck too
FAULTY = """
import os, sys, time
import campaigns.workers
from sim.truck import Truck
from trackworthy.__main__ import main

campaigns.workers.START_UP = 10.0
sound = Truck.reset

def reset(self, pose, speed, conditions, seed):
    if seed in {abort}:
        os.abort()
    if seed in {hang}:
        time.sleep(1000.0)
    if seed in {throw}:
        raise ArithmeticError("the tyres came off")
    return sound(self, pose, speed, conditions, seed)

Truck.reset = reset
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
"""


@pytest.fixture(scope="module")
def seeds():
    import tomllib

    from campaigns.case import Case
    from campaigns.expand import expanded
    from campaigns.seeds import trial_seed

    (case,) = expanded(tomllib.loads(ROAD)["case"][0], "", Case)
    return [trial_seed(1, case, trial) for trial in range(1, 21)]


def run(tmp_path, script, file, name, *options):
    command = [sys.executable, str(script), "run", str(file), "-o", str(tmp_path / name), *options]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=200, check=False)
    return ended, json.loads((tmp_path / name / "summary.json").read_text())


def test_they_are_recorded_and_the_others_run(tmp_path, seeds):
    script = tmp_path / "faulty.py"
    script.write_text(FAULTY.format(abort={seeds[2]}, hang={seeds[12]}, throw={seeds[5]}))
    file = write_campaign(tmp_path, ROAD, head="seed = 1\ntimeout = 2")
    ended, summary = run(tmp_path, script, file, "two", "-j", "2")
    assert ended.returncode == 3
    assert "Traceback" not in ended.stderr.replace("Fatal Python error", "")
    assert "error road: 3 of 20 trials" in ended.stdout
    (case,) = summary["cases"]
    assert (case["errors"], case["trackworthy"], case["verdict"]) == (3, 17, "error")
    with sqlite3.connect(tmp_path / "two" / "results.sqlite") as db:
        errors = dict(db.execute("SELECT trial, error FROM trials WHERE error != '' ORDER BY trial").fetchall())
    db.close()
    assert list(errors) == [3, 6, 13]
    assert errors[3] == "the process that ran it died"
    assert "the tyres came off" in errors[6]
    assert errors[13] == "it took longer than 2 s"

    script.write_text(FAULTY.format(abort={0}, hang={0}, throw={0}))
    ended, summary = run(tmp_path, script, file, "two", "-j", "1")
    assert ended.returncode == 0
    assert "20/20 trials" in ended.stderr
    assert summary["cases"][0]["trackworthy"] == 20
    run_here(file, tmp_path / "whole")
    assert json.loads((tmp_path / "whole" / "summary.json").read_text()) == summary


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_to_the_whole_group_ends_it_without_a_traceback(tmp_path, sent):
    """As Ctrl-C in a terminal does: the workers get it too."""
    file = write_campaign(tmp_path, ROAD.replace("trials = 20", "trials = 2000"))
    command = [sys.executable, "-m", "trackworthy", "run", str(file), "-o", str(tmp_path / "out"), "-j", "2"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True
    )
    with process:
        while not stored(tmp_path / "out"):
            time.sleep(0.05)
        os.killpg(process.pid, sent)
        said, _ = process.communicate(timeout=60)
    assert process.returncode == {signal.SIGINT: 130, signal.SIGTERM: 143}[sent]
    assert "Traceback" not in said
    assert "the same command goes on" in said
    assert gone(process.pid)


def gone(group, within=10.0):
    end = time.monotonic() + within
    while time.monotonic() < end:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.1)
    return False
