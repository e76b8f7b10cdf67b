"""The gate: are these results as good as the baseline?"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from campaigns.baseline import Baseline, Record
from campaigns.campaign import replay_command
from campaigns.comparison import Comparison, compare, flipped
from campaigns.limits import DEFAULT_LIMITS
from campaigns.resolved import RESOLVED

FALSE_ALARMS = 0.05  # that one check may raise by chance, shared by all that it compares (Bonferroni)

# Kinds of findings
WORSE, UNMEASURED, VERDICT, VANISHED, APPEARED, ERRORS = (
    "worse", "unmeasured", "verdict", "vanished", "appeared", "errors",
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that is not as in the baseline; `trial` with `seed` shows it most, and `command` repeats it."""

    kind: str
    case: str
    message: str
    comparison: Comparison | None = None
    trial: int | None = None
    seed: int | None = None
    command: str = ""


@dataclass(frozen=True, slots=True)
class Check:
    """All that was compared and found; `improved` names what got better by more than its limit."""

    campaign: str
    comparisons: tuple[Comparison, ...]
    findings: tuple[Finding, ...]
    improved: tuple[Comparison, ...]

    @property
    def machinery_failed(self) -> bool:
        """Whether there are more errors than there were."""
        return any(finding.kind == ERRORS for finding in self.findings)


def check(record: Record, old: Baseline) -> Check:
    """Hold the results in `record` against the baseline `old`.

    A metric regresses when its mean over the trials worsens, in its own direction, by more than its limit, and, with
    several trials, the bootstrap interval of the difference excludes zero: over pairs of the same seed where there are
    such, else over two samples.
    """
    comparisons = tuple(_comparisons(record, old))
    findings = [*_missing(record, old), *_changes(record, old)]
    findings += [_worse(record, comparison) for comparison in comparisons if comparison.regressed]
    improved = tuple(comparison for comparison in comparisons if comparison.improved)
    return Check(record.campaign.name, comparisons, tuple(findings), improved)


def _comparisons(record: Record, old: Baseline) -> Iterator[Comparison]:
    limits = DEFAULT_LIMITS | record.campaign.check
    pairs = [
        (name, metric)
        for name, case in old.cases.items()
        for metric in case.metrics
        if name in record.baseline.cases and metric in record.baseline.cases[name].metrics and metric in limits
    ]
    for name, metric in pairs:
        before, after = old.cases[name], record.baseline.cases[name]
        higher, unit = record.better[metric] == "higher", record.baseline.units[metric]
        chance = FALSE_ALARMS / len(pairs)
        found = compare(name, metric, unit, before, after, higher, limits[metric], chance)
        if found is not None:
            yield found


def _missing(record: Record, old: Baseline) -> Iterator[Finding]:
    new = record.baseline.cases
    for name in old.cases:
        if name not in new:
            yield Finding(VANISHED, name, "the case is in the baseline, and is not run any more")
    for name in new:
        if name not in old.cases:
            yield Finding(APPEARED, name, "the case is not in the baseline")


def _changes(record: Record, old: Baseline) -> Iterator[Finding]:
    """What changed about cases as a whole."""
    for result in record.results:
        name = result.case.name
        if name not in old.cases:
            continue
        before, after = old.cases[name], record.baseline.cases[name]
        if after.errors > before.errors:
            told = f"{after.errors} of {after.trials} trials failed to run, {before.errors} did before"
            yield Finding(ERRORS, name, f"{told}: {result.statistics.first_error}")
        elif after.verdict != before.verdict and flipped(before, after, FALSE_ALARMS / len(record.results)):
            was, now = (f"{one.verdict} ({one.trackworthy} of {one.trials} trials)" for one in (before, after))
            trial, seed = (result.worst.trial, result.worst.seed) if result.worst else (None, None)
            yield Finding(VERDICT, name, f"was {was}, is {now}", None, trial, seed, _command(record, name, trial))
        for metric in before.metrics:
            if metric not in after.metrics and after.seeds:
                yield Finding(UNMEASURED, name, f"{metric} cannot be measured any more")


def _worse(record: Record, one: Comparison) -> Finding:
    command = _command(record, one.case, one.trial)
    return Finding(WORSE, one.case, f"{one.metric} is worse", one, one.trial, one.seed, command)


def _command(record: Record, case: str, trial: int | None) -> str:
    return "" if trial is None else replay_command(str(record.folder / RESOLVED), case, trial)
