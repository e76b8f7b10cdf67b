"""What closing the loop costs: a trial against its bare simulator over the same number of steps, in CPU time.

Run as `python tests/benchmarks/closed_loop_cost.py`; prints the ratio for a c172x (10 km) and a truck (500 m). Both
sides alternate, several times, and each side's least time counts: whatever else the machine does only adds.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path as FilePath

os.environ.setdefault("JSBSIM_DEBUG", "0")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # waiting BLAS threads would count as CPU time

import jsbsim
from highway_env.vehicle.kinematics import Vehicle as HighwayVehicle

sys.path.insert(0, str(FilePath(__file__).parents[1]))

from planners.path import Path
from sample_paths import aircraft_weave, road_weave
from sim.aircraft_file import load_aircraft
from sim.fixed_wing import STEP, STEPS, FixedWing
from sim.jsbsim_model import start_in_equilibrium
from sim.truck import SUBSTEPS, Truck
from sim.vehicle import Conditions, Pose, Vehicle
from sim.wind import Wind
from tracking.controllers import make_controller
from tracking.loop import follow

REPEATS = 9
AIRSPEED, ALTITUDE = 55.0, 1000.0


def bare_jsbsim(steps: int) -> float:
    """CPU time [s] of `fdm.run()` alone: the stock aircraft, as JSBSim loads it, trimmed."""
    fdm = jsbsim.FGFDMExec(jsbsim.get_default_root_dir())
    fdm.load_model("c172x")
    fdm.set_dt(STEP)
    fdm.disable_output()
    start_in_equilibrium(fdm, Pose(0.0, 0.0, ALTITUDE, 0.0), 0.0, 0.0, AIRSPEED, Wind())
    return cpu_time(lambda: [fdm.run() for _ in range(steps)])


def bare_highway_env(steps: int) -> float:
    """CPU time [s] of highway-env's own `Vehicle.step` alone."""
    vehicle = HighwayVehicle(None, [0.0, 0.0], 0.0, 12.5)
    return cpu_time(lambda: [vehicle.step(0.01) for _ in range(steps)])


def cpu_time(work: Callable[[], object]) -> float:
    """CPU time [s] of `work()` in this process."""
    start = time.process_time()
    work()
    return time.process_time() - start


def report(
    name: str, path: Path, vehicle: Vehicle, speed: float, bare: Callable[[int], float], per_period: int
) -> None:
    """Print the ratio of a closed-loop trial, start included, to the bare simulator."""

    def trial() -> int:
        track = follow(path, vehicle, make_controller("lqr"), speed, ALTITUDE, Conditions())
        return (len(track) - 1) * per_period

    steps = trial()
    pairs = [(cpu_time(trial), bare(steps)) for _ in range(REPEATS)]
    closed, alone = min(a for a, _ in pairs), min(b for _, b in pairs)
    print(f"{name}: {steps} steps, closed loop {closed:.3f} s, bare {alone:.3f} s, ratio {closed / alone:.2f}")


def main() -> None:
    """Both vehicles."""
    air = aircraft_weave()
    report("c172x", air, FixedWing(load_aircraft("c172x")), AIRSPEED, bare_jsbsim, STEPS)
    road = road_weave(12.5)
    report("truck", road, Truck(), 12.5, bare_highway_env, SUBSTEPS)


if __name__ == "__main__":
    main()
