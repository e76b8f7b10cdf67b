"""Outcomes that look like real ones: a point mass that lags behind a pure pursuit, judged by the real verdict."""

import dataclasses
import math

import numpy as np
import pytest

from planners.footprint import Disc, Rectangle
from planners.frame import Frame
from planners.map import Circle, Map
from planners.path import Path
from sim.vehicle import Conditions, Limits
from sim.wind import Wind
from tracking.feasibility import Feasibility, Slope, Turn
from tracking.fleet import fleet_outcome
from tracking.metric import Metric, Requirement
from tracking.outcome import Outcome
from tracking.track import GUIDANCE_COLUMNS, STATE_COLUMNS, Track
from tracking.verdict import judge

G = 9.80665
PLANE = Limits(
    kind="fixed-wing", speed=55.0, speed_min=35.0, speed_max=65.0, lateral_acceleration=G * math.tan(math.radians(30)),
    response_time=1.2, equivalent_length=60.0, corridor=30.0, footprint=Disc(5.5), climb_gradient=0.08,
    descent_gradient=0.1,
)  # fmt: skip
TRUCK = Limits(
    kind="ground", speed=12.5, speed_min=1.0, speed_max=40.0, lateral_acceleration=0.6 * G, response_time=0.2,
    equivalent_length=4.5, corridor=0.5, footprint=Rectangle(7.0, 2.5, 2.25), curvature_max=1 / 4.5,
    steering_max=math.pi / 4, steering_rate=math.radians(30.0), friction=0.8,
)  # fmt: skip
PLANE_CHANNELS = ("bank", "pitch", "load_factor", "throttle")
TRUCK_CHANNELS = ("steering", "steering_rate", "lateral_acceleration", "friction_use")


def drive(path: Path, limits: Limits, speed: float, dt: float, look_ahead: float) -> Track:
    """A lagging, limited point mass under pure pursuit, as rows of a track."""
    plane = limits.kind == "fixed-wing"
    k_max = min(limits.lateral_acceleration / speed**2, limits.curvature_max)
    x, y, heading, k, t, s = *path.points[0, :2], path.headings[0], 0.0, 0.0, 0.0
    rows = []
    while t < 2.0 * path.length / speed:
        at = path.project(x, y, s, s + 4.0 * look_ahead)
        s = max(s, at.s)
        ahead = path.point_at(at.s + look_ahead)
        eta = (math.atan2(ahead[1] - y, ahead[0] - x) - heading + math.pi) % (2 * math.pi) - math.pi
        asked = 2.0 * math.sin(max(-1.5, min(1.5, eta))) / look_ahead
        held = max(-k_max, min(k_max, asked))
        before, k = k, k + (held - k) * min(1.0, dt / limits.response_time)
        a = speed * speed * k
        z = path.height_at(at.s) - 3.0 if path.z is not None else (300.0 if plane else 0.0)
        steer = (math.atan(4.5 * k), math.atan(4.5 * k) - math.atan(4.5 * before))
        own = (math.atan(a / G), 0.03, math.hypot(1, a / G), 0.6) if plane else (*steer, a, abs(a) / 7.8)
        rows.append((
            t, x, y, z, heading, heading, speed, speed, 0.0, k, float(held != asked), *own,
            at.s, at.cross_track, at.heading, asked, speed, z,
        ))  # fmt: skip
        if at.s >= path.length:
            break
        heading += speed * k * dt
        x, y, t = x + speed * math.cos(heading) * dt, y + speed * math.sin(heading) * dt, t + dt
    channels = PLANE_CHANNELS if plane else TRUCK_CHANNELS
    return Track((*STATE_COLUMNS, *channels, *GUIDANCE_COLUMNS), np.array(rows), "completed", path.frame)


def outcome_of(path, obstacles, limits, track, wind=Wind(), name="case", expect="trackworthy", notes=()):  # noqa: B008
    e = np.abs(track["cross_track"])
    worst = int(np.argmax(e))
    s, t = float(track["s"][worst]), float(track["t"][worst])
    metrics = [
        Metric("cross_track_mean", float(np.mean(track["cross_track"])), "m", "neither"),
        Metric("cross_track_rms", float(np.sqrt(np.mean(e**2))), "m"),
        Metric("cross_track_p95", float(np.percentile(e, 95)), "m"),
        Metric("cross_track_max", float(e[worst]), "m", s=s, t=t),
        Metric("completion", 1.0, "share", "higher"),
        Metric("corridor_fraction", float(np.mean(e <= limits.corridor)), "share", "higher", s=s, t=t),
        Metric("frechet", float(e[worst]), "m"),
        Metric("altitude_error_max", 3.0, "m") if path.z is not None else
        Metric("altitude_error_max", math.nan, "m", valid=False, note="the path has no heights"),
        Metric("path_length", path.length, "m", "neither"),
        Metric("length_ratio", 1.0034, "1"),
        Metric("turn_radius_required", 530.0, "m", "neither"),
        Metric("clearance_min", 41.7, "m", "higher", s=0.3 * path.length, t=0.3 * t),
    ]  # fmt: skip
    requirements = [
        Requirement("cross_track_max", "<=", limits.corridor, "corridor"),
        Requirement("completion", ">=", 0.98),
    ]
    for channel, unit, limit in (
        ("bank", "rad", math.radians(30.0)), ("load_factor", "1", 3.8), ("steering", "rad", math.radians(45)),
        ("lateral_acceleration", "m/s^2", 0.6 * G), ("friction_use", "1", 1.0),
    ):  # fmt: skip
        if channel in track:
            i = int(np.argmax(np.abs(track[channel])))
            place = {"s": float(track["s"][i]), "t": float(track["t"][i])}
            metrics.append(Metric(f"{channel}_max", float(abs(track[channel][i])), unit, **place))
            if channel != "friction_use":
                requirements.append(Requirement(f"{channel}_max", "<=", limit))
    turns = []
    for i in np.flatnonzero(np.abs(path.turns) > math.radians(5)):
        leg = min(path.s[i] - path.s[i - 1], path.s[i + 1] - path.s[i]) / 2
        d = abs(path.turns[i])
        room = min(leg / math.tan(d / 2), limits.corridor / (1 / math.cos(d / 2) - 1))
        turns.append(
            Turn(
                path.s[i],
                *path.points[i, :2],
                path.turns[i],
                room,
                limits.turn_radius(track["ground_speed"][0]),
            )
        )
    table = {metric.name: metric for metric in metrics}
    return Outcome(
        name=name, path=path, obstacles=obstacles, vehicle="c172x" if limits is PLANE else "truck", limits=limits,
        controller="lqr", speed=limits.speed, corridor=limits.corridor,
        conditions=Conditions(wind, path.frame or Frame(0.0, 0.0)), seed=7, track=track, metrics=table,
        feasibility=Feasibility(tuple(turns), ()), verdict=judge(table, requirements, expect), notes=notes,
    )  # fmt: skip


def make_route(name="delivery-route", dt=0.2, wind=Wind.blowing_from(10.0, 270.0)):  # noqa: B008
    """40 km x 1 km, with heights and a frame; one corner is too sharp."""
    points = [
        (0, 0, 300),
        (9e3, 400, 420),
        (17e3, -300, 420),
        (17.5e3, 350, 420),
        (28e3, 500, 600),
        (40e3, 0, 300),
    ]
    path = Path(np.array(points, float), Frame(48.1, 11.6), "route")
    obstacles = Map(
        polygons=(np.array([(11e3, -400.0), (14e3, -450.0), (14.2e3, -150.0), (11.5e3, -100.0)]),),
        circles=(Circle(22e3, -300.0, 400.0),),
        keep_in=(np.array([(-1e3, -1e3), (41e3, -1e3), (41e3, 1.2e3), (-1e3, 1.2e3)]),),
        frame=path.frame,
    )
    return outcome_of(
        path, obstacles, PLANE, drive(path, PLANE, 55.0, dt, 180.0), wind, name, notes=("2 items skipped",)
    )


def make_yard(name="yard", sharp=False):
    """A 70 m square for a truck, round enough to be driven unless `sharp`."""
    if sharp:
        xy = np.array([(5.0, 5.0), (5.0, 40.0), (35.0, 45.0), (40.0, 66.0), (66.0, 66.0)])
    else:
        t = np.linspace(0.0, np.pi / 2, 60)
        xy = np.column_stack([5 + 60 * np.sin(t), 66 - 61 * np.cos(t)])
    path = Path(xy, name=name)
    obstacles = Map(
        polygons=(np.array([(14.0, 52.0), (28.0, 52.0), (28.0, 64.0), (14.0, 64.0)]),),
        circles=(Circle(52.0, 15.0, 6.0),),
        bounds=(0.0, 0.0, 71.25, 71.25),
    )
    limits = dataclasses.replace(TRUCK, speed=8.0)
    return outcome_of(path, obstacles, limits, drive(path, limits, 8.0, 0.05, 5.0), name=name)


def cut(outcome, rows, **changes):
    """`outcome` with only some rows of its track: an index, a slice or an array of rows."""
    track = dataclasses.replace(outcome.track, data=outcome.track.data[rows], **changes)
    return dataclasses.replace(outcome, track=track)


@pytest.fixture(scope="session")
def route():
    return make_route()


@pytest.fixture(scope="session")
def yard():
    return make_yard()


@pytest.fixture(scope="session")
def sharp_yard():
    return make_yard("sharp-yard", sharp=True)


@pytest.fixture(scope="session")
def road():
    """Driven along a road much longer than wide."""
    path = Path(np.array([(0.0, 0.0), (120.0, 0.0), (240.0, 12.0), (500.0, 0.0)]))
    return outcome_of(path, None, TRUCK, drive(path, TRUCK, 12.5, 0.05, 6.0), name="road")


@pytest.fixture
def steep_leg():
    return Slope(9e3, 17e3, 0.12, 0.08)


def plane_on(points, name="path", speed=55.0):
    """A plane that flew the polyline through `points` [m], alone."""
    path = Path(np.array(points, float), name=name)
    obstacles = Map(circles=(Circle(2000.0, 3500.0, 400.0),), bounds=(-500.0, -500.0, 8500.0, 8500.0))
    return outcome_of(path, obstacles, PLANE, drive(path, PLANE, speed, 0.2, 180.0), name=name)


def make_fleet(name="fleet", departures="together", required=1000.0, require=()):
    """Three planes: the first two meet in the middle, the third keeps away and turns too sharply."""
    members = [
        plane_on([(0, 0), (8000, 8000)], "aircraft 1 to target 1"),
        plane_on([(0, 8000), (8000, 0)], "aircraft 2 to target 2"),
        plane_on([(7500, 0), (7500, 2500), (8000, 2600), (8000, 5000)], "aircraft 3 to target 3"),
    ]
    return fleet_outcome(name, members, departures, required, require)


@pytest.fixture(scope="session")
def fleet():
    return make_fleet()


@pytest.fixture(scope="session")
def apart_fleet():
    return make_fleet("apart", "separated")


@pytest.fixture(scope="session")
def plane():
    """Makes a plane that flew a polyline alone."""
    return plane_on
