"""`summary.md`: a campaign in a few lines, for a pull request."""

from __future__ import annotations

from campaigns.finished import Finished
from campaigns.gate import Check
from campaigns.summary import CaseResult
from reports.files.github import markdown as check_markdown
from reports.files.markdown import cell, fenced, row
from reports.pages.front_page import case_words, counts_words
from reports.pages.report_data import Report
from reports.words.deciding import severity
from reports.words.quantity import counted
from reports.words.search_words import search_line

MOST_ROWS = 20  # of cases; a comment is no place for more
PLOTS = 2  # of the worst cases

_WORDS = {"trackworthy": "trackworthy", "not-trackworthy": "not trackworthy", "error": "failed to run"}


def markdown(finished: Finished, report: Report, held: Check | None = None) -> str:
    """The whole file: what came out, also `held` against a baseline, the cases from the worst on, two pictures, and how
    to run it again.
    """
    worst = worst_first(finished)
    good = all(result.passed for result in worst) and all(one.passed is not False for one in finished.searches)
    good = good and not (held and held.findings)
    lines = [f"## {'✓' if good else '✗'} {cell(finished.campaign.title)}", "", _counted(finished), ""]
    if worst:
        lines += ["| | case | verdict | why |", "| --- | --- | --- | --- |"]
        lines += [_row(result, finished) for result in worst[:MOST_ROWS]]
    if len(worst) > MOST_ROWS:
        lines += ["", f"and {counted(len(worst) - MOST_ROWS, 'more case')}."]
    lines += [f"- {cell(search_line(search))}" for search in finished.searches]
    files = [f"figures/{stem}.png" for stem in plots(finished, report)]
    lines += ["", *(line for file in files for line in (f"[![{file}]({file})]({file})", ""))]
    lines += [check_markdown(held)] if held else []
    lines += ["Again:", "", *fenced([finished.manifest.command or f"trackworthy run {finished.called}"])]
    return "\n".join(lines) + "\n"


def worst_first(finished: Finished) -> list[CaseResult]:
    """What is not as expected, then what failed as expected, then the others, each by what is left of a limit."""
    return sorted(
        finished.results,
        key=lambda result: (result.passed, *severity(result, finished.outcomes.get(result.case.name))),
    )


def plots(finished: Finished, report: Report) -> list[str]:
    """The names of the figures of the worst cases that have one."""
    known = {case["name"]: str(case["figure"]).removesuffix(".svg") for case in report.cases}
    return [known[result.case.name] for result in worst_first(finished) if result.case.name in known][:PLOTS]


def _counted(finished: Finished) -> str:
    passed, results = sum(result.passed for result in finished.results), finished.results
    told = (
        [f"**{passed} of {counted(len(results), 'case')} as expected**: {counts_words(results, ())}"] if results else []
    )
    asked = [search.passed for search in finished.searches if search.passed is not None]
    told += [f"{sum(asked)} of {len(asked)} searches as expected"] if asked else []
    return "; ".join(told)


def _row(result: CaseResult, finished: Finished) -> str:
    name = result.case.name
    told = case_words(result, finished.outcomes.get(name))
    return row(["✓" if result.passed else "✗", name, _WORDS[result.verdict], told])
