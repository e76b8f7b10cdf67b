"""All there is to know about one run: what was asked, what happened, and what it is judged to be."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from planners.map import Map
from planners.path import Path
from sim.vehicle import Conditions, Limits
from tracking.feasibility import Feasibility
from tracking.metric import Metric
from tracking.separation import Separation
from tracking.track import Track
from tracking.verdict import Verdict


@dataclass(frozen=True, slots=True)
class Outcome:
    """One case, run once: the question (path, vehicle, ...), the answer (track, metrics), and the verdict on it.

    `speed` [m/s] is the commanded airspeed (aircraft) or ground speed; `corridor` [m] the half-width; `obstacles` the
    map it was run on, or None; `notes` what the user should know besides (skipped items, cut corners).

    That of a `fleet` is the outcome of the vehicle that decides, with the metrics and the verdict of all.
    """

    name: str
    path: Path
    obstacles: Map | None
    vehicle: str
    limits: Limits
    controller: str
    speed: float
    corridor: float
    conditions: Conditions
    seed: int
    track: Track
    metrics: Mapping[str, Metric]
    feasibility: Feasibility
    verdict: Verdict
    notes: tuple[str, ...] = ()
    fleet: Fleet | None = None


@dataclass(frozen=True, slots=True)
class Fleet:
    """Vehicles under way at the same time: the outcome of each, its departure [s], and how far `apart` they were.

    `member` is the number, from 0, of the one that decides. `required` [m] is the separation they should keep, 0 for
    none; `remedy` departures [s] that would keep it, empty where these do.
    """

    members: tuple[Outcome, ...]
    departures: tuple[float, ...]
    apart: Separation
    member: int
    required: float
    remedy: tuple[float, ...] = ()
