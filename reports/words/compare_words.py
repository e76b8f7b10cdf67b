"""Two campaigns side by side in words: the same in the terminal and in Markdown."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from campaigns.difference import BETTER, CHANCE, CONFIDENCE, MIXED, SAME, SMALL, UNLIKE, WORSE, Difference
from campaigns.side_by_side import CasePair, Change, SideBySide, changes_of
from planners.units import degrees
from reports.words.quantity import counted, number
from reports.words.versus_words import outcome_words, share_text

_DIGITS, _FINE = 4, 3  # significant, of values and of differences
_MOST_NAMES = 8  # in a line
_UNITS = {"speed": " m/s", "altitude": " m", "corridor": " m", "separation": " m"}  # of settings


# Metric, A, B, B - A, the interval of that, their unit, and what it comes to; angles in degrees, shares in per cent
Row = tuple[str, str, str, str, str, str, str]


def conclusion(found: SideBySide) -> str:
    """ "B: 3 better, 1 worse, 12 the same; 2 verdicts changed; 1 case only in A"."""
    if not found.pairs:
        return "nothing to compare: no case of B belongs to one of A"
    told = [(found.count(BETTER), BETTER), (found.count(WORSE), WORSE), (found.count(MIXED), MIXED)]
    said = ", ".join(f"{count} {outcome}" for count, outcome in told if count or outcome != MIXED)
    verdicts = counted(found.verdicts_changed, "verdict")
    parts = [f"B: {said}, {found.count(SAME)} the same", f"{verdicts} changed"]
    parts += [
        f"{counted(len(names), 'case')} only in {side}"
        for side, names in (("A", found.only_a), ("B", found.only_b))
        if names
    ]
    return "; ".join(parts)


def heads(found: SideBySide) -> list[str]:
    """What A and B are, and what made them differ."""
    lines = [
        f"{letter}  {side.folder}: campaign {side.campaign.name}, seed {side.campaign.seed}, "
        f"{counted(len(side.results), 'case')}, {counted(side.campaign.trials, 'trial')}"
        for letter, side in (("A", found.a), ("B", found.b))
    ]
    if made := [change_words(change) for change in found.made]:
        lines.append(f"run: {'; '.join(made)}")
    total = len(found.pairs)
    for change, count in changes_of(found.pairs):
        where = "every case" if count == total else f"{count} of {counted(total, 'case')}"
        lines.append(f"set in {where}: {change_words(change)}")
    for side, only in (("A", found.only_a), ("B", found.only_b)):
        if only:
            lines.append(f"only in {side}: {names(only)}")
    return lines


def footnote(found: SideBySide) -> str:
    """What the numbers mean."""
    every = [one for pair in found.pairs for one in pair.differences]
    if not every:
        return ""
    told = ["Means over the trials."]
    several = [one for one in every if one.interval is not None]
    if several:
        told += [
            f"Intervals are of {100 * CONFIDENCE:.0f} %; better and worse are beyond chance among all "
            f"{len(every)} differences together, and more than a check would allow."
        ]
        if all(one.pairs for one in several):
            told += ["Trials are paired by seed."]
        else:
            told += ["Where no seed is in both, they are two samples."]
    if len(several) < len(every):
        told += ["Of one trial, what chance does is not known."]
    return " ".join(told)


def case_lines(pair: CasePair, found: SideBySide) -> list[str]:
    """How many of a pair's trials are trackworthy, and what is set otherwise, unless it is so in all."""
    was, now = share_text(pair.a), share_text(pair.b)
    told = [f"trackworthy: {was}" if was == now else f"trackworthy: {was} → {now}"]
    if pair.verdict_changed:
        told.append(f"verdict: {pair.a.verdict} → {pair.b.verdict}")
    told += [
        f"trials of {letter} that failed to run: {one.statistics.errors}"
        for letter, one in (("A", pair.a), ("B", pair.b))
        if one.statistics.errors
    ]
    common = {change_words(change) for change, count in changes_of(found.pairs) if count == len(found.pairs)}
    own = [words for change in pair.changes if (words := change_words(change)) not in common]
    return told + ([f"set: {'; '.join(own)}"] if own else [])


def rest_words(pair: CasePair) -> str:
    """The metrics that do not differ so that it counts: "completion: the same"."""
    told = []
    for outcome in (CHANCE, SMALL, SAME):
        alike = [one for one in pair.differences if one.outcome == outcome]
        if alike:
            told.append(f"{', '.join(one.metric for one in alike)}: {outcome_words(alike[0])}")
    return "; ".join(told)


def telling(found: SideBySide) -> tuple[list[CasePair], list[CasePair]]:
    """The pairs that differ in a verdict or a metric, and those that do not."""
    differ = [
        pair for pair in found.pairs if pair.verdict_changed or any(one.outcome in UNLIKE for one in pair.differences)
    ]
    return differ, [pair for pair in found.pairs if pair not in differ]


def rows(pair: CasePair) -> Iterator[Row]:
    """The differences that count."""
    for one in pair.differences:
        if one.outcome in UNLIKE:
            yield _row(one)


def _row(one: Difference) -> Row:
    factor, unit = _shown_unit(one.unit)
    old, new = (number(factor * value, _DIGITS) for value in (one.before, one.after))
    change = number(factor * one.change, _FINE)
    random = one.interval is not None and one.interval[0] < one.interval[1]
    ends = " … ".join(number(factor * end, _FINE) for end in one.interval or ()) if random else ""
    sign = "+" if one.change > 0.0 else ""
    return one.metric, old, new, f"{sign}{change}", ends, unit, one.outcome


def _shown_unit(unit: str) -> tuple[float, str]:
    """What values in the SI `unit` are multiplied by, and the unit that they then have."""
    if unit == "share":
        return 100.0, "%"
    factor, name = degrees(1.0, unit)
    return factor, "" if name == "1" else name.replace("deg", "°").replace("^2", "²")


def change_words(change: Change) -> str:
    """ "controller lqr → stanley"."""
    unit = _UNITS.get(change.key, "")
    old, new = (f"{_value(value)}{unit if isinstance(value, float) else ''}" for value in (change.old, change.new))
    return f"{change.key} {old} → {new}"


def names(cases: tuple[str, ...]) -> str:
    """A few names, and how many more there are."""
    more = f" and {len(cases) - _MOST_NAMES} more" if len(cases) > _MOST_NAMES else ""
    return "; ".join(cases[:_MOST_NAMES]) + more


def _value(value: Any) -> str:
    if value is None or value in ("", []):
        return "none"
    if isinstance(value, float):
        return number(value, 6)
    return ", ".join(map(str, value)) if isinstance(value, list | tuple) else str(value)
