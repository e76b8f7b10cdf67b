"""The first page as data: what was tested, what came out, the worst cases with why, and how to repeat it."""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from campaigns.search import ScaleSearch, SpeedSearch
from campaigns.searches import SearchResult
from campaigns.summary import ERROR, CaseResult
from reports.files.json_result import Json
from reports.words.deciding import deciding, severity
from reports.words.dimensions import CONDITIONS, CONTROLLER, PATH, SCENARIO, SPEED, VEHICLE, dimensions
from reports.words.names import spoken
from reports.words.plain_words import plain
from reports.words.quantity import counted, number
from reports.words.search_words import search_line
from reports.words.words import planet_words
from tracking.outcome import Outcome
from tracking.verdict import EITHER, TRACKWORTHY

_MOST_UNEXPECTED, _MOST_FAILED, _MOST_NEAR = 5, 5, 3
_MOST_NAMES, _LONGEST_NAME, _LONGEST = 6, 44, 300  # names in a list, and characters of a name and of a sentence
_LEGEND = (
    "Trackworthy: the vehicle stays in its corridor to the end of the path, clear of all obstacles and within its own "
    "limits. As expected: what the campaign says must come out, which may be that a path cannot be followed."
)


def front_data(
    results: Sequence[CaseResult],
    outcomes: Mapping[str, Outcome],
    searches: Sequence[SearchResult] = (),
    campaign: str = "",
    command: str = "",
) -> dict[str, Json]:
    """The page of a campaign that was given as `campaign` on the command line, "" for one that is not known; `command`
    is all of that line.
    """
    one = ["trackworthy", "run", campaign, "--case", "NAME", "--trial", "N"]
    return {
        "headline": {**headline(results, searches)},
        "counts": counts_words(results, searches),
        "good": all(result.passed for result in results) and all(one.passed is not False for one in searches),
        "tested": _tested(results, outcomes, searches),
        "worst": _groups(results, outcomes, searches),
        "repeat": command,
        "repeat_one": shlex.join(one) if campaign and results else "",
        "legend": _LEGEND if results else "",
    }  # fmt: skip


def headline(results: Sequence[CaseResult], searches: Sequence[SearchResult]) -> dict[str, str]:
    """The answer: "30 of 30" and "cases came out as expected"; or how many did not."""
    asked = [search.passed for search in searches if search.passed is not None]
    kinds = [("case", [result.passed for result in results]), ("search", asked)]
    if not results and not asked:
        return {"number": f"{len(searches)}", "words": f"{_noun(len(searches), 'search')} made"}
    if results and not asked and all(result.case.expect == EITHER and result.passed for result in results):
        return {"number": f"{len(results)}", "words": f"{_noun(len(results), 'case')} to be compared"}
    good = all(all(passed) for _, passed in kinds)
    counts = [
        (f"{passed.count(good)} of {len(passed)}", _noun(len(passed), kind)) for kind, passed in kinds if good in passed
    ]
    (first, noun), *others = counts
    more = "".join(f", and {count} {kind}" for count, kind in others)
    return {"number": first, "words": f"{noun}{more} {'came' if good else 'did not come'} out as expected"}


def _noun(count: int, kind: str) -> str:
    return kind if count == 1 else {"case": "cases", "search": "searches"}[kind]


def counts_words(results: Sequence[CaseResult], searches: Sequence[SearchResult]) -> str:
    """ "12 trackworthy, 18 not trackworthy; 30 trials in all"."""
    if not results:
        return ""
    failed = sum(result.verdict == ERROR for result in results)
    worthy = sum(result.verdict == TRACKWORTHY for result in results)
    against = sum(not result.passed and result.verdict != ERROR for result in results)
    parts = [f"{worthy} trackworthy, {len(results) - failed - worthy} not trackworthy"]
    parts += [f"{against} not as expected"] if against else []
    parts += [f"{failed} failed to run"] if failed else []
    trials = sum(result.case.trials for result in results)
    return "; ".join([*parts, f"{counted(trials, 'trial')} in all"])


def case_words(result: CaseResult, outcome: Outcome | None) -> str:
    """What became of a case, and why, in a sentence without its subject."""
    found, case = result.statistics, result.case
    if result.verdict == ERROR:
        which = f"{found.errors} of {case.trials} trials" if case.trials > 1 else "it"
        return _cut(f"{which} failed to run: {found.first_error}")
    if result.worst is None:
        return _cut(f"has no path to follow: the planner found none ({found.no_path_reason})")
    told = plain(outcome) if outcome else _verdict_words(result)
    if case.trials == 1:
        return _cut(told)
    asked = f", where {number(100 * case.pass_share)} % are asked" if case.pass_share < 1.0 else ""
    lost = f", {found.no_path} without a path" if found.no_path else ""
    return _cut(f"{found.trackworthy} of {found.tried} trials are trackworthy{lost}{asked}; the worst {told}")


def _verdict_words(result: CaseResult) -> str:
    """What is known of the worst trial where it is not shown whole."""
    worst = result.worst
    words = "is trackworthy" if worst and worst.trackworthy else "is not trackworthy"
    decided = worst.decided_by if worst else ""
    return f"{words}, decided by {spoken(decided)}: margin {deciding(result, None).words}" if decided else words


def _groups(
    results: Sequence[CaseResult], outcomes: Mapping[str, Outcome], searches: Sequence[SearchResult]
) -> list[Json]:
    """The worst cases: those that are not as expected, or those that are and fail; then the ones nearest a limit."""

    def by_severity(result: CaseResult) -> tuple[bool, float, int]:
        return severity(result, outcomes.get(result.case.name))

    told = dict(zip((r.case.name for r in results), dimensions(results, outcomes), strict=True))
    ranked = sorted(results, key=by_severity)
    unexpected = [result for result in ranked if not result.passed]
    unworthy = [r for r in ranked if r.passed and r.verdict != TRACKWORTHY]
    failed = _spread([r for r in unworthy if r.case.expect != EITHER], told)
    compared = _spread([r for r in unworthy if r.case.expect == EITHER], told)
    near = [r for r in ranked if r.passed and r.verdict == TRACKWORTHY and math.isfinite(by_severity(r)[1])]
    missed = [search for search in searches if search.passed is False]
    groups: list[tuple[str, list[CaseResult], int]] = [
        ("Not as expected", unexpected, _MOST_UNEXPECTED),
        ("Not trackworthy, as expected", failed, 2 if unexpected else _MOST_FAILED),
        ("Not trackworthy, to be compared", compared, 2 if unexpected or failed else _MOST_FAILED),
        ("Trackworthy, and nearest to a limit", near, 2 if unexpected else _MOST_NEAR),
    ]
    found: list[Json] = [
        {
            "title": title,
            "rows": [_row(result, outcomes.get(result.case.name)) for result in group[:most]],
            "more": max(0, len(group) - most),
        }
        for title, group, most in groups
        if group
    ]
    if missed:
        rows: list[Json] = [_search_row(one) for one in missed]
        found.insert(0, {"title": "Searches that are not as expected", "rows": rows[:3], "more": max(0, len(rows) - 3)})
    return found


def _search_row(search: SearchResult) -> dict[str, Json]:
    words = search_line(search).removeprefix("FAIL ").removeprefix("error ").strip()
    return {"case": "", "name": "", "mark": "✗", "good": False, "words": _cut(words)}


def _spread(ranked: Sequence[CaseResult], told: Mapping[str, Mapping[str, str]]) -> list[CaseResult]:
    """The worst of each scenario first, so that a few cases show as many as there are."""
    seen: dict[str, int] = {}
    places = []
    for result in ranked:
        scenario = told[result.case.name][SCENARIO]
        seen[scenario] = seen.get(scenario, 0) + 1
        places.append(seen[scenario])
    order = sorted(range(len(ranked)), key=lambda i: (places[i], i))
    return [ranked[i] for i in order]


def _row(result: CaseResult, outcome: Outcome | None) -> dict[str, Json]:
    return {
        "case": result.case.name,
        "name": result.case.name,
        "mark": {TRACKWORTHY: "✓", ERROR: "!"}.get(result.verdict, "✗"),
        "good": result.verdict == TRACKWORTHY,
        "words": case_words(result, outcome),
    }


def _tested(
    results: Sequence[CaseResult], outcomes: Mapping[str, Outcome], searches: Sequence[SearchResult]
) -> list[Json]:
    """Rows of what was varied: a word, and the values."""
    told = dimensions(results, outcomes)
    ours = {row[PATH] for row, result in zip(told, results, strict=True) if result.case.planner}
    files = list(dict.fromkeys(row[PATH] for row in told if row[PATH] not in ours))
    planners = list(dict.fromkeys(row[PATH] for row in told if row[PATH] in ours))
    conditions = list(dict.fromkeys(row[CONDITIONS] for row in told if row[CONDITIONS]))
    speeds: dict[str, list[str]] = {}
    for row in told:
        speeds.setdefault(row[VEHICLE], []).append(row[SPEED])
    vehicles = [f"{vehicle} at {_listed(values)}" for vehicle, values in speeds.items()]
    controllers = list(dict.fromkeys(row[CONTROLLER] for row in told))
    away = [f"{outcome.vehicle} {word}" for outcome in outcomes.values() for word in planet_words(outcome)]
    rows = [
        ("planners" if len(planners) > 1 else "planner", _listed(planners)),
        ("paths" if len(files) > 1 else "path", _listed(files)),
        ("maps", _listed(row[SCENARIO] for row in told if row[SCENARIO])),
        ("vehicles" if len(vehicles) > 1 else "vehicle", _listed(vehicles, "; ")),
        ("controllers" if len(controllers) > 1 else "controller", _listed(controllers)),
        ("conditions", _listed(conditions, "; ")),
        ("planet", _listed(away)),
        ("trials", _trials(results)),
        ("searches", _searches(searches)),
    ]  # fmt: skip
    return [[word, values] for word, values in rows if values]


def _trials(results: Sequence[CaseResult]) -> str:
    """ "30 cases of 1 trial each"."""
    if not results:
        return ""
    each = sorted({result.case.trials for result in results})
    span = f"{each[0]}" if len(each) == 1 else f"{each[0]} to {each[-1]}"
    noun = "trial" if each[-1] == 1 else "trials"
    return f"{counted(len(results), 'case')} of {span} {noun}{' each' if len(results) > 1 else ''}"


def _searches(searches: Sequence[SearchResult]) -> str:
    scales = sum(isinstance(one.search, ScaleSearch) for one in searches)
    speeds = len(searches) - scales
    parts = [f"{scales} for the smallest scale"] if scales else []
    parts += [f"{speeds} for the top speed"] if speeds else []
    return f"{', '.join(parts)}: {_listed((_searched(one) for one in searches), '; ')}" if parts else ""


def _searched(one: SearchResult) -> str:
    """What is searched with: "road.csv with truck under lqr"."""
    search = one.search
    path = Path(search.path).name if isinstance(search, SpeedSearch) and search.path else search.planner
    return f"{path} with {Path(search.vehicle).stem} under {search.controller}"


def _listed(values: Iterable[str], separator: str = ", ") -> str:
    """The different values in their order, the first few of many."""
    names = [_cut(name, _LONGEST_NAME if separator == ", " else 110) for name in dict.fromkeys(values)]
    more = [f"and {len(names) - _MOST_NAMES} more"] if len(names) > _MOST_NAMES else []
    return separator.join([*names[:_MOST_NAMES], *more])


def _cut(words: str, most: int = _LONGEST) -> str:
    return words if len(words) <= most else f"{words[: most - 1]}…"
