import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planners.errors import InputError
from sim.vehicles import ALL_VEHICLES, make_vehicle
from tracking.metric import Metric, Requirement
from tracking.requirements import default_requirements, parse_requirement, with_user_requirements
from tracking.verdict import EITHER, NOT_TRACKWORTHY, TRACKWORTHY, judge

METRICS = {
    "cross_track_p95": Metric("cross_track_p95", 3.0, "m"),
    "bank_max": Metric("bank_max", 0.6, "rad"),
    "lateral_acceleration_max": Metric("lateral_acceleration_max", 5.0, "m/s^2"),
    "clearance_min": Metric("clearance_min", math.nan, "m", "higher", valid=False, note="no map was given"),
}


@pytest.mark.parametrize(
    ("text", "comparison", "limit"),
    [
        ("cross_track_p95<=4", "<=", 4.0),
        ("cross_track_p95 <= 0.5km", "<=", 500.0),
        ("bank_max<=40deg", "<=", math.radians(40.0)),
        ("bank_max<=40", "<=", math.radians(40.0)),
        ("bank_max<=0.7rad", "<=", 0.7),
        ("lateral_acceleration_max<=0.5g", "<=", 0.5 * 9.80665),
        ("clearance_min>=2", ">=", 2.0),
    ],
)
def test_limits_are_read_with_their_units(text, comparison, limit):
    requirement = parse_requirement(text, METRICS)
    assert requirement.comparison == comparison
    assert requirement.limit == pytest.approx(limit)


@pytest.mark.parametrize("text", ["cross_track_p95", "cross_track_p95<4", "beauty<=1", "bank_max<=4m", "bank_max<=x"])
def test_what_is_no_requirement_is_refused(text):
    with pytest.raises(InputError, match="require"):
        parse_requirement(text, METRICS)


@given(st.floats(-100, 100), st.floats(-100, 100))
def test_a_margin_is_positive_exactly_when_the_limit_is_kept(value, limit):
    metrics = {"x": Metric("x", value, "m")}
    below = judge(metrics, [Requirement("x", "<=", limit)], TRACKWORTHY)
    above = judge(metrics, [Requirement("x", ">=", limit)], TRACKWORTHY)
    assert below.trackworthy == (value <= limit)
    assert above.trackworthy == (value >= limit)
    assert below.margins[0].value == pytest.approx(-above.margins[0].value)


def test_what_could_not_be_measured_is_not_met():
    verdict = judge(METRICS, [Requirement("clearance_min", ">=", 0.0)], TRACKWORTHY)
    assert not verdict.trackworthy


def test_an_expected_failure_passes_and_an_unexpected_success_does_not():
    good, bad = Requirement("cross_track_p95", "<=", 4.0), Requirement("cross_track_p95", "<=", 2.0)
    assert judge(METRICS, [good], TRACKWORTHY).passed
    assert not judge(METRICS, [bad], TRACKWORTHY).passed
    assert judge(METRICS, [bad], NOT_TRACKWORTHY).passed
    assert not judge(METRICS, [good], NOT_TRACKWORTHY).passed
    assert judge(METRICS, [good], EITHER).passed
    assert judge(METRICS, [bad], EITHER).passed
    assert not judge(METRICS, [bad], EITHER).trackworthy


@pytest.mark.parametrize("vehicle", ALL_VEHICLES)
def test_every_vehicle_has_sensible_defaults(vehicle):
    limits = make_vehicle(vehicle).limits
    required = {r.metric: r for r in default_requirements(limits, limits.corridor, has_map=True)}
    assert required["completion"].limit == 1.0
    assert required["cross_track_max"].limit == limits.corridor
    assert required["clearance_min"].limit == 0.0
    expected = {
        "fixed-wing": {"bank_max", "load_factor_max", "stall_margin_min"},
        "ground": {"lateral_acceleration_max"},
    }
    assert expected[limits.kind] <= set(required)
    assert all(requirement.source for requirement in required.values())


def test_the_users_limit_takes_the_place_of_the_default():
    defaults = (Requirement("cross_track_p95", "<=", 9.0), Requirement("bank_max", "<=", 1.0))
    chosen = with_user_requirements(defaults, ["cross_track_p95<=2", "cross_track_p95>=0"], METRICS)
    assert [(r.metric, r.comparison, r.limit) for r in chosen] == [
        ("cross_track_p95", "<=", 2.0),
        ("bank_max", "<=", 1.0),
        ("cross_track_p95", ">=", 0.0),
    ]


def test_the_decisive_margin_is_the_worst_missed_one_else_the_closest_that_could_be_better():
    whole = Metric("completion", 1.0, "share", "higher")
    metrics = {**METRICS, "completion": whole}
    met = [
        Requirement("completion", ">=", 1.0),
        Requirement("bank_max", "<=", 0.7),
        Requirement("cross_track_p95", "<=", 9),
    ]
    closest = judge(metrics, met, TRACKWORTHY).decisive
    assert closest is not None
    assert closest.metric.name == "bank_max"
    missed = judge(metrics, [*met, Requirement("lateral_acceleration_max", "<=", 1.0)], TRACKWORTHY).decisive
    assert missed is not None
    assert missed.metric.name == "lateral_acceleration_max"
    assert judge(metrics, [], TRACKWORTHY).decisive is None
