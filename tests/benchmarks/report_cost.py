"""What reports cost: all forms of 200 trials of 20 cases, and of 5,000 trials of 50 cases.

`python tests/benchmarks/report_cost.py` prints the time of `trackworthy report` in all forms together and in each
alone, and the most memory that one of its processes takes; `--runs FOLDER` keeps the campaigns, for the next time.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FORMS = ("pdf", "html", "png", "junit", "md")
YARD = "x,y\n20,70\n120,66\n210,80\n324,109\n"
CASES = {20: '["30km/h", "35km/h", "40km/h", "45km/h"]', 50: str([f"{20 + 3 * i}km/h" for i in range(10)])}
CAMPAIGN = """
name = "cost"
[[case]]
path = "yard.csv"
vehicle = "truck"
controller = ["lqr", "l1", "stanley", "pure-pursuit", "vector-field"]
speed = {speeds}
trials = {trials}
expect = "either"
[case.conditions]
cross_track_offset = {{ normal = [0, 0.1] }}
friction = {{ uniform = [0.6, 0.9] }}
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=Path, help="folder of the campaigns' results")
    with tempfile.TemporaryDirectory() as temporary:
        folder = parser.parse_args().runs or Path(temporary)
        for cases, trials in ((20, 200), (50, 5000)):
            told(ran(folder, cases, trials), f"{trials} trials of {cases} cases")


def ran(folder: Path, cases: int, trials: int) -> Path:
    """The folder of the campaign's results, run unless it was."""
    where = folder / f"cost-{trials}"
    where.mkdir(parents=True, exist_ok=True)
    (where / "yard.csv").write_text(YARD)
    (where / "campaign.toml").write_text(CAMPAIGN.format(speeds=CASES[cases], trials=trials // cases))
    command = [sys.executable, "-m", "trackworthy", "run", "campaign.toml", "-o", "results"]
    if not (where / "results" / "report.pdf").exists():
        subprocess.run(command, cwd=where, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return where / "results"


def told(results: Path, what: str) -> None:
    for forms in (FORMS, *((form,) for form in FORMS)):
        start = time.perf_counter()
        flags = [word for form in forms for word in ("--format", form)]
        command = [sys.executable, "-m", "trackworthy", "report", str(results), *flags]
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status:
            sys.exit(f"{' '.join(command)} failed")
        took = time.perf_counter() - start
        name = "all forms" if len(forms) > 1 else forms[0]
        print(f"{what}, {name}: {took:.1f} s, {usage.ru_maxrss / 1024:.0f} MB", flush=True)


if __name__ == "__main__":
    main()
