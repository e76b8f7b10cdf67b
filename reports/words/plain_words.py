"""A run's verdict in words for those who know neither the metrics' names nor their limits by heart."""

from __future__ import annotations

import math
from collections.abc import Callable

from reports.words.fleet_words import called
from reports.words.names import spoken
from reports.words.quantity import pair, text, text_with_g, with_article
from reports.words.struck import EDGE, OBSTACLE, struck
from reports.words.words import BY_SLOPES, FAULTS, slope_at, too_tight
from sim.vehicle import GROUND as ON_GROUND
from sim.vehicle import STALL
from tracking.metric import Margin
from tracking.outcome import Outcome

_FAULT_WORDS = {STALL: "stalls", ON_GROUND: "hits the ground"}


def plain(outcome: Outcome) -> str:
    """What became of the run, and why: "misses the corridor by 12 m at 3.41 km, because the corner there needs ..."."""
    margin = outcome.verdict.decisive
    if margin is None:
        return "has no requirement to meet"
    if margin.met:
        return f"meets every requirement; closest to its limit: {spare(outcome, margin)}"
    if outcome.track.ended in FAULTS:
        fault = _FAULT_WORDS.get(outcome.track.ended, "is lost: its simulation gives no numbers any more")
        return f"{fault} at {text(float(outcome.track['s'][-1]), 'm')}"
    why = because(outcome, margin)
    others = sum(not other.met for other in outcome.verdict.margins) - 1
    more = f"; misses {others} more {'requirement' if others == 1 else 'requirements'}" if others else ""
    return f"{missing(outcome, margin)}{f', because {why}' if why else ''}{more}"


def missing(outcome: Outcome, margin: Margin) -> str:
    """By how much a requirement is missed, and where: "banks to 68° at 3.41 km, 8° beyond the limit of 60°"."""
    name = margin.metric.name
    if math.isnan(margin.value):
        note = f" ({margin.metric.note})" if margin.metric.note else ""
        return f"has no {spoken(name)} that could be measured{note}"
    usual = ">=" if margin.metric.better == "higher" else "<="
    for start, told in _MISSING.items():
        if name.startswith(start) and margin.requirement.comparison == usual:
            return told(outcome, margin)
    return _other(outcome, margin)


def spare(outcome: Outcome, margin: Margin) -> str:
    """A requirement that is met: "bank 32.3° of 60° at 3.41 km", "0.178 m from an obstacle at 340 m"."""
    metric, limit = margin.metric, margin.requirement.limit
    where = _where(outcome, margin)
    if metric.name == "clearance_min" and limit == 0.0:
        return f"{text(metric.value, 'm')} from {struck(outcome, metric)}{where}"
    value, bound = pair(metric.value, limit, metric.unit, met=True)
    if metric.name.startswith("cross_track_max"):
        return f"{value} off the path{where}, {bound} allowed"
    at_least = "at least " if margin.requirement.comparison == ">=" else ""
    return f"{spoken(metric.name)} {value} of {at_least}{bound}{where}"


def because(outcome: Outcome, margin: Margin) -> str:
    """What in the plan asks too much: "the corner there needs a 530 m turn and offers 210 m"; "" for nothing known."""
    if margin.metric.name.startswith(BY_SLOPES):
        leg = slope_at(outcome.feasibility.steep, margin.metric.s)
        if leg is None:
            return ""
        asked, limit = pair(abs(leg.gradient), abs(leg.limit), "share")
        way = "climbs" if leg.gradient > 0.0 else "descends"
        return f"the leg from {text(leg.s, 'm')} {way} {asked}, and the vehicle can do {limit}"
    found = too_tight(outcome, margin)
    if found is None:
        return ""
    stretch, where, count = found
    corner = "corner" if stretch.s == stretch.s_end else "bend"
    if where:
        which = f"the {corner} {where}"
    elif count > 1:
        which = f"{count} turns are too tight; the worst, at {text(stretch.worst.s, 'm')},"
    else:
        which = f"the {corner} at {text(stretch.worst.s, 'm')}"
    if math.isinf(stretch.worst.required):
        return f"{which} cannot be flown in this wind at any radius"
    needed, offered = pair(stretch.worst.required, stretch.worst.available, "m")
    return f"{which} needs {with_article(needed)} turn and offers {offered}"


def _where(outcome: Outcome, margin: Margin) -> str:
    """ " at 3.41 km", of a fleet also whose: " at 3.41 km (aircraft 2)"."""
    metric = margin.metric
    at = f" at {text(metric.s, 'm')}" if math.isfinite(metric.s) else ""
    if not at and math.isfinite(metric.t):
        at = f" after {text(metric.t, 's')}"
    whose = called(metric.who, outcome.limits.kind)
    return f"{at} ({whose})" if whose else at


def _beyond(margin: Margin) -> str:
    return text(-margin.value, margin.metric.unit)


def _limit(margin: Margin) -> str:
    return text_with_g(margin.requirement.limit, margin.metric.unit)


def _cross_track(outcome: Outcome, margin: Margin) -> str:
    metric, limit, where = margin.metric, margin.requirement.limit, _where(outcome, margin)
    if metric.name == "cross_track_max" and limit == outcome.corridor:
        return f"misses the corridor by {_beyond(margin)}{where}"
    if metric.name == "cross_track_max":
        return f"strays {text(metric.value, 'm')} from the path{where}, where {_limit(margin)} is allowed"
    value, bound = pair(metric.value, limit, metric.unit)
    share = metric.name.removeprefix("cross_track_p")
    if share.isdigit():
        return f"keeps within {value} of the path for {int(share)} % of the way, where {bound} is allowed"
    return f"has {with_article(spoken(metric.name))} of {value}, where {bound} is allowed"


def _completion(outcome: Outcome, margin: Margin) -> str:
    share, _ = pair(margin.metric.value, 1.0, "share")
    metric, end = margin.metric, outcome.path.length
    early = f", and ends at {text(metric.s, 'm')} of {text(end, 'm')}" if metric.s < end and not outcome.fleet else ""
    whose = called(metric.who, outcome.limits.kind)
    return f"follows only {share} of the path{early}{f' ({whose})' if whose else ''}"


def _clearance(outcome: Outcome, margin: Margin) -> str:
    value, where = margin.metric.value, _where(outcome, margin)
    what = struck(outcome, margin.metric)
    if value < 0.0:
        hit = {OBSTACLE: "hits an obstacle, up to {} inside", EDGE: "leaves the map by up to {}"}
        return f"{hit.get(what, f'touches {what}, up to {{}} beyond').format(text(-value, 'm'))}{where}"
    kept, wanted = pair(value, margin.requirement.limit, "m")
    return f"passes {kept} from {what}{where}, where {wanted} must be kept"


def _load(verb: str, noun: str) -> Callable[[Outcome, Margin], str]:
    def told(outcome: Outcome, margin: Margin) -> str:
        value = text_with_g(margin.metric.value, margin.metric.unit)
        over = f"{_beyond(margin)} beyond the limit of {_limit(margin)}"
        return f"{verb} {value}{noun}{_where(outcome, margin)}, {over}"

    return told


def _off(noun: str) -> Callable[[Outcome, Margin], str]:
    def told(outcome: Outcome, margin: Margin) -> str:
        value, limit = pair(margin.metric.value, margin.requirement.limit, margin.metric.unit)
        return f"is {value} off its {noun}{_where(outcome, margin)}, where {limit} is allowed"

    return told


def _separation(outcome: Outcome, margin: Margin) -> str:
    metric = margin.metric
    near, wanted = pair(metric.value, margin.requirement.limit, metric.unit)
    when = f" after {text(metric.t, 's')}" if math.isfinite(metric.t) else ""
    who = called(metric.who, outcome.limits.kind) or "two vehicles"
    return f"{who} come within {near} of each other{when}, where {wanted} must be kept"


def _stall(outcome: Outcome, margin: Margin) -> str:
    left, wanted = pair(margin.metric.value, margin.requirement.limit, margin.metric.unit)
    return f"comes within {left} of the stall{_where(outcome, margin)}, where {wanted} must be left"


def _range(outcome: Outcome, margin: Margin) -> str:
    value, limit = pair(margin.metric.value, margin.requirement.limit, margin.metric.unit)
    whose = called(margin.metric.who, outcome.limits.kind)
    return f"uses {value} of its range{f' ({whose})' if whose else ''}, where {limit} is allowed"


def _other(outcome: Outcome, margin: Margin) -> str:
    value, limit = pair(margin.metric.value, margin.requirement.limit, margin.metric.unit)
    asked = "at most" if margin.requirement.comparison == "<=" else "at least"
    what = with_article(spoken(margin.metric.name))
    return f"has {what} of {value}{_where(outcome, margin)}, where {asked} {limit} is asked"


# A metric is told by the first start of its name.
_MISSING: dict[str, Callable[[Outcome, Margin], str]] = {
    "cross_track_": _cross_track,
    "completion": _completion,
    "clearance_min": _clearance,
    "bank_max": _load("banks to", ""),
    "load_factor_max": _load("is loaded with", ""),
    "lateral_acceleration_max": _load("corners with", " of lateral acceleration"),
    "lateral_acceleration_demanded": _load("is steered for", " of lateral acceleration"),
    "lateral_acceleration_needed": _load("has a path that needs", " of lateral acceleration"),
    "altitude_error_": _off("altitude"),
    "speed_error_": _off("speed"),
    "separation_min": _separation,
    "stall_margin_min": _stall,
    "range_used": _range,
}
