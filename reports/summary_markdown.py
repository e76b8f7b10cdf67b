"""`summary.md`: a campaign in a few lines, for a pull request."""

from __future__ import annotations

from campaigns.finished import Finished
from campaigns.summary import CaseResult
from reports.campaign_words import case_line
from reports.markdown import cell, fenced, row
from reports.quantity import counted
from reports.report_data import Report
from reports.search_words import search_line

MOST_ROWS = 20  # of cases; a comment is no place for more
PLOTS = 2  # of the worst cases

_WORDS = {"trackworthy": "trackworthy", "not-trackworthy": "not trackworthy", "error": "failed to run"}


def markdown(finished: Finished, report: Report) -> str:
    """The whole file: what came out, the cases from the worst on, two pictures, and how to run it again."""
    worst = worst_first(finished.results)
    passed = sum(result.passed for result in worst)
    lines = [f"## {'✓' if passed == len(worst) else '✗'} {cell(finished.campaign.title)}", ""]
    lines += [_counted(finished), ""]
    if worst:
        lines += ["| | case | verdict | why |", "| --- | --- | --- | --- |"]
        lines += [_row(result, finished) for result in worst[:MOST_ROWS]]
    if len(worst) > MOST_ROWS:
        lines += ["", f"and {counted(len(worst) - MOST_ROWS, 'more case')}, all better."]
    lines += [f"- {cell(search_line(search))}" for search in finished.searches]
    lines += ["", *_plots(worst, report)]
    lines += ["Again:", "", *fenced([f"trackworthy run {finished.called}"])]
    return "\n".join(lines) + "\n"


def worst_first(results: list[CaseResult]) -> list[CaseResult]:
    """What is not as expected first, then by how much the worst trial keeps to what decides it."""
    return sorted(results, key=lambda one: (one.passed, one.worst.score if one.worst else -1.0, one.number))


def _counted(finished: Finished) -> str:
    results = finished.results
    passed, trials = sum(result.passed for result in results), finished.campaign.trials
    verdicts = [_WORDS[result.verdict] for result in results]
    kinds = [f"{verdicts.count(word)} {word}" for word in _WORDS.values() if word in verdicts]
    told = [f"**{passed} of {counted(len(results), 'case')} as expected**: {', '.join(kinds)}"] if results else []
    asked = [search.passed for search in finished.searches if search.passed is not None]
    told += [f"{sum(asked)} of {len(asked)} searches as expected"] if asked else []
    told += [counted(trials, "trial")] if trials else []
    return "; ".join(told)


def _row(result: CaseResult, finished: Finished) -> str:
    name = result.case.name
    told = case_line(result, finished.outcomes.get(name)).partition(f"{name}: ")[2]
    return row(["✓" if result.passed else "✗", name, _WORDS[result.verdict], told])


def _plots(worst: list[CaseResult], report: Report) -> list[str]:
    """The pictures of the first of `worst` that have one, each a link to itself."""
    known = {case["name"]: case["figure"] for case in report.cases}
    shown = [result.case.name for result in worst if result.case.name in known][:PLOTS]
    files = [(cell(name), f"figures/{str(known[name]).removesuffix('.svg')}.png") for name in shown]
    return [line for name, file in files for line in (f"[![{name}]({file})]({file})", "")]
