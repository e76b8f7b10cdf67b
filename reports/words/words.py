"""The verdict in one sentence: what was asked, whether it holds, and what decides it."""

from __future__ import annotations

import math

from reports.words.fleet_words import GROUND, called, departure_words, ended_words, remedy_words, vehicle_words
from reports.words.names import spoken
from reports.words.quantity import pair, text, with_article
from sim.planet import ALL_PLANETS, EARTH
from sim.vehicle import GROUND as ON_GROUND
from sim.vehicle import NOT_A_NUMBER, STALL
from sim.wind import Wind
from tracking.feasibility import Slope, Stretch
from tracking.metric import Margin
from tracking.outcome import Outcome
from tracking.verdict import EITHER, NOT_TRACKWORTHY

FAULTS = (STALL, ON_GROUND, NOT_A_NUMBER)
KMH = 3.6  # [km/h per m/s]
# Metrics that a leg too steep explains.
BY_SLOPES = ("altitude_", "load_factor_", "stall_")
_NEAR = 0.25  # of the radius that a turn needs, within which something happens "there"
# Metrics that a turn too tight cannot explain, by the start of their name.
_NOT_BY_TURNS = ("speed_", "range_", "separation_", "departure_", "path_", "stall_")
_THERE, _BEFORE, _AFTER, _SOMEWHERE = "there", "before it", "after it", ""  # a turn, from where something was worst


def sentence(outcome: Outcome) -> str:
    """The whole verdict in one line, as the terminal, the PDF and the JSON give it."""
    return f"{verdict_words(outcome)}  {setting(outcome)}: {reason(outcome)}"


def verdict_words(outcome: Outcome) -> str:
    """TRACKWORTHY or NOT TRACKWORTHY, and what was expected where that is not to be taken for granted."""
    word = "TRACKWORTHY" if outcome.verdict.trackworthy else "NOT TRACKWORTHY"
    if outcome.verdict.expect == EITHER:
        return f"{word} (to be compared)"
    if outcome.verdict.expect != NOT_TRACKWORTHY:
        return word
    return f"{word} (as expected)" if outcome.verdict.passed else f"{word} (expected not to be)"


def setting(outcome: Outcome) -> str:
    """Vehicle, controller, speed and wind: "c172x · lqr · 55 m/s · wind 10 m/s from 270°"."""
    return " · ".join([vehicle_words(outcome), outcome.controller, *conditions(outcome)])


def conditions(outcome: Outcome) -> tuple[str, ...]:
    """Speed, wind where it matters, and the departures of a fleet that does not leave together: "55 m/s", "no wind"."""
    wind, late = outcome.conditions.wind, departure_words(outcome.fleet)
    blown = outcome.limits.kind != GROUND or wind.speed > 0.0
    return (speed_words(outcome), *([wind_words(wind)] if blown else []), *([late] if late else []))


def planet_words(outcome: Outcome) -> list[str]:
    """ "on Mars", known by its gravity, or nothing for the Earth."""
    found = [planet for planet in ALL_PLANETS if math.isclose(planet.gravity, outcome.limits.gravity, rel_tol=0.01)]
    return [f"on {planet.name.capitalize()}" for planet in found if planet != EARTH]


def speed_words(outcome: Outcome) -> str:
    """The commanded speed."""
    return speed_text(outcome.speed, outcome.limits.kind)


def speed_text(speed: float, kind: str) -> str:
    """A speed of a vehicle of that `kind`; for ground vehicles in km/h as well: "12.5 m/s (45 km/h)"."""
    metric = text(speed, "m/s")
    return f"{metric} ({text(speed * KMH, 'km/h')})" if kind == GROUND else metric


def wind_words(wind: Wind) -> str:
    """ "wind 10 m/s from 270°" or "no wind"."""
    return f"wind {text(wind.speed, 'm/s')} from {round(wind.from_deg) % 360}°" if wind.speed > 0.0 else "no wind"


def reason(outcome: Outcome) -> str:
    """Why the verdict is what it is: the requirement that decides, where, and what asks too much there."""
    margin = outcome.verdict.decisive
    if margin is None:
        return "no requirement was stated"
    kind = outcome.limits.kind
    if margin.met:
        whose = called(margin.metric.who, kind)
        return f"every requirement met; closest: {closest(margin)}{f', {whose}' if whose else ''}"
    others = sum(not other.met for other in outcome.verdict.margins) - 1
    parts = [missed(margin) + place(margin, kind)]
    if outcome.track.ended in FAULTS:  # all that it then missed follows from it
        parts = [*ended_words(outcome), *parts]
    else:
        if why := cause(outcome, margin):
            parts[0] += f": {why}"
        parts += ended_words(outcome)
    if remedy := remedy_words(outcome, said=margin.metric.name == "separation_min"):
        parts.append(remedy)
    if others:
        parts.append(f"{others} more {'requirement' if others == 1 else 'requirements'} missed")
    return "; ".join(parts)


def closest(margin: Margin) -> str:
    """A met requirement: "cross-track error 12.3 m of 30 m"."""
    value, limit = pair(margin.metric.value, margin.requirement.limit, margin.metric.unit, met=True)
    at_least = "at least " if margin.requirement.comparison == ">=" else ""
    return f"{spoken(margin.metric.name)} {value} of {at_least}{limit}"


def missed(margin: Margin) -> str:
    """A missed requirement: "cross-track error 42.1 m > 30 m"."""
    if math.isnan(margin.value):
        note = f": {margin.metric.note}" if margin.metric.note else ""
        return f"{spoken(margin.metric.name)} could not be measured{note}"
    value, limit = pair(margin.metric.value, margin.requirement.limit, margin.metric.unit)
    return f"{spoken(margin.metric.name)} {value} {'>' if margin.requirement.comparison == '<=' else '<'} {limit}"


def place(margin: Margin, kind: str) -> str:
    """Where it was worst, " at 3.41 km", or nothing for a metric without a place.

    Of a fleet of vehicles of that `kind` also whose: " at 3.41 km of aircraft 2", ", aircraft 1 and 3 at 210 s".
    """
    metric, whose = margin.metric, called(margin.metric.who, kind)
    if math.isfinite(metric.s):
        return f" at {text(metric.s, 'm')}{f' of {whose}' if whose else ''}"
    when = f" at {text(metric.t, 's')}" if math.isfinite(metric.t) else ""
    return f", {whose}{when}" if whose else when


def cause(outcome: Outcome, margin: Margin) -> str:
    """What in the plan asks too much of the vehicle at the place of `margin`, or "" where nothing does."""
    name, s = margin.metric.name, margin.metric.s
    if name.startswith(BY_SLOPES):
        leg = slope_at(outcome.feasibility.steep, s)
        return _slope_words(leg) if leg else ""
    found = too_tight(outcome, margin)
    if found is None:
        return ""
    stretch, where, count = found
    if where == _SOMEWHERE and count > 1:
        return f"{count} turns are too tight; the worst, {_along(stretch)}, {_needs(stretch)}"
    if where == _SOMEWHERE:
        return f"the turn {_along(stretch)} {_needs(stretch)}"
    along = "" if where == _THERE and stretch.s_end == stretch.s else f", {_along(stretch)},"
    return f"the turn {where}{along} {_needs(stretch)}"


def too_tight(outcome: Outcome, margin: Margin) -> tuple[Stretch, str, int] | None:
    """The turn too tight that explains `margin`; None where nothing does.

    With it "there", "before it" or "after it", or "" for one far from where it was worst; and how many there are.
    """
    stretches, s = outcome.feasibility.stretches, margin.metric.s
    if not stretches or margin.metric.name.startswith(_NOT_BY_TURNS):
        return None
    near = [stretch for stretch in stretches if _off(stretch, s) <= _reach(outcome, stretch)]
    if not near:
        return min(stretches, key=lambda stretch: stretch.worst.margin), _SOMEWHERE, len(stretches)
    chosen = min(near, key=lambda stretch: (_off(stretch, s), stretch.worst.margin))
    if _off(chosen, s) <= max(outcome.corridor, _NEAR * chosen.worst.required):
        return chosen, _THERE, len(stretches)
    return chosen, _AFTER if chosen.s > s else _BEFORE, len(stretches)


def _off(stretch: Stretch, s: float) -> float:
    """How far `s` is before or past `stretch` [m]; NaN for a metric without a place."""
    return s if math.isnan(s) else max(stretch.s - s, s - stretch.s_end, 0.0)


def _reach(outcome: Outcome, stretch: Stretch) -> float:
    """A vehicle thrown out of a turn is at its worst within about a turn's diameter of it [m]."""
    return 2.0 * stretch.worst.required + outcome.corridor


def _along(stretch: Stretch) -> str:
    if stretch.s == stretch.s_end:
        return f"at {text(stretch.s, 'm')}"
    start, end = pair(stretch.s, stretch.s_end, "m")
    return f"from {start} to {end}"


def _needs(stretch: Stretch) -> str:
    if math.isinf(stretch.worst.required):
        return "cannot be flown in this wind at any radius"
    needed, offered = pair(stretch.worst.required, stretch.worst.available, "m")
    return f"needs {with_article(needed)} radius and offers {offered}"


def slope_at(steep: tuple[Slope, ...], s: float) -> Slope | None:
    """The steep leg at `s`, else the last one before it: height that was not gained is missed until it is."""
    before = [leg for leg in steep if leg.s <= s]
    return max(before, key=lambda leg: leg.s, default=steep[0] if steep else None)


def _slope_words(leg: Slope) -> str:
    kind = "climbs" if leg.gradient > 0.0 else "descends"
    asked, limit = pair(abs(leg.gradient), abs(leg.limit), "share")
    return f"the leg from {text(leg.s, 'm')} {kind} {asked} and the vehicle can do {limit}"
