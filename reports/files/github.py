"""What a check found, for GitHub Actions: annotations on the run, and a summary in Markdown."""

from __future__ import annotations

from campaigns.gate import ERRORS, Check, Finding
from reports.files.markdown import cell, fenced, row
from reports.terminal.check_text import conclusion, improved_words, shown_by, told, with_unit

MOST_ANNOTATIONS = 10  # GitHub shows no more of a step


def workflow_commands(check: Check) -> str:
    """Workflow commands, one a line: what they say appears on the run and in the pull request."""
    lines = [_annotation(finding) for finding in check.findings[:MOST_ANNOTATIONS]]
    return "".join(f"{line}\n" for line in lines)


def markdown(check: Check) -> str:
    """The step's summary."""
    lines = [f"### trackworthy check: {cell(check.campaign)}", "", conclusion(check), ""]
    if check.findings:
        lines += ["| case | what | old | new | allowed | worst trial |", "| --- | --- | --- | --- | --- | --- |"]
        lines += [_row(finding) for finding in check.findings]
        commands = [finding.command for finding in check.findings if finding.command]
        if commands:
            lines += ["", "Replay the worst trials:", "", *fenced(list(dict.fromkeys(commands)))]
    if check.improved:
        lines += ["", f"Improved: {cell(improved_words(check))}"]
    return "\n".join(lines) + "\n"


def _annotation(finding: Finding) -> str:
    title = _property(f"{finding.kind}: {finding.case}")
    text = told(finding) + (f"; {shown_by(finding)}: {finding.command}" if finding.command else "")
    return f"::error title={title}::{_data(text)}"


def _row(finding: Finding) -> str:
    one = finding.comparison
    if one is None:
        what = f"{'error' if finding.kind == ERRORS else finding.kind}: {finding.message}"
        cells = [finding.case, what, "", "", "", "" if finding.trial is None else f"{finding.trial}"]
    else:
        values = [with_unit(one.old, one), with_unit(one.new, one), f"+{with_unit(one.limit, one)}"]
        cells = [finding.case, one.metric, *values, f"{one.trial}"]
    return row(cells)


def _data(text: str) -> str:
    """Escaped as actions/toolkit does the message of a command."""
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
