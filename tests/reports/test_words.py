import dataclasses
import math

from sample_verdicts import error, judged

from reports.words.words import reason, sentence, setting
from tracking.feasibility import Slope, Turn
from tracking.metric import Metric
from tracking.verdict import Verdict


def test_trackworthy(route):
    outcome = judged(route, (error(12.3), "<=", 30.0))
    assert sentence(outcome) == (
        "TRACKWORTHY  c172x · lqr · 55 m/s · wind 10 m/s from 270°: "
        "every requirement met; closest: cross-track error 12.3 m of 30 m"
    )


def test_not_trackworthy_names_the_turn(route):
    turn = Turn(3300.0, 0.0, 0.0, 1.0, 72.0, 530.0)
    outcome = judged(route, (error(42.1), "<=", 30.0), turns=(turn,))
    assert sentence(outcome) == (
        "NOT TRACKWORTHY  c172x · lqr · 55 m/s · wind 10 m/s from 270°: "
        "cross-track error 42.1 m > 30 m at 3.41 km: the turn there needs a 530 m radius and offers 72 m"
    )


def test_the_worst_turn_is_named_when_none_is_near(route):
    turns = tuple(Turn(s, 0, 0, 1.0, offers, 530.0) for s, offers in ((20e3, 72.0), (25e3, 900.0), (30e3, 100.0)))
    assert "2 turns are too tight; the worst, at 20 km, needs" in reason(
        judged(route, (error(42.1), "<=", 30.0), turns=turns)
    )
    assert ": the turn at 20 km needs a 530 m radius and offers 72 m" in reason(
        judged(route, (error(42.1, math.nan), "<=", 30.0), turns=turns[:1])
    )


def test_a_stretch_is_one_turn(route):
    turns = tuple(Turn(s, 0, 0, 0.2, 900.0 - s / 5, 530.0) for s in range(1000, 3500, 100))
    assert reason(judged(route, (error(42.1), "<=", 30.0), turns=turns)).endswith(
        "at 3.41 km: the turn there, from 1.9 km to 3.4 km, needs a 530 m radius and offers 220 m"
    )
    assert reason(judged(route, (error(42.1, 30e3), "<=", 30.0), turns=turns)).endswith(
        "at 30 km: the turn from 1.9 km to 3.4 km needs a 530 m radius and offers 220 m"
    )


def test_a_turn_that_no_radius_helps(route):
    turn = Turn(3300.0, 0.0, 0.0, 1.0, 72.0, math.inf)
    assert "cannot be flown in this wind" in reason(judged(route, (error(42.1), "<=", 30.0), turns=(turn,)))


def test_a_steep_leg_explains_a_missed_height(route):
    height = Metric("altitude_error_max", 80.0, "m", s=9e3)
    outcome = judged(route, (height, "<=", 30.0), steep=(Slope(8.5e3, 9.2e3, 0.12, 0.08),))
    assert reason(outcome).endswith("the leg from 8.5 km climbs 12 % and the vehicle can do 8 %")


def test_speed_is_not_blamed_on_turns(route):
    speed = Metric("speed_error_max", 9.0, "m/s", s=3.3e3)
    turn = Turn(3300.0, 0.0, 0.0, 1.0, 72.0, 530.0)
    assert reason(judged(route, (speed, "<=", 5.0), turns=(turn,))) == "speed error 9 m/s > 5 m/s at 3.3 km"


def test_unmeasured_is_missed(route):
    metric = Metric("cross_track_max", math.nan, "m", valid=False, note="the vehicle did not move")
    assert reason(judged(route, (metric, "<=", 30.0))) == (
        "cross-track error could not be measured: the vehicle did not move"
    )


def test_ended_early_and_others_missed(route):
    completion = Metric("completion", 0.5, "share", "higher", s=20e3)
    track = dataclasses.replace(route.track, ended="stall")
    outcome = judged(route, (completion, ">=", 1.0), (error(30.5), "<=", 30.0), track=track)
    assert reason(outcome) == (
        "the run ended early: stall at 40.4 km; completion 50 % < 100 % at 20 km; 1 more requirement missed"
    )


def test_what_cannot_be_better_is_not_the_closest(route):
    completion = Metric("completion", 1.0, "share", "higher")
    incursions = Metric("incursion_count", 0.0, "1")
    outcome = judged(route, (completion, ">=", 1.0), (incursions, "<=", 0.0), (error(3.0), "<=", 30.0))
    assert reason(outcome) == "every requirement met; closest: cross-track error 3 m of 30 m"
    outcome = judged(route, (completion, ">=", 1.0))
    assert reason(outcome) == "every requirement met; closest: completion 100 % of at least 100 %"


def test_expectations(route):
    assert sentence(judged(route, (error(40.0), "<=", 30.0), expect="not-trackworthy")).startswith(
        "NOT TRACKWORTHY (as expected)  "
    )
    assert sentence(judged(route, (error(3.0), "<=", 30.0), expect="not-trackworthy")).startswith(
        "TRACKWORTHY (expected not to be)  "
    )


def test_no_requirements(route):
    outcome = dataclasses.replace(route, verdict=Verdict(()))
    assert reason(outcome) == "no requirement was stated"


def test_a_truck_has_kilometres_an_hour_and_no_wind(yard):
    assert setting(yard) == "truck · lqr · 8 m/s (28.8 km/h)"
