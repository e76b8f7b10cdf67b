"""What a case is, setting by setting, so that cases can be held side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec

from campaigns.case import Case
from campaigns.conditions import known_wind
from planners.scenario import stem_of
from planners.units import parse_speed

Settings = dict[str, Any]

_UNSAID = ("name", "trials", "pass_share", "expect")  # how often it is tried and what is hoped for is not what it is
# The keys of all that one may compare, with what each brings along
DIMENSIONS = {
    "controller": ("controller",),
    "planner": ("path", "others", "planner", "set", "plan_seed", "replan"),
    "vehicle": ("vehicle", "speed", "altitude", "corridor", "steering_hz", "separation"),
    "speed": ("speed",),
    "conditions": ("conditions",),
}


def settings(case: Case) -> Settings:
    """Every key of a case with its value, those of tables as "set.clearance"; files by name, for they are copies."""
    stated = msgspec.to_builtins(case)
    stated["path"] = Path(case.path).name
    stated["others"] = [Path(other).name for other in case.others]
    stated["scenario"] = stem_of(case.scenario or "")
    stated["vehicle"] = Path(case.vehicle).stem
    if (wind := known_wind(case.conditions)) is not None:  # however it is written
        stated["conditions"]["wind"] = {"speed": wind.speed, "from": round(wind.from_deg, 6) if wind.speed else 0.0}
    if case.speed is not None:
        stated["speed"] = parse_speed(case.speed)
    return dict(_flat({key: value for key, value in stated.items() if key not in _UNSAID}))


def without(stated: Settings, dimension: str) -> Settings:
    """All but what belongs to `dimension`."""
    return {key: value for key, value in stated.items() if key.partition(".")[0] not in DIMENSIONS[dimension]}


def key_of(stated: Settings) -> str:
    """The same text for the same settings."""
    return msgspec.json.encode(stated, order="deterministic").decode()


def _flat(table: dict[str, Any], above: str = "") -> list[tuple[str, Any]]:
    found: list[tuple[str, Any]] = []
    for key, value in table.items():
        if isinstance(value, dict):
            found += _flat(value, f"{above}{key}.")
        else:
            found.append((f"{above}{key}", value))
    return found
