"""What a campaign costs beyond its simulators: time from a cold start, speed-up by a second process, and memory.

Run as `python tests/benchmarks/campaign_cost.py [truck] [aircraft] [parallel] [memory]`, or all four. Each prints what
it measured, and what to hold it against. Campaigns run as a user runs them, in a process of their own.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("JSBSIM_DEBUG", "0")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

sys.path.insert(0, str(Path(__file__).parents[1]))
sys.path.insert(0, str(Path(__file__).parent))

from closed_loop_cost import bare_jsbsim
from planners import files
from planners.path import Path as PlannedPath
from sample_paths import aircraft_weave, road_weave
from sim.fixed_wing import STEP
from small_campaigns import stored

TRUCK, TRUCK_TARGET = 1000, 60.0  # trials, [s]
AIRCRAFT, AIRCRAFT_FACTOR, AIRCRAFT_EXTRA = 200, 1.3, 10.0  # trials, of bare JSBSim's time on two processors, [s]
MINUTE, SPEED_UP_TARGET = 440, 1.8  # trials
MEMORY, MEMORY_TARGET = 10_000, 50.0  # trials, [MB]
AIRSPEED = 55.0

TRUCK_CASE = """
[[case]]
path = "road.csv"
vehicle = "truck"
speed = "45km/h"
trials = {trials}
conditions = {{ cross_track_offset = {{ normal = [0, 0.05] }}, friction = {{ uniform = [0.6, 0.9] }} }}
"""
AIR_CASE = """
[[case]]
path = "air.csv"
vehicle = "c172x"
trials = {trials}
conditions = {{ cross_track_offset = {{ normal = [0, 1] }}, mass = {{ normal = [1, 0.05] }} }}
"""


def truck(folder: Path) -> None:
    """A thousand truck trials on 100 m, from a cold start, results stored."""
    took = run(folder, TRUCK_CASE.format(trials=TRUCK), 2)
    print(f"{TRUCK} truck trials of 100 m, -j 2: {took:.1f} s (to reach: {TRUCK_TARGET:.0f} s)")


def aircraft(folder: Path) -> None:
    """Two hundred c172x trials of 5 km against bare JSBSim over the same time of flight on both processors."""
    path = files.read(folder / "air.csv").path
    steps = round(path.length / AIRSPEED / STEP)
    bare = min(bare_jsbsim(steps) for _ in range(7)) * AIRCRAFT / 2
    took = run(folder, AIR_CASE.format(trials=AIRCRAFT), 2)
    allowed = AIRCRAFT_FACTOR * bare + AIRCRAFT_EXTRA
    ratio = (took - AIRCRAFT_EXTRA) / bare
    print(f"{AIRCRAFT} c172x trials of 5 km, -j 2: {took:.1f} s; bare JSBSim on two processors {bare:.1f} s")
    print(f"  ratio {ratio:.2f} after {AIRCRAFT_EXTRA:.0f} s (to reach: {AIRCRAFT_FACTOR}, that is {allowed:.1f} s)")


def parallel(folder: Path) -> None:
    """What a second process gains on about a minute of c172x trials."""
    case = AIR_CASE.format(trials=MINUTE)
    pairs = [(run(folder, case, 1), run(folder, case, 2)) for _ in range(2)]
    one, two = (min(times) for times in zip(*pairs, strict=True))
    print(f"{MINUTE} c172x trials: -j 1 {one:.1f} s, -j 2 {two:.1f} s")
    print(f"  ratio {one / two:.2f} (to reach: {SPEED_UP_TARGET})")


def memory(folder: Path) -> None:
    """Growth of all processes between the first thousand of ten thousand truck trials and the last thousand."""
    seen: list[tuple[int, float]] = []
    run(folder, TRUCK_CASE.format(trials=MEMORY), 2, lambda pid: seen.append((stored(folder / "out"), resident(pid))))
    first = [size for done, size in seen if 500 <= done <= 1500]
    last = [size for done, size in seen if MEMORY - 1000 <= done < MEMORY]
    growth = max(last) - max(first)
    print(f"{MEMORY} truck trials: {max(first):.0f} MB at 1,000, {max(last):.0f} MB at the end, all processes together")
    print(f"  growth {growth:.0f} MB (to reach: {MEMORY_TARGET:.0f} MB); {seen[-1][1]:.0f} MB while it reports")


def run(folder: Path, case: str, jobs: int, watch: Callable[[int], None] | None = None) -> float:
    """Wall time [s] of `trackworthy run`; `watch` is called with its process id every half second meanwhile."""
    file = folder / "campaign.toml"
    file.write_text(f'name = "cost"\n{case}')
    command = [sys.executable, "-m", "trackworthy", "run", str(file), "-o", str(folder / "out"), "--fresh"]
    begun = time.perf_counter()
    process = subprocess.Popen(
        [*command, "-j", str(jobs)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    )
    said = threading.Thread(target=process.stderr.read if process.stderr else str)
    said.start()
    while process.poll() is None:
        time.sleep(0.5 if watch else 0.02)
        if watch:
            watch(process.pid)
    said.join()
    if process.returncode != 0:
        raise SystemExit(f"the campaign ended with exit code {process.returncode}")
    return time.perf_counter() - begun


def resident(pid: int) -> float:
    """Resident memory [MB] of a process and all its children."""
    total = 0.0
    for process in [pid, *_children(pid)]:
        try:
            status = Path(f"/proc/{process}/status").read_text()
        except OSError:
            continue
        if match := re.search(r"VmRSS:\s+(\d+) kB", status):
            total += int(match[1]) / 1000.0
    return total


def _children(pid: int) -> list[int]:
    found = []
    for file in Path(f"/proc/{pid}/task").glob("*/children"):
        try:
            found += [int(one) for one in file.read_text().split()]
        except OSError:
            continue
    return found


def main() -> None:
    """The benchmarks named on the command line, or all."""
    every = {"truck": truck, "aircraft": aircraft, "parallel": parallel, "memory": memory}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        hundred = road_weave(12.5)
        files.write(PlannedPath(hundred.points[hundred.s <= 100.0]), folder / "road.csv")
        files.write(aircraft_weave(length=5000.0), folder / "air.csv")
        for chosen in sys.argv[1:] or every:
            every[chosen](folder)


if __name__ == "__main__":
    main()
