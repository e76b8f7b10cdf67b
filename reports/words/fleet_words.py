"""A fleet in words: which of its vehicles is meant, when they leave, and what would keep them apart."""

from __future__ import annotations

from collections.abc import Sequence

from reports.words.quantity import number, text
from tracking.loop import COMPLETED
from tracking.outcome import Fleet, Outcome

GROUND = "ground"


def called(who: str, kind: str) -> str:
    """A metric's `who` with what vehicles of that `kind` are called: "aircraft 1 and 3", "vehicle 2"; "" for none."""
    if not who:
        return ""
    noun = ("vehicles" if " " in who else "vehicle") if kind == GROUND else "aircraft"
    return f"{noun} {who}"


def member_name(outcome: Outcome) -> str:
    """The member that decides: "aircraft 2 of 3"; "" for a vehicle that is alone."""
    fleet = outcome.fleet
    return f"{called(str(fleet.member + 1), outcome.limits.kind)} of {len(fleet.members)}" if fleet else ""


def vehicle_words(outcome: Outcome) -> str:
    """The vehicle's name: "ares", or "fleet of 3 ares"."""
    return f"fleet of {len(outcome.fleet.members)} {outcome.vehicle}" if outcome.fleet else outcome.vehicle


def departure_words(fleet: Fleet | None) -> str:
    """ "departures at 0, 38 and 0 s", or "" where all leave together."""
    return f"departures at {listed_seconds(fleet.departures)}" if fleet and any(fleet.departures) else ""


def ended_words(outcome: Outcome) -> list[str]:
    """Which runs ended early, why and where: "the run ended early: stall at 1.7 km", "aircraft 3 ended early ..."."""
    fleet, kind = outcome.fleet, outcome.limits.kind
    runs = {called(str(i), kind): one.track for i, one in enumerate(fleet.members, start=1)} if fleet else {}
    return [
        f"{who} ended early: {track.ended} at {text(float(track['s'][-1]), 'm')}"
        for who, track in (runs or {"the run": outcome.track}).items()
        if track.ended != COMPLETED
    ]


def remedy_words(outcome: Outcome, said: bool) -> str:
    """Who comes too close, unless it is `said` already, and which departures would keep them apart; "" where none do.

    "aircraft 1 and 2 come within 312 m at 210 s; leaving 0, 38 and 0 s later they would keep 1 km".
    """
    fleet = outcome.fleet
    if fleet is None or not fleet.remedy:
        return ""
    nearest = outcome.metrics["separation_min"]
    close = f"{called(nearest.who, outcome.limits.kind)} come within {text(nearest.value, 'm')}"
    leaving = f"leaving {listed_seconds(fleet.remedy)} later they would keep {text(fleet.required, 'm')}"
    return leaving if said else f"{close} at {text(nearest.t, 's')}; {leaving}"


def listed_seconds(times: Sequence[float]) -> str:
    """ "0, 38 and 0 s"."""
    *first, last = (number(time, 4) for time in times)
    return f"{', '.join(first)} and {last} s"
