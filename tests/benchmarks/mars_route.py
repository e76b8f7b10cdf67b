"""How well ares keeps a gentle route on Mars: every controller, calm, wind from four sides, daytime turbulence.

Run as `python tests/benchmarks/mars_route.py`; prints cross-track error, altitude error, bank, propellant burnt, margin
to the stall and wall time on a route with fly-by corners of 9 km radius, at 140 m/s and 1500 m.
"""

from __future__ import annotations

import math
import time

import numpy as np

from planners.corners import fly_by
from planners.path import Path
from sim.planet import MARS
from sim.vehicle import Conditions
from sim.wind import Wind
from tracking.controllers import ALL_CONTROLLERS
from tracking.trial import Trial, run_trial

CORNERS = [[0.0, 0.0], [20e3, 0.0], [40e3, 15e3], [60e3, 5e3], [80e3, 10e3]]  # [m]
RADIUS, ALTITUDE = 9000.0, 1500.0
SEEDS = range(100, 105)  # of the turbulence; the gains were chosen on others
WEATHER = {
    "calm": [(Conditions(), 0)],
    **{f"10@{d}": [(Conditions(wind=Wind.blowing_from(10.0, d)), 0)] for d in (0, 90, 180, 270)},
    "dryden": [(Conditions(dryden=MARS.daytime), seed) for seed in SEEDS],
}


def row(path: Path, controller: str, conditions: Conditions, seed: int) -> list[float]:
    """Cross-track p95 and max [m], altitude error [m], bank [deg], fuel [kg], stall margin [deg], wall time [s]."""
    start = time.perf_counter()
    outcome = run_trial(Trial("route", path, "ares", controller, altitude=ALTITUDE, conditions=conditions, seed=seed))
    took = time.perf_counter() - start
    if outcome.track.ended != "completed":
        return [math.inf] * 7
    track, metrics = outcome.track, outcome.metrics
    names = ("cross_track_p95", "cross_track_max", "altitude_error_max")
    return [
        *(metrics[name].value for name in names),
        math.degrees(np.abs(track["bank"]).max()),
        track["fuel"][0] - track["fuel"][-1],
        math.degrees(metrics["stall_margin_min"].value),
        took,
    ]


def main() -> None:
    """Print one line a controller and weather, the worst of the seeds."""
    path, _ = fly_by(Path(CORNERS), lambda course, angle: RADIUS, 1.0)
    print(f"{path.length / 1000:.1f} km; ct = cross-track error; the worst over the seeds")
    print(f"{'controller':13s} {'weather':7s} ct p95 m  ct max m  alt m  bank deg  fuel kg  margin deg  wall s")
    for controller in ALL_CONTROLLERS:
        for weather, runs in WEATHER.items():
            rows = np.array([row(path, controller.name, conditions, seed) for conditions, seed in runs])
            p95, worst, alt, bank, fuel, _, took = rows.max(axis=0)
            print(
                f"{controller.name:13s} {weather:7s} {p95:8.2f} {worst:9.2f} {alt:6.2f} {bank:9.1f} {fuel:8.2f} "
                f"{rows[:, 5].min():11.2f} {took:7.2f}"
            )


if __name__ == "__main__":
    main()
