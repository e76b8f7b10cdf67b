import dataclasses
import math

import numpy as np
import pytest
from sample_verdicts import error, judged

from planners.map import Map
from reports.words.plain_words import plain
from sim.vehicle import STALL
from tracking.feasibility import Slope, Turn
from tracking.metric import Metric

CORNER = Turn(3400.0, 0.0, 0.0, 1.0, 210.0, 530.0)


def one(name, value, unit, **changes):
    return Metric(name, value, unit, **({"s": 3400.0, "t": 62.0} | changes))


def said(outcome, metric, comparison, limit, **changes):
    usual = dataclasses.replace(metric, better="higher" if comparison == ">=" else "lower")
    return plain(judged(outcome, (usual, comparison, limit), **changes))


def test_the_sentence_of_the_brief(route):
    told = said(route, error(42.0, 3400.0), "<=", route.corridor, turns=(CORNER,))
    assert told == "misses the corridor by 12 m at 3.4 km, because the corner there needs a 530 m turn and offers 210 m"


def test_a_requirement_the_other_way_round_says_what_is_asked(route):
    metric = error(0.5, 3400.0)
    told = plain(judged(route, (metric, ">=", 0.6)))
    assert told == "has a cross-track error of 0.5 m at 3.4 km, where at least 0.6 m is asked"


@pytest.mark.parametrize(
    ("name", "value", "unit", "comparison", "limit", "told"),
    [
        ("cross_track_max", 42.0, "m", "<=", 20.0, "strays 42 m from the path at 3.4 km, where 20 m is allowed"),
        (
            "cross_track_p95", 0.4, "m", "<=", 0.35,
            "keeps within 0.4 m of the path for 95 % of the way, where 0.35 m is allowed",
        ),
        ("cross_track_rms", 0.4, "m", "<=", 0.35, "has an RMS cross-track error of 0.4 m, where 0.35 m is allowed"),
        (
            "bank_max", math.radians(68.0), "rad", "<=", math.radians(60.0),
            "banks to 68° at 3.4 km, 8° beyond the limit of 60°",
        ),
        ("load_factor_max", 4.0, "g", "<=", 3.8, "is loaded with 4 g at 3.4 km, 0.2 g beyond the limit of 3.8 g"),
        (
            "lateral_acceleration_max", 7.0, "m/s^2", "<=", 5.88399,
            "corners with 7 m/s² (0.714 g) of lateral acceleration at 3.4 km, "
            "1.12 m/s² beyond the limit of 5.88 m/s² (0.6 g)",
        ),
        ("altitude_error_max", 45.0, "m", "<=", 30.5, "is 45 m off its altitude at 3.4 km, where 30.5 m is allowed"),
        ("speed_error_max", 7.0, "m/s", "<=", 5.0, "is 7 m/s off its speed at 3.4 km, where 5 m/s is allowed"),
        (
            "stall_margin_min", math.radians(1.2), "rad", ">=", math.radians(3.0),
            "comes within 1.2° of the stall at 3.4 km, where 3° must be left",
        ),
        ("range_used", 1.12, "share", "<=", 1.0, "uses 112 % of its range, where 100 % is allowed"),
        ("overshoot_max", 5.0, "m", "<=", 2.0, "has an overshoot of 5 m at 3.4 km, where at most 2 m is asked"),
    ],
)  # fmt: skip
def test_every_kind_of_requirement_has_its_sentence(route, name, value, unit, comparison, limit, told):
    assert said(route, one(name, value, unit), comparison, limit) == told


def test_what_two_share_says_who(route):
    metric = one("separation_min", 312.0, "m", s=math.nan, t=210.0, who="1 and 3")
    assert said(route, metric, ">=", 1000.0) == (
        "aircraft 1 and 3 come within 312 m of each other after 210 s, where 1 km must be kept"
    )


def test_a_path_that_is_not_followed_to_its_end(route):
    metric = one("completion", 0.4, "share", s=0.4 * route.path.length)
    assert said(route, metric, ">=", 1.0).startswith("follows only 40 % of the path, and ends at ")


def test_obstacle_and_edge_are_told_apart(yard):
    track, depth = yard.track, 1.0
    at = {"s": float(track["s"][5]), "t": float(track["t"][5])}
    x, y = float(track["x"][5]), float(track["y"][5])
    wall = Map(polygons=(np.array([(x - 9, y - 9), (x + 9, y - 9), (x + 9, y + 9), (x - 9, y + 9)]),))
    edge = Map(bounds=(x + 1, y - 500.0, x + 500.0, y + 500.0))
    for area, told in ((wall, "hits an obstacle, up to 1 m inside at"), (edge, "leaves the map by up to 1 m at")):
        metric = Metric("clearance_min", -depth, "m", better="higher", **at)
        assert said(dataclasses.replace(yard, obstacles=area), metric, ">=", 0.0).startswith(told)
    assert said(yard, Metric("clearance_min", -1.0, "m"), ">=", 0.0).startswith("touches an obstacle or the map's edge")


def test_a_leg_too_steep_is_the_cause(route):
    metric = one("altitude_error_max", 45.0, "m")
    assert said(route, metric, "<=", 30.0, steep=(Slope(3000.0, 9e3, 0.12, 0.08),)).endswith(
        ", because the leg from 3 km climbs 12 %, and the vehicle can do 8 %"
    )


def test_turns_elsewhere_are_not_there(route):
    far = dataclasses.replace(CORNER, s=20e3)
    told = said(route, error(42.0), "<=", 30.0, turns=(far,))
    assert told.endswith(", because the corner at 20 km needs a 530 m turn and offers 210 m")
    told = said(route, error(42.0), "<=", 30.0, turns=(far, dataclasses.replace(far, s=30e3, available=100.0)))
    assert told.endswith(", because 2 turns are too tight; the worst, at 30 km, needs a 530 m turn and offers 100 m")
    before = said(route, error(42.0, 3600.0), "<=", 30.0, turns=(CORNER,))
    assert "because the corner before it needs" in before


def test_numbers_have_the_article_they_are_spoken_with(route):
    for needed, told in ((8.0, "an 8 m"), (11.8, "an 11.8 m"), (18.0, "an 18 m"), (110.0, "a 110 m"), (7.0, "a 7 m")):
        corner = dataclasses.replace(CORNER, required=needed, available=1.0)
        assert f"needs {told} turn" in said(route, error(42.0, 3400.0), "<=", 30.0, turns=(corner,))


def test_what_follows_from_a_stall_is_not_told(route):
    stalled = dataclasses.replace(route, track=dataclasses.replace(route.track, ended=STALL))
    assert said(stalled, error(42.0), "<=", 30.0).startswith("stalls at ")


def test_met_and_unmeasured_and_unasked(route):
    assert said(route, one("bank_max", 0.5, "rad"), "<=", 1.0) == (
        "meets every requirement; closest to its limit: bank 28.6° of 57.3° at 3.4 km"
    )
    lost = Metric("clearance_min", math.nan, "m", valid=False, note="no map was given")
    assert said(route, lost, ">=", 0.0) == "has no clearance that could be measured (no map was given)"
    assert plain(judged(route)) == "has no requirement to meet"


def test_others_missed_are_counted(route):
    outcome = judged(route, (error(60.0), "<=", 30.0), (one("bank_max", 1.0, "rad"), "<=", 0.9))
    assert plain(outcome).endswith("; misses 1 more requirement")
