"""What a check found, as JUnit XML: a violated limit is a failure, machinery that failed an error."""

from __future__ import annotations

import xml.etree.ElementTree as ET

from campaigns.gate import ERRORS, UNMEASURED, Check, Finding
from reports.check_text import told

# XML 1.0 has no control characters but these
_KEPT = "\t\n\r"


def check_junit(check: Check) -> str:
    """A test a metric of a case, and one for each finding that is not about a metric."""
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
    errors = sum(finding.kind == ERRORS for finding in check.findings)
    suite.set("tests", str(len(suite)))
    suite.set("failures", str(len(check.findings) - errors))
    suite.set("errors", str(errors))
    suites = ET.Element("testsuites")
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
