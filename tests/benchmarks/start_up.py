"""How long a user waits: `trackworthy --help`, and `trackworthy track` on 10 km with c172x, from a cold start.

Run as `python tests/benchmarks/start_up.py`; prints the least of several runs. Kernels are compiled in a first run that
does not count.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from pathlib import Path

from planners import files
from planners.path import Path as PlannedPath

HELP, TRACK = 5, 3  # runs


def least(runs: int, *arguments: str, folder: str) -> float:
    """The least wall time [s] of `trackworthy` with these arguments."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        subprocess.run([sys.executable, "-m", "trackworthy", *arguments], cwd=folder, capture_output=True, check=True)
        times.append(time.perf_counter() - start)
    return min(times)


def main() -> None:
    """Both commands."""
    with tempfile.TemporaryDirectory() as folder:
        path = PlannedPath([[0.0, 0.0], [5000.0, 0.0], [10_000.0, 300.0]])
        files.write(path, Path(folder) / "path.csv")
        track = ("track", "path.csv", "--vehicle", "c172x", "--corners", "fly-by")
        first = least(1, *track, folder=folder)
        helped = least(HELP, "--help", folder=folder)
        print(f"trackworthy --help: {helped:.2f} s (limit 0.25 s)")
        again = least(TRACK, *track, folder=folder)
        print(f"trackworthy track, 10 km, c172x: {again:.2f} s (limit 5 s; the first time {first:.2f} s)")


if __name__ == "__main__":
    main()
