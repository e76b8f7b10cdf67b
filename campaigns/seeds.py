"""Seeds and keys: hashes of what decides a trial, the same on every machine and in every order."""

from __future__ import annotations

import hashlib
from pathlib import Path

import msgspec

from campaigns.case import Case
from campaigns.conditions import CALM, ConditionKeys
from planners.scenario import stem_of

PLAN_SEED_BITS = 31
SEED_BITS = 53  # so that every reader of JSON holds it exactly


def digest(*parts: object) -> str:
    """SHA-256 in hex of anything msgspec can encode, keys in order."""
    return hashlib.sha256(msgspec.json.encode(parts, order="deterministic")).hexdigest()


def file_digest(file: Path) -> str:
    """SHA-256 in hex of what is in a file."""
    return hashlib.sha256(file.read_bytes()).hexdigest()


def trial_seed(campaign_seed: int, case: Case, trial: int) -> int:
    """The seed of a case's trial of that number: the same for every planner, vehicle, speed and controller.

    It depends on the campaign's seed, the scenario, the conditions and the number, so that the same weather meets all
    that is compared.
    """
    return _seed("trial", campaign_seed, _scenario(case), _stated(case.conditions), trial)


def plan_seed(campaign_seed: int, case: Case, trial: int | None = None) -> int:
    """The seed of a case's planner, which every language's int holds; that of a trial where each has its own plan.

    It is the same for every planner, vehicle, controller and condition.
    """
    own = () if trial is None else (trial,)
    return _seed("plan", campaign_seed, _scenario(case), case.plan_seed, *own) >> (SEED_BITS - PLAN_SEED_BITS)


def _scenario(case: Case) -> str:
    """By name, not by content or place: a scenario that is corrected or moved keeps its weather."""
    return stem_of(case.scenario or "")


def _stated(conditions: ConditionKeys) -> dict[str, object]:
    """What is not as by default, so that a kind of condition that is yet to come leaves all seeds as they are."""
    values = ((name, getattr(conditions, name), getattr(CALM, name)) for name in conditions.__struct_fields__)
    return {name: value for name, value, default in values if value != default}


def _seed(*parts: object) -> int:
    return int(digest(*parts), 16) >> (256 - SEED_BITS)
