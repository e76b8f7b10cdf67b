"""Baselines: what a campaign found when it was good, as a small JSON file that users commit."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path

import msgspec

from campaigns.campaign import Campaign
from campaigns.finished import read_campaign, read_results
from campaigns.limits import DEFAULT_LIMITS
from campaigns.summary import CaseResult
from planners.errors import InputError
from planners.files.text import write_text
from planners.units import degrees
from tracking.metric import SCHEMA_VERSION

BASELINE_VERSION = 1
DIGITS = 6  # significant: far finer than any limit, and easy to read

Values = list[float | None]


class CaseBaseline(msgspec.Struct, frozen=True):
    """A case's verdict, its `trackworthy` trials of `trials`, and each metric's values in the order of `seeds`."""

    verdict: str
    trackworthy: int
    trials: int
    errors: int
    seeds: list[int]
    numbers: list[int]
    metrics: dict[str, Values]


class Baseline(msgspec.Struct, frozen=True):
    """Cases by name; `units` are those of the metrics, angles in degrees."""

    baseline: int
    schema: int
    campaign: str
    units: dict[str, str]
    cases: dict[str, CaseBaseline]


@dataclass(frozen=True, slots=True)
class Record:
    """What lies in a results `folder`, as it would become a baseline."""

    folder: Path
    campaign: Campaign
    results: list[CaseResult]
    baseline: Baseline
    better: dict[str, str]


def read_record(folder: Path) -> Record:
    """The results in `folder`; raises `InputError` where there are none, or not all."""
    _, campaign = read_campaign(folder)
    return record_of(campaign, read_results(campaign, folder), folder)


def record_of(campaign: Campaign, results: list[CaseResult], folder: Path) -> Record:
    """These results of `campaign`, which lie in `folder`."""
    units = next((result.units for result in results), {})
    shown = {name: degrees(1.0, units[name][0])[1] for name in DEFAULT_LIMITS if name in units}
    cases = {result.case.name: _case(result) for result in results}
    baseline = Baseline(BASELINE_VERSION, SCHEMA_VERSION, campaign.name, shown, cases)
    return Record(folder, campaign, results, baseline, {name: better for name, (_, better) in units.items()})


def read_baseline(file: Path) -> Baseline:
    """The baseline in `file`; raises `InputError` for one that is missing, damaged or of another version."""
    update = "make one of good results: trackworthy check DIR --baseline FILE --update"
    try:
        text = file.read_bytes()
    except FileNotFoundError:
        raise InputError(str(file), "there is no such baseline", update) from None
    except OSError as error:
        raise InputError(str(file), f"cannot be read: {error.strerror}", update) from None
    try:
        baseline = msgspec.json.decode(text, type=Baseline)
    except msgspec.DecodeError as error:
        raise InputError(str(file), f"is not a baseline ({error})", update) from None
    if (baseline.baseline, baseline.schema) != (BASELINE_VERSION, SCHEMA_VERSION):
        what = f"is of version {baseline.baseline}, schema {baseline.schema}"
        raise InputError(str(file), f"{what}; this is {BASELINE_VERSION}, {SCHEMA_VERSION}", update)
    for name, case in baseline.cases.items():
        lengths = {len(case.numbers), *map(len, case.metrics.values())}
        if lengths != {len(case.seeds)}:
            raise InputError(f"{file}: {name}", "it has not as many values as seeds", update)
    return baseline


def check_replaceable(file: Path) -> None:
    """Raises `InputError` for a file that is there and is no baseline, of whatever version."""
    if not file.exists():
        return
    try:
        content = json.loads(file.read_bytes())
    except (OSError, ValueError):
        content = None
    if not isinstance(content, dict) or not {"baseline", "cases"} <= content.keys():
        raise InputError(str(file), "is there and is not a baseline", "give the name of one, or of a new file")


def write_baseline(baseline: Baseline, file: Path) -> None:
    """Write `file`, a line a metric, so that a change shows as a few lines of a diff."""
    cases = []
    for name, case in baseline.cases.items():
        head = {"verdict": case.verdict, "trackworthy": case.trackworthy, "trials": case.trials, "errors": case.errors}
        lines = [f'"{key}": {json.dumps(value)}' for key, value in head.items()]
        lines += [f'"seeds": {json.dumps(case.seeds)}', f'"numbers": {json.dumps(case.numbers)}']
        metrics = ",\n".join(f'        "{metric}": {json.dumps(values)}' for metric, values in case.metrics.items())
        lines.append(f'"metrics": {{\n{metrics}\n      }}')
        body = ",\n".join(f"      {line}" for line in lines)
        cases.append(f"    {json.dumps(name)}: {{\n{body}\n    }}")
    head_lines = [
        f'  "baseline": {baseline.baseline}',
        f'  "schema": {baseline.schema}',
        f'  "campaign": {json.dumps(baseline.campaign)}',
        f'  "units": {json.dumps(baseline.units)}',
        '  "cases": {\n' + ",\n".join(cases) + "\n  }",
    ]
    write_text(file, "{\n" + ",\n".join(head_lines) + "\n}\n")


def _case(result: CaseResult) -> CaseBaseline:
    found = result.statistics
    metrics: dict[str, Values] = {}
    for i, name in enumerate(found.names):
        if name in DEFAULT_LIMITS and name in found.metrics:
            factor = degrees(1.0, result.units[name][0])[0]
            metrics[name] = [_rounded(factor * float(value)) for value in found.values[:, i]]
    return CaseBaseline(
        verdict=result.verdict,
        trackworthy=found.trackworthy,
        trials=result.case.trials,
        errors=found.errors,
        seeds=list(found.seeds),
        numbers=list(found.trials),
        metrics=metrics,
    )


def _rounded(value: float) -> float | None:
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
