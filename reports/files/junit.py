"""Cases, or what a check found, as JUnit XML: what is not as expected is a failure, machinery that failed an error."""

from __future__ import annotations

import xml.etree.ElementTree as ET

from campaigns.campaign import replay_command
from campaigns.finished import Finished
from campaigns.gate import ERRORS, UNMEASURED, Check, Finding
from campaigns.summary import ERROR, CaseResult
from reports.terminal.check_text import told
from reports.words.campaign_words import case_line
from reports.words.search_words import search_line

# XML 1.0 has no control characters but these
_KEPT = "\t\n\r"


def check_junit(check: Check) -> str:
    """A test a metric of a case, and one for each finding that is not about a metric."""
    return _document(_check_suite(check))


def _check_suite(check: Check) -> ET.Element:
    suite = ET.Element("testsuite", name=_clean(f"trackworthy check {check.campaign}"))
    by_metric = {(one.case, one.metric): finding for finding in check.findings if (one := finding.comparison)}
    for one in check.comparisons:
        test = ET.SubElement(suite, "testcase", classname=_clean(one.case), name=one.metric)
        if finding := by_metric.get((one.case, one.metric)):
            _add(test, finding)
    for finding in check.findings:
        if finding.comparison is None:
            # Of what cannot be measured there may be several in a case, and readers tell tests by their names
            name = _clean(finding.message) if finding.kind == UNMEASURED else finding.kind
            _add(ET.SubElement(suite, "testcase", classname=_clean(finding.case), name=name), finding)
    return suite


def campaign_junit(finished: Finished, held: Check | None = None) -> str:
    """A test a case and a search; and in a suite of its own what came of holding them against a baseline."""
    suite = ET.Element("testsuite", name=_clean(f"trackworthy run {finished.campaign.name}"))
    for result in finished.results:
        test = ET.SubElement(suite, "testcase", classname=_clean(finished.campaign.name), name=_clean(result.case.name))
        if not result.passed:
            _add_case(test, result, finished)
    for search in finished.searches:
        test = ET.SubElement(suite, "testcase", classname=search.search.BLOCK, name=_clean(search.search.name))
        if search.found.error or search.passed is False:
            kind = "error" if search.found.error else "failure"
            ET.SubElement(test, kind, message=_clean(search_line(search)), type=search.found.kind or "not-as-expected")
    return _document(suite, *([_check_suite(held)] if held else []))


def _add_case(test: ET.Element, result: CaseResult, finished: Finished) -> None:
    name = result.case.name
    kind = "error" if result.verdict == ERROR else "failure"
    told_ = _clean(case_line(result, finished.outcomes.get(name)))
    lines = [told_]
    if result.worst is not None:
        lines.append(_clean(replay_command(finished.called, name, result.worst.trial)))
    ET.SubElement(test, kind, message=told_, type=result.verdict).text = "\n".join(lines)


def _document(*suites_of: ET.Element) -> str:
    """The file, each suite with the numbers of its tests."""
    suites = ET.Element("testsuites")
    for suite in suites_of:
        suite.set("tests", str(len(suite)))
        suite.set("failures", str(len(suite.findall("testcase/failure"))))
        suite.set("errors", str(len(suite.findall("testcase/error"))))
        suites.append(suite)
    ET.indent(suites)
    return ET.tostring(suites, encoding="unicode", xml_declaration=True) + "\n"


def _add(test: ET.Element, finding: Finding) -> None:
    kind = "error" if finding.kind == ERRORS else "failure"
    told_ = _clean(told(finding))
    lines = filter(None, (told_, _clean(finding.command)))
    ET.SubElement(test, kind, message=told_, type=finding.kind).text = "\n".join(lines)


def _clean(text: str) -> str:
    return "".join(c if c.isprintable() or c in _KEPT else "?" for c in text)
