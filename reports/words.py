"""The verdict in one sentence: what was asked, whether it holds, and what decides it."""

from __future__ import annotations

import math

from reports.deciding import deciding
from reports.quantity import pair, reading_unit, text
from sim.wind import Wind
from tracking.feasibility import Slope, Turn
from tracking.loop import COMPLETED
from tracking.metric import Margin
from tracking.outcome import Outcome
from tracking.verdict import TRACKWORTHY

GROUND = "ground"
_KMH = 3.6  # [km/h per m/s]
# Metrics that a turn too tight cannot explain, by the start of their name.
_NOT_BY_TURNS = ("speed_", "range_", "separation_", "path_", "stall_")


def sentence(outcome: Outcome) -> str:
    """The whole verdict in one line, as the terminal, the PDF and the JSON give it."""
    return f"{verdict_words(outcome)}  {setting(outcome)}: {reason(outcome)}"


def verdict_words(outcome: Outcome) -> str:
    """TRACKWORTHY or NOT TRACKWORTHY, and what was expected where that is not to be taken for granted."""
    word = "TRACKWORTHY" if outcome.verdict.trackworthy else "NOT TRACKWORTHY"
    if outcome.verdict.expect == TRACKWORTHY:
        return word
    return f"{word} (as expected)" if outcome.verdict.passed else f"{word} (expected not to be)"


def setting(outcome: Outcome) -> str:
    """Vehicle, controller, speed and wind: "c172x · lqr · 55 m/s · wind 10 m/s from 270°"."""
    parts = [outcome.vehicle, outcome.controller, speed_words(outcome)]
    if outcome.limits.kind != GROUND or outcome.conditions.wind.speed > 0.0:
        parts.append(wind_words(outcome.conditions.wind))
    return " · ".join(parts)


def speed_words(outcome: Outcome) -> str:
    """The commanded speed; for ground vehicles in km/h as well."""
    metric = text(outcome.speed, "m/s")
    return f"{metric} ({text(outcome.speed * _KMH, 'km/h')})" if outcome.limits.kind == GROUND else metric


def wind_words(wind: Wind) -> str:
    """ "wind 10 m/s from 270°" or "no wind"."""
    return f"wind {text(wind.speed, 'm/s')} from {round(wind.from_deg) % 360}°" if wind.speed > 0.0 else "no wind"


def reason(outcome: Outcome) -> str:
    """Why the verdict is what it is: the requirement that decides, where, and what asks too much there."""
    margin = deciding(outcome.verdict)
    if margin is None:
        return "no requirement was stated"
    if margin.met:
        return f"every requirement met; closest: {closest(margin)}"
    others = sum(not other.met for other in outcome.verdict.margins) - 1
    parts = [missed(margin) + place(margin)]
    if why := cause(outcome, margin):
        parts[0] += f": {why}"
    if outcome.track.ended != COMPLETED:
        parts.append(f"the run ended early: {outcome.track.ended}")
    if others:
        parts.append(f"{others} more {'requirement' if others == 1 else 'requirements'} missed")
    return "; ".join(parts)


def closest(margin: Margin) -> str:
    """A met requirement: "cross_track_max 12.3 m of 30 m"."""
    value, limit = pair(margin.metric.value, margin.requirement.limit, reading_unit(margin.metric), met=True)
    at_least = "at least " if margin.requirement.comparison == ">=" else ""
    return f"{margin.metric.name} {value} of {at_least}{limit}"


def missed(margin: Margin) -> str:
    """A missed requirement: "cross_track_max 42.1 m > 30 m"."""
    if math.isnan(margin.value):
        note = f": {margin.metric.note}" if margin.metric.note else ""
        return f"{margin.metric.name} could not be measured{note}"
    value, limit = pair(margin.metric.value, margin.requirement.limit, reading_unit(margin.metric))
    return f"{margin.metric.name} {value} {'>' if margin.requirement.comparison == '<=' else '<'} {limit}"


def place(margin: Margin) -> str:
    """Where it was worst, " at 3.41 km", or nothing for a metric without a place."""
    if math.isfinite(margin.metric.s):
        return f" at {text(margin.metric.s, 'm')}"
    return f" at {text(margin.metric.t, 's')}" if math.isfinite(margin.metric.t) else ""


def cause(outcome: Outcome, margin: Margin) -> str:
    """What in the plan asks too much of the vehicle at the place of `margin`, or "" where nothing does."""
    name, s = margin.metric.name, margin.metric.s
    if name.startswith("altitude_"):
        leg = _slope_at(outcome.feasibility.steep, s)
        return _slope_words(leg) if leg else ""
    tight = outcome.feasibility.tight
    if not tight or name.startswith(_NOT_BY_TURNS):
        return ""
    # A vehicle thrown out of a turn is at its worst within about a turn's diameter of it.
    near = [turn for turn in tight if abs(turn.s - s) <= 2.0 * turn.required + outcome.corridor]
    if near:
        return "the turn there " + _turn_words(min(near, key=lambda turn: abs(turn.s - s)))
    worst = min(tight, key=lambda turn: turn.margin)
    turns = "a turn is" if len(tight) == 1 else f"{len(tight)} turns are"
    which = "it" if len(tight) == 1 else "the worst"
    return f"{turns} too tight; {which}, at {text(worst.s, 'm')}, {_turn_words(worst)}"


def _turn_words(turn: Turn) -> str:
    if math.isinf(turn.required):
        return "cannot be flown in this wind at any radius"
    needed, offered = pair(turn.required, turn.available, "m")
    return f"needs a {needed} radius and offers {offered}"


def _slope_at(steep: tuple[Slope, ...], s: float) -> Slope | None:
    """The steep leg at `s`, else the last one before it: height that was not gained is missed until it is."""
    before = [leg for leg in steep if leg.s <= s]
    return max(before, key=lambda leg: leg.s, default=steep[0] if steep else None)


def _slope_words(leg: Slope) -> str:
    kind = "climbs" if leg.gradient > 0.0 else "descends"
    asked, limit = pair(abs(leg.gradient), abs(leg.limit), "share")
    return f"the leg from {text(leg.s, 'm')} {kind} {asked} and the vehicle can do {limit}"
