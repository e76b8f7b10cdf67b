"""One trial: assess the plan, follow it, measure, judge; for one vehicle, or for a fleet."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from planners.clearance import clearance
from planners.errors import InputError, TrackworthyError
from planners.map import Map
from planners.path import Path
from sim.aircraft_file import Aircraft
from sim.planet import Planet
from sim.vehicle import Conditions, Vehicle
from sim.vehicles import make_vehicle
from sim.wind import Wind
from tracking.controllers import make_controller
from tracking.feasibility import assess
from tracking.fleet import FLEET_METRICS, Departures, fleet_outcome, member_seed
from tracking.loop import ON_PATH, Offset, follow, start_pose
from tracking.metrics import measure
from tracking.outcome import Outcome
from tracking.requirements import default_requirements, split_requirement, with_user_requirements
from tracking.run import Run
from tracking.sensors import PERFECT, Sensors
from tracking.track import Track
from tracking.verdict import TRACKWORTHY, judge

LONGEST_TIME = 24 * 3600.0  # [s] beyond any tank, and a million samples in memory


@dataclass(frozen=True, slots=True)
class Trial:
    """What to try. None stands for the vehicle's own default; `altitude` [m] counts where the path has no heights.

    `planet` is where the vehicle is, None for its own. The frame of `conditions` is the path's, where it has one.
    `speed` [m/s] is true airspeed or ground speed, `corridor` [m] the half-width, `require` requirements as the
    user writes them, `expect` the expected verdict.

    `others` are the paths of the rest of a fleet, one more such vehicle each, under way at the same time: `departures`
    says whether they leave together or separated by delays, `separation` [m] how far apart they must stay.
    """

    name: str
    path: Path
    vehicle: str | Aircraft
    controller: str = "lqr"
    speed: float | None = None
    altitude: float | None = None
    corridor: float | None = None
    conditions: Conditions = field(default_factory=Conditions)
    offset: Offset = ON_PATH
    sensors: Sensors = PERFECT
    obstacles: Map | None = None
    max_range: float | None = None
    steering_hz: float = 20.0
    require: Sequence[str] = ()
    expect: str = TRACKWORTHY
    seed: int = 0
    notes: tuple[str, ...] = ()
    planet: Planet | None = None
    others: tuple[Path, ...] = ()
    departures: Departures = "together"
    separation: float | None = None


def run_trial(trial: Trial, tracks: Sequence[Track] = ()) -> Outcome:
    """Run it; or judge `tracks`, one a vehicle, as what it gave before.

    Raises `InputError` for what cannot be tried, `TrackworthyError` when the simulator fails.
    """
    if not trial.others:
        return _run_alone(trial, tracks[0] if tracks else None)
    own = tuple(text for text in trial.require if split_requirement(text)[0] not in FLEET_METRICS)
    paths = (trial.path, *trial.others)
    members = [
        _run_alone(replace(trial, path=path, require=own, seed=member_seed(trial.seed, i)), track)
        for i, (path, track) in enumerate(zip(paths, tracks or (None,) * len(paths), strict=True))
    ]
    separation = members[0].limits.separation if trial.separation is None else trial.separation
    return fleet_outcome(trial.name, members, trial.departures, separation, trial.require)


def _run_alone(trial: Trial, known: Track | None = None) -> Outcome:
    vehicle = make_vehicle(trial.vehicle, trial.steering_hz, trial.planet)
    limits = vehicle.limits
    speed = limits.speed if trial.speed is None else trial.speed
    altitude = limits.altitude if trial.altitude is None else trial.altitude
    corridor = limits.corridor if trial.corridor is None else trial.corridor
    if not (corridor > 0.0 and math.isfinite(corridor)):
        raise InputError("corridor", f"{corridor:g} m is not a half-width", "choose one above 0")
    conditions = trial.conditions
    if limits.kind == "ground":  # no wind moves a truck
        conditions = replace(conditions, wind=Wind(), turbulence=0.0, gust=None, dryden=None)
    if trial.path.frame is not None:
        conditions = replace(conditions, frame=trial.path.frame)
    _check_start(trial, vehicle)
    feasibility = assess(trial.path, limits, speed, conditions.wind, corridor)
    if trial.path.length > LONGEST_TIME * speed:
        raise InputError(
            trial.path.name,
            f"its {trial.path.length / 1000:.0f} km take more than {LONGEST_TIME / 3600:.0f} h at {speed:.4g} m/s",
            "give a shorter path",
        )
    controller = make_controller(trial.controller)
    try:
        if known is None:
            track = follow(
                trial.path, vehicle, controller, speed, altitude, conditions, trial.seed, trial.sensors, trial.offset
            )
        else:
            track = replace(known, frame=trial.path.frame)
    except (ArithmeticError, RuntimeError) as error:
        raise TrackworthyError(f"{trial.name}: the simulator of {vehicle.name} failed: {error}") from error
    run = Run(trial.path, track, limits, speed, corridor, conditions, feasibility, trial.obstacles, trial.max_range)
    metrics = measure(run)
    defaults = default_requirements(limits, corridor, trial.obstacles is not None)
    requirements = with_user_requirements(defaults, trial.require, metrics)
    return Outcome(
        name=trial.name, path=trial.path, obstacles=trial.obstacles, vehicle=vehicle.name, limits=limits,
        controller=controller.name, speed=speed, corridor=corridor, conditions=conditions, seed=trial.seed, track=track,
        metrics=metrics, feasibility=feasibility, verdict=judge(metrics, requirements, trial.expect), notes=trial.notes,
    )  # fmt: skip


def _check_start(trial: Trial, vehicle: Vehicle) -> None:
    """A run that starts inside an obstacle, or beyond the edge, says nothing about the path."""
    if trial.obstacles is None:
        return
    pose = start_pose(trial.path, trial.offset, 0.0)
    x, y = pose.x, pose.y
    clear = float(clearance(trial.obstacles, np.array([[x, y, pose.course]]), vehicle.limits.footprint)[0])
    if clear < 0.0:
        raise InputError(
            trial.path.name,
            f"its start ({x:.1f}, {y:.1f}) m has the {vehicle.name} {-clear:.2f} m in an obstacle or over the edge",
            "start the path farther in",
        )
