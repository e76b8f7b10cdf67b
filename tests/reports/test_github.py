import re
from dataclasses import replace
from urllib.parse import unquote

import pytest

from campaigns.comparison import Comparison
from campaigns.gate import ERRORS, VANISHED, VERDICT, WORSE, Check, Finding
from reports.files.github import MOST_ANNOTATIONS, markdown, workflow_commands

P95 = Comparison(
    case="road", metric="cross_track_p95", unit="m", old=0.1, new=0.2, worse=0.1, limit=0.005,
    regressed=True, improved=False, trial=7, seed=9,
)  # fmt: skip
COMMAND = "trackworthy run out/campaign.toml --case road --trial 7"
NASTY = [
    "a|b", r"a\|b", "`ls`", "line\nbreak", "cr\rlf\r\n::error::x", "<script>alert(1)</script>", "50 %0A", "a:b,c::d",
    "🚚", "bell\a esc\x1b[31m", "[a](http://b) *c* _d_", "::error title=x::y",
]  # fmt: skip


def worse(one, command=COMMAND):
    return Finding(WORSE, one.case, f"{one.metric} is worse", one, one.trial, one.seed, command)


def check_of(*findings, improved=(), campaign="nightly"):
    compared = tuple(finding.comparison for finding in findings if finding.comparison)
    return Check(campaign, (*compared, *improved), findings, improved)


def cells(line):
    """The cells of a row of a table in GitHub's Markdown, as they are shown."""
    assert line.startswith("| ")
    assert line.endswith(" |")
    bars = re.findall(r"\\.|[^\\|]+|\|", line)
    parts = "".join("\0" if bar == "|" else re.sub(r"\\(.)", r"\1", bar) for bar in bars).split("\0")
    return [part.strip() for part in parts[1:-1]]


def table(text):
    return [cells(line) for line in text.split("\n") if line.startswith("|")]


def test_a_finding_is_an_annotation_with_title_numbers_and_command():
    assert workflow_commands(check_of(worse(P95))) == (
        "::error title=worse%3A road::cross_track_p95 was 0.1 m, is 0.2 m: worse by 0.1 m, allowed 0.005 m; "
        f"worst in trial 7 (seed 9): {COMMAND}\n"
    )
    gone = Finding(VANISHED, "old", "the case is in the baseline, and is not run any more")
    assert workflow_commands(check_of(gone)) == (
        "::error title=vanished%3A old::the case is in the baseline, and is not run any more\n"
    )


@pytest.mark.parametrize("name", NASTY)
def test_whatever_its_name_a_finding_is_one_line_and_comes_back(name):
    one = replace(P95, case=name)
    flipped = Finding(VERDICT, name, f"{name} was trackworthy", None, 3, 4, f"run {name}")
    found = workflow_commands(check_of(worse(one, f"run {name}"), flipped))
    assert "\r" not in found
    first, second, rest = found.split("\n")
    assert rest == ""
    for line, kind, message in ((first, "worse", ": "), (second, "verdict", f"{name} was trackworthy")):
        title, told = re.fullmatch(r"::error title=([^:,]*)::(.*)", line).groups()
        assert unquote(title) == f"{kind}: {name}"
        assert message in unquote(told)
        assert unquote(told).endswith(f": run {name}")


def test_no_more_annotations_than_github_shows():
    findings = [Finding(VANISHED, f"case {i}", "gone") for i in range(MOST_ANNOTATIONS + 5)]
    assert workflow_commands(check_of(*findings)).count("::error ") == MOST_ANNOTATIONS
    assert len(table(markdown(check_of(*findings)))) == 2 + MOST_ANNOTATIONS + 5


def test_nothing_found_annotates_nothing():
    assert workflow_commands(check_of()) == ""


def test_the_summary_is_a_table_with_old_new_and_limit():
    share = replace(P95, metric="completion", unit="share", old=1.0, new=0.9, worse=0.1, limit=0.001, trial=2)
    failed = Finding(ERRORS, "air", "2 of 5 trials failed to run")
    head, rule, *rows = table(markdown(check_of(worse(P95), worse(share), failed)))
    assert head == ["case", "what", "old", "new", "allowed", "worst trial"]
    assert rule == ["---"] * 6
    assert rows == [
        ["road", "cross_track_p95", "0.1 m", "0.2 m", "+0.005 m", "7"],
        ["road", "completion", "100 %", "90 %", "+0.1 %", "2"],
        ["air", "error: 2 of 5 trials failed to run", "", "", "", ""],
    ]


@pytest.mark.parametrize("name", NASTY)
def test_whatever_its_name_a_row_keeps_its_columns(name):
    one = replace(P95, case=name)
    text = markdown(check_of(worse(one), Finding(ERRORS, name, name), improved=(one,), campaign=name))
    rows = table(text)
    shown = " ".join(name.split())
    assert [len(row) for row in rows] == [6] * 4
    assert rows[2][0] == rows[3][0] == shown
    assert rows[3][1] == f"error: {shown}"
    assert re.sub(r"\\(.)", r"\1", text.split("\n")[0]) == f"### trackworthy check: {shown}"
    assert not re.search(r"(?<!\\)[<\[]", text)  # no markup, no link


def test_commands_stand_in_a_block_once():
    rms = replace(P95, metric="cross_track_rms")
    lines = markdown(check_of(worse(P95), worse(rms), worse(P95, "other"))).split("\n")
    start, end = (i for i, line in enumerate(lines) if line == "```")
    assert lines[start + 1 : end] == [COMMAND, "other"]


def test_no_command_ends_the_block_early():
    command = "run --case 'a\n```\n# heading' --trial 7"
    text = markdown(check_of(worse(P95, command)))
    (fence,) = re.findall(r"^(`{3,})\n(?:.*\n)*?\1$", text, re.MULTILINE)
    block = text.split(f"{fence}\n")[1]
    assert block == f"{command}\n"


def test_without_findings_there_is_no_table():
    text = markdown(check_of(improved=(replace(P95, new=0.05),)))
    assert table(text) == []
    assert "```" not in text
    assert "AS GOOD AS THE BASELINE  1 metric of 1 case compared" in text
    assert "\nImproved: road: cross\\_track\\_p95 0.1 m to 0.05 m; --update makes that the baseline\n" in text
