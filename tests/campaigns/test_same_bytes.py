"""However a campaign is run, broken off, and resumed: the same bytes."""

import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from small_campaigns import run_here, stored, write_campaign

CASES = """
[[case]]
name = "road"
path = "road.csv"
vehicle = "truck"
speed = "45km/h"
trials = 100
[case.conditions]
cross_track_offset = { normal = [0, 0.05] }
position_noise = 0.02
latency = { uniform = [0, 0.06] }

[[case]]
name = "air"
path = "air.csv"
vehicle = "c172x"
trials = 3
require = ["altitude_error_max<=300", "speed_error_max<=30"]
[case.conditions]
turbulence = "light"
wind = { speed = { weibull = [2, 6] }, from = { uniform = [0, 360] } }
mass = { normal = [1, 0.05] }
gust = { speed = 5, from = 20 }

[[case]]
name = "fleet"
path = "road.csv"
others = ["road.csv"]
vehicle = "truck"
speed = "45km/h"
trials = 2
conditions.position_noise = 0.02
"""
KILLS = 20


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """The campaign's file, and its results from one go in this process."""
    folder = tmp_path_factory.mktemp("same")
    file = write_campaign(folder, CASES, head='seed = 3\nkeep_tracks = "all"')
    run_here(file, folder / "serial")
    return file, results(folder / "serial")


def results(folder):
    """The summary's bytes, all rows, and the bytes of every track."""
    assert not list(folder.glob("results.sqlite-*"))
    with sqlite3.connect(folder / "results.sqlite") as db:
        rows = db.execute("SELECT * FROM trials ORDER BY key").fetchall()
    db.close()
    tracks = {file.name: file.read_bytes() for file in (folder / "tracks").iterdir()}
    return (folder / "summary.json").read_bytes(), rows, tracks


def start(file, folder, *options):
    command = [sys.executable, "-m", "trackworthy", "run", str(file), "-o", str(folder), *options]
    with open(folder.parent / "stderr", "w") as error:
        return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=error)


def finish(file, folder, *options):
    process = start(file, folder, *options)
    assert process.wait(timeout=120) == 0, (folder.parent / "stderr").read_text()


def children(pid):
    """The worker processes of a coordinator."""
    try:
        pids = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        pids += [pid for file in Path(f"/proc/{pid}/task").glob("*/children") for pid in file.read_text().split()]
        lines = {int(one): Path(f"/proc/{one}/cmdline").read_bytes() for one in set(pids)}
    except OSError:
        return []
    return [one for one, line in lines.items() if b"spawn_main" in line]


@pytest.mark.parametrize("options", [("-j", "2")])
def test_two_workers(reference, tmp_path, options):
    file, expected = reference
    finish(file, tmp_path / "out", *options)
    assert results(tmp_path / "out") == expected


def test_killed_at_random_moments_and_resumed(reference, tmp_path):
    file, expected = reference
    folder = tmp_path / "killed"
    chance = random.Random(20261122)
    process = start(file, folder, "-j", "2")
    orphans = set()
    for kill in range(KILLS):
        time.sleep(chance.uniform(0.0, 4.0))
        if process.poll() is not None:  # it was through before
            process = start(file, folder, "-j", "2")
        if kill % 3 == 0:
            while not (victims := children(process.pid)) and process.poll() is None:
                time.sleep(0.02)
        else:
            victims = [process.pid]
            orphans.update(children(process.pid))
        with suppress(ProcessLookupError):
            os.kill(chance.choice(victims or [process.pid]), signal.SIGKILL)
    process.wait()
    finish(file, folder)
    assert results(folder) == expected
    end = time.monotonic() + 15.0
    while (left := [pid for pid in orphans if Path(f"/proc/{pid}").exists()]) and time.monotonic() < end:
        time.sleep(0.1)
    assert not left, "workers outlived their coordinator"


def test_ctrl_c_stops_cleanly_and_the_same_command_goes_on(reference, tmp_path):
    file, expected = reference
    folder = tmp_path / "stopped"
    process = start(file, folder)
    while not stored(folder):
        time.sleep(0.05)
        assert process.poll() is None
    os.kill(process.pid, signal.SIGINT)
    assert process.wait(timeout=60) == 130
    error = (tmp_path / "stderr").read_text()
    assert "the same command goes on" in error
    assert "Traceback" not in error
    done = stored(folder)
    assert 0 < done < len(expected[1])
    finish(file, folder)
    assert results(folder) == expected


def test_the_folder_alone_can_be_run_again(tmp_path):
    few = CASES.replace("trials = 100", "trials = 8")
    run_here(write_campaign(tmp_path, few, head='seed = 3\nkeep_tracks = "all"'), tmp_path / "first")
    expected = results(tmp_path / "first")
    moved = tmp_path / "moved"
    (tmp_path / "first").rename(moved)
    run_here(moved / "campaign.toml", tmp_path / "again")
    assert results(tmp_path / "again") == expected
    run_here(moved / "campaign.toml", moved)
    assert results(moved) == expected
