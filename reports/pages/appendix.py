"""The appendix as data: all that it takes to get the same results again, and what they were held against."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from campaigns.manifest import Manifest
from campaigns.summary import CaseResult
from reports.files.json_result import Json
from reports.words.condition_words import condition_words
from reports.words.metric_definitions import METRIC_DEFINITIONS
from reports.words.names import listed
from reports.words.quantity import counted, text_with_g
from tracking.metric import Requirement
from tracking.outcome import Outcome

_HASH, _MOST_NAMES = 12, 4
_UNITS = {"rad": "°", "rad/s": "°/s", "share": "%", "m/s^2": "m/s²", "1": ""}


def appendix_data(
    results: Sequence[CaseResult], outcomes: Mapping[str, Outcome], manifest: Manifest | None
) -> dict[str, Json]:
    """The tables of the appendix; without a `manifest` nothing is known of what made the results."""
    return {
        "made": _made(manifest) if manifest else [],
        "seeds": [_seeds(result, manifest) for result in results],
        "requirements": _requirements(results, outcomes),
        "metrics": _metrics(results),
        "conditions": _conditions(results),
    }


def _made(manifest: Manifest) -> list[Json]:
    """What made the results: a word and its value a row."""
    versions = dict(manifest.versions)
    changed = " with changes" if manifest.git_revision.endswith("+") else ""
    revision = manifest.git_revision.rstrip("+")
    schema = f"{manifest.schema_version} of the metrics, {manifest.store_version} of the results folder"
    rows = [
        ("campaign", manifest.name),
        ("command", manifest.command),
        ("seed of the campaign", f"{manifest.seed}"),
        ("trackworthy", versions.pop("trackworthy", "")),
        ("git revision", f"{revision}{changed}" if revision else "none: it was not run from a checkout"),
        ("Python", versions.pop("python", "")),
        ("platform", manifest.platform),
        ("libraries", ", ".join(f"{name} {version}" for name, version in versions.items())),
        ("schema", schema),
        ("hash of cases and files", manifest.campaign),
        ("hash of the code", manifest.code),
    ]
    return [[word, value] for word, value in rows if value]


def _seeds(result: CaseResult, manifest: Manifest | None) -> dict[str, Json]:
    """A case with the seeds that its trials were run with."""
    case, found = result.case, result.statistics
    first, last = (f"{found.seeds[i]}" if found.seeds else "" for i in (0, -1))
    return {
        "case": case.name,
        "trials": f"{case.trials}",
        "plan": "one a trial" if case.replan else f"{case.plan_seed}" if case.planner else "",
        "seeds": first if len(found.seeds) < 2 else f"{first} … {last}",
        "worst": "" if result.worst is None or case.trials == 1 else f"{result.worst.trial}: {result.worst.seed}",
        "hash": (manifest.cases.get(case.name, "") if manifest else "")[:_HASH],
    }


def _requirements(results: Sequence[CaseResult], outcomes: Mapping[str, Outcome]) -> list[Json]:
    """Every requirement once, those of one source that hold for the same cases together."""
    cases: dict[Requirement, list[str]] = {}
    units: dict[str, str] = {}
    for result in results:
        outcome = outcomes.get(result.case.name)
        for margin in outcome.verdict.margins if outcome else ():
            cases.setdefault(margin.requirement, []).append(result.case.name)
            units[margin.requirement.metric] = margin.metric.unit
    told = [result for result in results if result.case.name in outcomes]
    order = sorted(cases, key=lambda one: (list(METRIC_DEFINITIONS).index(one.metric), -len(cases[one]), one.limit))
    groups: dict[tuple[str, str], list[Json]] = {}
    for one in order:
        comparison = "≤" if one.comparison == "<=" else "≥"
        limit = f"{comparison} {text_with_g(one.limit, units[one.metric])}"
        row: Json = {"name": one.metric, "words": listed(one.metric), "limit": limit}
        groups.setdefault((one.source, _which(cases[one], told)), []).append(row)
    return [{"limits": limits, "source": source, "cases": which} for (source, which), limits in groups.items()]


def _which(names: Sequence[str], results: Sequence[CaseResult]) -> str:
    """ "all 30 cases", "all with c172x" or the first names."""
    if len(names) == len(results):
        return f"all {counted(len(names), 'case')}" if len(names) > 1 else "the case"
    for vehicle in dict.fromkeys(result.case.vehicle for result in results):
        if {result.case.name for result in results if result.case.vehicle == vehicle} == set(names):
            return f"all {len(names)} with {Path(vehicle).stem}" if len(names) > 1 else names[0]
    return few(names)


def few(names: Sequence[str]) -> str:
    """The first of many names, and how many more there are."""
    more = f" and {len(names) - _MOST_NAMES} more" if len(names) > _MOST_NAMES else ""
    return f"{'; '.join(names[:_MOST_NAMES])}{more}"


def _metrics(results: Sequence[CaseResult]) -> list[Json]:
    """Every metric that occurs, in the order of the definitions."""
    units = {name: unit for result in results for name, unit in result.units.items()}
    met = {name for result in results for name in result.statistics.names}
    better = {"lower": "lower", "higher": "higher", "neither": ""}
    return [
        {
            "name": name,
            "words": listed(name),
            "unit": _UNITS.get(units[name][0], units[name][0]),
            "better": better[units[name][1]],
            "definition": definition,
            "source": source,
        }
        for name, (definition, source) in METRIC_DEFINITIONS.items()
        if name in met
    ]


def _conditions(results: Iterable[CaseResult]) -> list[Json]:
    """What trials meet, and the cases that meet it."""
    groups: dict[str, list[str]] = {}
    everything = list(results)
    for result in everything:
        told = "; ".join(condition_words(result.case.conditions)) or "no wind"
        groups.setdefault(told, []).append(result.case.name)
    return [{"conditions": told, "cases": _which(names, everything)} for told, names in groups.items()]
