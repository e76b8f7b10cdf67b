"""Cases side by side in words: what is compared with what, and how each does against the best."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from campaigns.conditions import known_wind
from campaigns.difference import CHANCE, SAME, SMALL, Difference
from campaigns.settings import key_of, settings, without
from campaigns.summary import CaseResult
from campaigns.versus import TRACKWORTHY_SHARE, Group, Member, unit_of
from planners.units import parse_speed
from reports.words.campaign_words import all_alike
from reports.words.condition_words import condition_words
from reports.words.fleet_words import GROUND
from reports.words.names import listed
from reports.words.quantity import number, span, text
from reports.words.words import speed_text
from sim.vehicles import ALL_TRUCKS

PLURAL = {"controller": "Controllers", "planner": "Planners", "vehicle": "Vehicles"}
REFERENCE = "reference"
_WORDS = {SAME: "the same", CHANCE: "no difference beyond chance", SMALL: "a difference too small to matter"}
_BESIDE = ("speed", "conditions")  # what groups of one family may differ in

Table = dict[str, Any]  # for typst and HTML: str, and lists and dicts of these


@dataclass(frozen=True, slots=True)
class Family:
    """Groups that are shown together, under one `title`: they differ in speed or conditions, as each of `names` says.

    `about` are the settings that all share, in words.
    """

    title: str
    about: str
    groups: tuple[Group, ...]
    names: tuple[str, ...]

    @property
    def scenario(self) -> str:
        """The scenario's name, "" for paths without one."""
        return str(self.groups[0].common["scenario"])


def families(groups: Sequence[Group]) -> list[Family]:
    """The groups as they are shown, in their order."""
    found: dict[tuple[str, str], list[Group]] = {}
    for group in groups:
        stated = group.common
        for dimension in _BESIDE:
            stated = without(stated, dimension)
        found.setdefault((group.dimension, key_of(stated)), []).append(group)
    return _told_apart([_family(one) for one in found.values()])


def _told_apart(found: Sequence[Family]) -> list[Family]:
    """With the settings that tell families apart which would else be called the same."""
    called = [(one.title, one.about) for one in found]
    told = []
    for one, name in zip(found, called, strict=True):
        alike = [other.groups[0].common for other, same in zip(found, called, strict=True) if same == name]
        differ = [key for key in one.groups[0].common if len({repr(common.get(key)) for common in alike}) > 1]
        own = [f"{key} {one.groups[0].common[key]}" for key in differ]
        told.append(replace(one, about=" · ".join([one.about, *own])))
    return told


def versus_table(family: Family) -> Table:
    """A block for each group of the family; every cell is text."""
    return {
        "title": family.title,
        "about": family.about,
        "dimension": family.groups[0].dimension,
        "scenario": family.scenario,
        "note": note(family),
        "blocks": [_block(group, name) for group, name in zip(family.groups, family.names, strict=True)],
    }


def note(family: Family) -> str:
    """What the numbers of a family mean."""
    members = [member for group in family.groups for member in group.members]
    told = [f"Differences are to the best of each group, by their means{_paired(members)}."]
    if any(one.interval for member in members for one in member.differences.values()):
        told += [
            "In brackets: of a value where 90 % of its trials lie, of a difference its 95 % bootstrap interval.",
            "A difference is called better or worse if it is beyond what chance may do in all that is compared here, "
            "and more than a check would allow.",
        ]
    else:
        told += ["One trial each: what chance does is not known."]
    if not all(group.alike for group in family.groups):
        told += ["Not the same is required of all, so their verdicts do not compare."]
    return " ".join(told)


def share_text(result: CaseResult) -> str:
    """ "18 of 20 (68 to 99 %)", with the interval of Clopper and Pearson where trials differ; "yes" or "no" of one."""
    found = result.statistics
    if found.tried == 1:
        return "yes" if found.trackworthy else "no"
    if all_alike(result):
        return f"{found.trackworthy} of {found.tried}, all alike"
    low, high = found.interval
    return f"{found.trackworthy} of {found.tried} ({number(100 * low, 2)} to {number(100 * high, 3)} %)"


def change_text(one: Difference) -> str:
    """ "+0.0134 m (0.011 to 0.016 m)", without an interval where nothing is random; of shares in percentage points."""
    points = one.unit == "share"
    told = _signed(one.change, one.unit).replace(" %", " points") if points else _signed(one.change, one.unit)
    if one.interval is None or one.interval[0] == one.interval[1]:
        return told
    ends = _span(*one.interval, one.unit)
    return f"{told} ({ends.removesuffix(' %') if points else ends})"


def outcome_words(one: Difference) -> str:
    """ "better", "no difference beyond chance"."""
    return _WORDS.get(one.outcome, one.outcome)


def vehicle_speed(speed: str | float | None, vehicle: str) -> str:
    """A speed as a case states it: "12.5 m/s (45 km/h)" for a truck; "" where it is the vehicle's own."""
    kind = GROUND if Path(vehicle).stem in ALL_TRUCKS else ""
    return "" if speed is None else speed_text(parse_speed(speed), kind)


def _family(groups: Sequence[Group]) -> Family:
    first = groups[0].members[0].result.case
    stated = settings(first)
    where = stated["scenario"] or Path(stated["path"]).stem
    fixed = {
        "planner": str(stated.get("planner") or stated["path"] or "a planner of others"),
        "vehicle": str(stated["vehicle"]),
        "controller": str(stated["controller"]),
    }
    told = [value for key, value in fixed.items() if key != groups[0].dimension]
    told += [] if first.unit is None else [f"{text(first.unit, 'm')} a map unit"]
    parts = [_parts(group) for group in groups]
    shared = [part for part in parts[0] if all(part in one for one in parts)]
    names = [", ".join(part for part in one if part not in shared) for one in parts]
    title = f"{PLURAL[groups[0].dimension]} on {where}"
    return Family(title, " · ".join(one for one in [*told, *shared] if one), tuple(groups), tuple(names))


def _parts(group: Group) -> list[str]:
    """Speed and conditions."""
    case = group.members[0].result.case
    speed = [] if group.dimension == "vehicle" else [vehicle_speed(case.speed, case.vehicle)]
    wind = known_wind(case.conditions)
    calm = ["no wind"] if wind is not None and wind.speed == 0.0 else []
    told = [one for one in condition_words(case.conditions) if one not in calm]
    return [one for one in (*speed, *calm, *told) if one]


def _block(group: Group, name: str) -> Table:
    return {
        "name": name,
        "metrics": [listed(metric) for metric in group.metrics],
        "rows": [_row(group, member, i == group.reference) for i, member in enumerate(group.members)],
    }


def _row(group: Group, member: Member, reference: bool) -> Table:
    return {
        "name": member.label,
        "case": member.result.case.name,
        "reference": REFERENCE if reference else "",
        "share": share_text(member.result),
        "cells": [_cell(member, metric) for metric in group.metrics],
    }


def _cell(member: Member, metric: str) -> dict[str, str]:
    told = {"value": "n/a", "spread": "", "change": "", "outcome": ""}
    unit = unit_of(member.result, metric)[0]
    if metric == TRACKWORTHY_SHARE:
        told["value"] = text(member.result.statistics.share, unit)
    elif spread := member.spreads.get(metric):
        told["value"] = text(spread.median, unit)
        if spread.count > 1:
            told["spread"] = _span(spread.p5, spread.p95, unit)
    if one := member.differences.get(metric):
        told |= {"change": change_text(one), "outcome": outcome_words(one)}
    return told


def _paired(members: Sequence[Member]) -> str:
    found = {one.pairs > 0 for member in members for one in member.differences.values()}
    return ", over trials of the same seed" if found == {True} else ""


def _signed(value: float, unit: str) -> str:
    told = text(value, unit)
    return told if value <= 0.0 else f"+{told}"


def _span(low: float, high: float, unit: str) -> str:
    return span(low, high, unit).replace(" – ", " to ")
