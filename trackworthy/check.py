"""`trackworthy check`: are these results as good as the baseline?"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from campaigns.gate import Check

FORMATS = ("table", "json", "junit", "github")


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "check", help="hold a campaign's results against a baseline", description="Hold results against a baseline."
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add("folder", metavar="DIR", help="results of a campaign, as `trackworthy run` leaves them")
    add("--baseline", required=True, metavar="FILE", help="JSON file to compare with; commit it with your code")
    add("--update", action="store_true", help="make these results the baseline")
    add("--format", choices=FORMATS, default="table", help="what to print (default: table)")


def main(args: argparse.Namespace) -> int:
    """Compare, tell, and answer with the exit code."""
    from campaigns.baseline import check_replaceable, read_baseline, read_record, write_baseline
    from campaigns.gate import check
    from planners.errors import InputError, TrackworthyError
    from reports.words.quantity import counted
    from trackworthy.streams import tell

    file = Path(args.baseline)
    record = read_record(Path(args.folder))
    if args.update:
        check_replaceable(file)
        if failed := next((result for result in record.results if result.statistics.errors), None):
            what = f"trials of {failed.case.name!r} failed to run ({failed.statistics.first_error})"
            raise InputError(args.folder, what, "a baseline is of results without errors")
        write_baseline(record.baseline, file)
        tell([f"{file}: the baseline is now that of {counted(len(record.results), 'case')}"])
        return 0
    baseline = read_baseline(file)
    if baseline.campaign != record.campaign.name:
        tell([f"{file}: is of another campaign, {baseline.campaign!r}"])
    found = check(record, baseline)
    _show(found, args.format)
    if found.machinery_failed:
        return TrackworthyError.exit_code
    return 1 if found.findings else 0


def _show(found: Check, form: str) -> None:
    if form == "table":
        from reports.terminal.check_text import print_check

        print_check(found)
    elif form == "json":
        from reports.files.check_json import check_json

        print(check_json(found))
    elif form == "junit":
        from reports.files.junit import check_junit

        print(check_junit(found), end="")
    else:
        _show_github(found)


def _show_github(found: Check) -> None:
    """Annotations on standard output, the summary where GitHub says, or after them."""
    import os

    from reports.files.github import markdown, workflow_commands

    print(workflow_commands(found), end="")
    summary = os.environ.get("GITHUB_STEP_SUMMARY")
    if summary:
        with open(summary, "a", encoding="utf-8") as file:
            file.write(markdown(found))
    else:
        print(markdown(found), end="")
