import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from planners.map import Circle, Map
from planners.path import Path
from sim.vehicle import Conditions
from sim.vehicles import make_vehicle
from tracking.feasibility import assess
from tracking.metrics import measure
from tracking.metrics.errors import weighted_quantile
from tracking.metrics.frechet import frechet_distance
from tracking.run import Run
from tracking.track import GUIDANCE_COLUMNS, STATE_COLUMNS, Track

TRUCK = make_vehicle("truck")
LINE = Path([[0.0, 0.0], [100.0, 0.0]])


def projections(x, y, path, window):
    """Each position projected on `path`, forwards from the one before."""
    found, s = [], 0.0
    for px, py in zip(x, y, strict=True):
        found.append(path.project(px, py, s, s + window) if window else path.project(px, py))
        s = max(s, found[-1].s)
    return found


def run_along(x, y, path=LINE, corridor=0.5, obstacles=None, speed=10.0, window=None, **columns):
    """A run whose truck was at x, y (N,), at constant speed, projected on `path`."""
    x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    course = np.arctan2(np.gradient(y), np.gradient(x))
    at = projections(x, y, path, window)
    steps = np.hypot(np.diff(x), np.diff(y))
    values = {
        "t": np.concatenate([[0.0], np.cumsum(steps)]) / speed,
        "x": x,
        "y": y,
        "heading": course,
        "course": course,
        "ground_speed": np.full(len(x), speed),
        "airspeed": np.full(len(x), speed),
        "s": [p.s for p in at],
        "cross_track": [p.cross_track for p in at],
        "path_heading": [p.heading for p in at],
        "speed_command": np.full(len(x), speed),
        **columns,
    }
    names = (*STATE_COLUMNS, *TRUCK.channels, *GUIDANCE_COLUMNS)
    data = np.column_stack([np.broadcast_to(values.get(name, 0.0), len(x)) for name in names])
    conditions, limits = Conditions(), TRUCK.limits
    feasibility = assess(path, limits, speed, conditions.wind, corridor)
    return Run(path, Track(names, data, "completed"), limits, speed, corridor, conditions, feasibility, obstacles)


def value(run, name):
    metric = measure(run)[name]
    assert metric.valid
    return metric.value


def test_a_track_beside_the_path_has_its_offset_everywhere():
    metrics = measure(run_along(np.linspace(0, 100, 201), np.full(201, -0.3)))
    for name in ("rms", "p50", "p95", "p99", "max"):
        assert metrics[f"cross_track_{name}"].value == pytest.approx(0.3)
    assert metrics["cross_track_mean"].value == pytest.approx(-0.3)
    assert metrics["completion"].value == 1.0
    assert metrics["corridor_fraction"].value == pytest.approx(1.0)
    assert metrics["corridor_violation_count"].value == 0.0
    assert metrics["frechet"].value == pytest.approx(0.3, abs=0.03)
    assert metrics["length_ratio"].value == pytest.approx(1.0)


def test_percentiles_weigh_distance_not_time():
    """Ten samples a metre for a tenth of the way at 1 m, one a metre for the rest at 0: the median is 0."""
    x = np.concatenate([np.linspace(0, 10, 100, endpoint=False), np.linspace(10, 100, 91)])
    y = np.where(x < 10.0, 1.0, 0.0)
    assert value(run_along(x, y), "cross_track_p50") == 0.0
    assert value(run_along(x, y), "cross_track_mean") == pytest.approx(0.1, abs=0.01)


def test_an_excursion_is_counted_timed_and_measured():
    x = np.linspace(0, 100, 1001)
    y = np.where((x > 40) & (x < 60), 2.0, 0.0)
    metrics = measure(run_along(x, y))
    assert metrics["corridor_violation_count"].value == 1.0
    assert metrics["corridor_violation_worst"].value == pytest.approx(1.5)
    assert 40.0 < metrics["corridor_violation_worst"].s < 60.0
    assert metrics["corridor_fraction"].value == pytest.approx(0.8, abs=0.005)
    assert metrics["corridor_violation_distance"].value == pytest.approx(22.0, abs=0.5)
    assert metrics["corridor_violation_time"].value == pytest.approx(2.2, abs=0.1)


@given(st.floats(5.0, 95.0), st.floats(0.0, 3.0))
def test_an_incomplete_track_never_scores_better(end, offset):
    """Cutting a track short worsens every cross-track statistic, or leaves it."""
    whole = np.linspace(0, 100, 401)
    part = whole[whole <= end]
    full, short = (measure(run_along(x, np.full(len(x), offset))) for x in (whole, part))
    for name in ("rms", "p50", "p95", "p99", "max"):
        assert short[f"cross_track_{name}"].value >= full[f"cross_track_{name}"].value - 1e-9
    assert abs(short["cross_track_mean"].value) >= abs(full["cross_track_mean"].value) - 1e-9
    assert short["completion"].value == pytest.approx(part[-1] / 100.0)
    assert short["completion"].value < 1.0
    assert short["corridor_fraction"].value <= full["corridor_fraction"].value


def test_unreached_path_counts_metre_by_metre():
    metrics = measure(run_along(np.linspace(0, 50, 51), np.zeros(51)))
    assert metrics["cross_track_max"].value == pytest.approx(49.0, abs=1.0)
    assert math.isnan(metrics["cross_track_max"].t)
    assert metrics["cross_track_mean"].value == pytest.approx(50.0**2 / 2 / 100)
    assert metrics["corridor_violation_distance"].value == pytest.approx(49.0)  # the first metre is near
    assert "1 of 2 waypoints" in metrics["completion"].note


def test_the_bias_of_unreached_path_is_on_the_side_of_the_tracks():
    half = np.linspace(0, 50, 51)
    assert value(run_along(half, np.full(51, -0.2)), "cross_track_mean") < -10.0
    assert value(run_along(half, np.full(51, 0.2)), "cross_track_mean") > 10.0


def test_path_that_is_retraced_is_not_reached_by_having_been_near_it_before():
    """Stopped where it should have turned back: the way back is as far as it is."""
    there_and_back = Path([[0.0, 0.0], [1000.0, 0.0], [0.0, 0.0]])
    metrics = measure(run_along(np.linspace(0, 999, 1000), np.zeros(1000), there_and_back, window=30.0))
    assert metrics["completion"].value == pytest.approx(0.5, abs=0.01)
    assert metrics["cross_track_p95"].value > 800.0
    assert metrics["corridor_fraction"].value == pytest.approx(0.5, abs=0.01)


def test_a_loop_left_out_is_not_followed():
    """Straight on, past a loop of 30 m radius that the projection leaps over."""
    ring = np.linspace(0.0, 2 * math.pi, 200)
    loop = np.column_stack([50.0 + 30.0 * np.sin(ring), 30.0 * (1.0 - np.cos(ring))])
    path = Path(np.concatenate([[[0.0, 0.0]], loop, [[100.0, 0.0]]]))
    metrics = measure(run_along(np.linspace(0, 101, 203), np.zeros(203), path, window=300.0))
    assert metrics["cross_track_max"].value == pytest.approx(60.0, abs=1.0)
    assert metrics["completion"].value < 0.5
    assert metrics["corridor_fraction"].value < 0.5
    assert "200 of" not in metrics["completion"].note


def test_a_corner_cut_within_the_corridor_is_followed():
    path = Path([[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]])
    x = np.concatenate([np.linspace(0, 47, 95), np.linspace(47, 50, 8)[1:], np.full(100, 50.0)])
    y = np.concatenate([np.zeros(95), np.linspace(0, 3, 8)[1:], np.linspace(3.5, 50.5, 100)])
    metrics = measure(run_along(x, y, path, corridor=4.0))
    assert metrics["completion"].value == 1.0
    assert metrics["corridor_fraction"].value == pytest.approx(1.0)
    assert metrics["cross_track_max"].value == pytest.approx(3.0 / math.sqrt(2.0), abs=0.3)


def test_lateral_and_steering_extremes_come_from_their_channels():
    steering = np.linspace(-0.2, 0.1, 11)
    rate = np.linspace(0.0, -0.3, 11)
    saturated = np.where(np.arange(11) < 3, 1.0, 0.0)
    run = run_along(np.linspace(0, 100, 11), np.zeros(11), steering=steering, steering_rate=rate, saturated=saturated)
    metrics = measure(run)
    assert metrics["steering_max"].value == pytest.approx(0.2)
    assert metrics["steering_rate_max"].value == pytest.approx(0.3)
    assert metrics["control_saturation"].value == pytest.approx(3 / 11)
    assert "range_used" not in metrics
    limited = Run(run.path, run.track, run.limits, 10.0, 0.5, run.conditions, run.feasibility, max_range=50.0)
    assert measure(limited)["range_used"].value == pytest.approx(2.0)


def test_the_trucks_body_is_ahead_of_its_rear_axle():
    """A wall 2 m behind the axle clears the body, which begins 1.25 m behind it; 2 m ahead, it is inside."""
    behind = Map(polygons=(np.array([[-4.0, -3.0], [-2.0, -3.0], [-2.0, 3.0], [-4.0, 3.0]]),))
    run = run_along(np.linspace(0, 100, 11), np.zeros(11), obstacles=behind)
    assert value(run, "clearance_min") == pytest.approx(2.0 - (3.5 - 2.25))


def test_flown_turn_is_the_course_change_over_the_median_leg():
    angle = np.linspace(0.0, math.pi / 2, 400)
    path = Path([[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [30.0, 30.0]])
    run = run_along(30.0 * np.sin(angle), 30.0 * (1.0 - np.cos(angle)), path)
    assert value(run, "turn_angle_max_flown") == pytest.approx(10.0 / 30.0, rel=0.02)
    assert value(run, "turn_angle_max_planned") == pytest.approx(math.atan2(30.0, 10.0))


def test_cut_and_overshoot_are_told_apart():
    path = Path([[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]])
    beyond = np.concatenate([np.linspace([0, 0], [55, 0], 56), np.linspace([55, 0], [50, 50], 51)])
    inside = np.concatenate([np.linspace([0, 0], [40, 0], 41), np.linspace([40, 0], [50, 10], 15)[1:], [[50, 50]]])
    over, cut = measure(run_along(*beyond.T, path)), measure(run_along(*inside.T, path))
    assert over["overshoot_max"].value == pytest.approx(5.0)
    assert over["corner_cut_max"].value < 0.1
    assert cut["corner_cut_max"].value == pytest.approx(5.0, abs=0.1)
    assert cut["overshoot_max"].value < 0.1


def test_heading_errors_wrap():
    west = Path([[0.0, 0.0], [-100.0, 0.0]])
    run = run_along(np.linspace(0, -100, 101), np.linspace(0, -1.0, 101), west)
    assert value(run, "course_error_max") == pytest.approx(0.01, rel=0.01)


def test_clearance_counts_the_body_and_its_incursions():
    trees = Map(circles=(Circle(30.0, 4.0, 2.0), Circle(70.0, 2.5, 2.0)))
    run = run_along(np.linspace(0, 100, 401), np.zeros(401), obstacles=trees)
    metrics = measure(run)
    assert metrics["clearance_min"].value < 0.0
    assert metrics["incursion_depth"].value == -metrics["clearance_min"].value
    assert metrics["incursion_count"].value == 1.0
    # Body 7 m long, centred 2.25 m ahead; its flank at 1.25 m cuts the circle around 2.5 m to a half chord of 1.56 m
    half_chord = math.sqrt(2.0**2 - 1.25**2)
    assert metrics["incursion_time"].value == pytest.approx((7.0 + 2 * half_chord) / 10.0, abs=0.06)


def test_without_a_map_clearance_is_not_measured():
    metric = measure(run_along(np.linspace(0, 100, 11), np.zeros(11)))["clearance_min"]
    assert not metric.valid
    assert metric.note == "no map was given"


def test_demanded_lateral_acceleration_is_speed_squared_times_commanded_curvature():
    run = run_along(np.linspace(0, 100, 11), np.zeros(11), curvature_command=np.full(11, -0.05))
    assert value(run, "lateral_acceleration_demanded") == pytest.approx(5.0)


def test_needed_lateral_acceleration_is_of_the_plan_at_the_commanded_speed_however_it_is_driven():
    """A corner of 90 deg at 10 m/s, turned over the way of 0.5 s: v d / 0.5 s, and worst at the corner."""
    corner = Path([[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]])
    for x in (np.linspace(0, 50, 11), np.linspace(0, 20, 11)):
        needed = measure(run_along(x, 0.01 * x, corner, speed=10.0, ground_speed=3.0))["lateral_acceleration_needed"]
        assert needed.value == pytest.approx(10.0 * math.pi / 2 / 0.5)
        assert needed.s == pytest.approx(50.0)


def test_a_track_of_one_sample_is_measured():
    metrics = measure(_one_sample())
    assert metrics["completion"].value == 0.0
    assert metrics["cross_track_max"].value == pytest.approx(99.5)
    assert not metrics["frechet"].valid


def _one_sample():
    run = run_along(np.array([0.0, 1.0]), np.zeros(2))
    track = Track(run.track.columns, run.track.data[:1], run.track.ended)
    return Run(run.path, track, run.limits, 10.0, 0.5, run.conditions, run.feasibility)


CURVES = arrays(float, st.tuples(st.integers(1, 8), st.just(2)), elements=st.integers(-9, 9).map(float))


@given(CURVES, CURVES)
def test_frechet_distance_is_the_textbook_recursion(a, b):
    """Eiter and Mannila 1994, the whole table, without the bound that makes ours fast."""
    table = np.empty((len(a), len(b)))
    for i in range(len(a)):
        for j in range(len(b)):
            before = [table[p, q] for p, q in ((i - 1, j), (i, j - 1), (i - 1, j - 1)) if p >= 0 and q >= 0]
            table[i, j] = max(min(before, default=0.0), math.dist(a[i], b[j]))
    assert frechet_distance(a, b) == pytest.approx(table[-1, -1])
    assert frechet_distance(b, a) == pytest.approx(table[-1, -1])


@given(arrays(float, st.integers(1, 30), elements=st.floats(-10, 10)), st.floats(0.01, 1.0))
def test_with_equal_weights_the_quantile_is_the_inverted_cdf(values, share):
    expected = np.quantile(values, share, method="inverted_cdf")
    assert weighted_quantile(values, np.ones(len(values)), share) == expected


def test_every_metric_has_a_unit_and_a_direction():
    for name, metric in measure(run_along(np.linspace(0, 100, 11), np.zeros(11))).items():
        assert metric.name == name
        assert metric.unit in {"m", "s", "1", "share", "rad", "rad/s", "m/s", "m/s^2", "g"}
        assert metric.better in {"lower", "higher", "neither"}
        assert metric.valid or metric.note
