"""Campaigns small enough for tests, and an executor that needs no processes."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from campaigns.campaign import load_campaign
from campaigns.execute import Finished, execute
from campaigns.lanes import Lanes
from campaigns.ready import make_ready
from planners import files
from sample_paths import aircraft_weave, road_weave

ROAD = """
[[case]]
name = "road"
path = "road.csv"
vehicle = "truck"
speed = "45km/h"
trials = 20
[case.conditions]
cross_track_offset = { normal = [0, 0.05] }
position_noise = 0.01
friction = { uniform = [0.6, 0.9] }
"""
AIR = """
[[case]]
name = "air"
path = "air.csv"
vehicle = "c172x"
trials = 20
[case.conditions]
wind = { speed = { weibull = [2, 6] }, from = { uniform = [200, 280] } }
cross_track_offset = { normal = [0, 1] }
mass = { normal = [1, 0.05] }
"""


class Here(Executor):
    """Runs a task when it is submitted, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


class InThisProcess:
    """Machines for `execute`."""

    @contextmanager
    def lanes(self, timeout: float) -> Iterator[Lanes]:
        yield Lanes(Here(), 1)


def write_campaign(folder: Path, cases: str, name: str = "small", head: str = "seed = 1") -> Path:
    """A campaign file with these `[[case]]` blocks, and the paths they may use."""
    folder.mkdir(parents=True, exist_ok=True)
    files.write(road_weave(12.5).resample(4.0), folder / "road.csv")
    files.write(aircraft_weave(length=5000.0), folder / "air.csv")
    file = folder / f"{name}.toml"
    file.write_text(f'name = "{name}"\n{head}\n{cases}')
    return file


def run_here(file: Path, folder: Path, fresh: bool = False) -> Finished:
    """Run the campaign in this process."""
    campaign = load_campaign(str(file))
    machines: Any = InThisProcess()
    return execute(campaign, make_ready(campaign), folder, machines, lambda results, tasks, total: [*results], fresh)


def stored(folder: Path) -> int:
    """How many trials are stored in a results folder, also while it is written to."""
    if not (folder / "results.sqlite").exists():
        return 0
    db = sqlite3.connect(f"file:{folder / 'results.sqlite'}?mode=ro", uri=True)
    try:
        return int(db.execute("SELECT count(*) FROM trials").fetchone()[0])
    except sqlite3.OperationalError:
        return 0
    finally:
        db.close()
