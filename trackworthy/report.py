"""`trackworthy report`: the report of a campaign again, from what is stored."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from campaigns.finished import Finished

FORMS = ("pdf", "html", "png", "junit", "md")  # those of `reports.write.FILES`
PAPERS = {"a4": "a4", "letter": "us-letter"}


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "report",
        help="write the report of a campaign again",
        description="Write the report of a campaign again, from what is stored in its folder.",
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add("folder", metavar="DIR", help="results of a campaign, as `trackworthy run` leaves them")
    add("--format", action="append", choices=FORMS, default=[], help="only this form; repeatable (default: all)")
    add("--paper", choices=tuple(PAPERS), default="a4", help="of the PDF (default: a4)")
    add("--baseline", metavar="FILE", help="say in it what became better or worse, as `trackworthy check` does")
    add("-j", "--jobs", type=int, metavar="N", help="processes to draw in (default: one a processor)")


def main(args: argparse.Namespace) -> int:
    """Write it, and name the files."""
    from campaigns.baseline import read_baseline
    from campaigns.execute import Machines, default_jobs
    from campaigns.finished import read_finished
    from planners.errors import InputError
    from reports.write import DRAWING, write_report
    from trackworthy.streams import tell

    if args.jobs is not None and args.jobs < 1:
        raise InputError("--jobs", f"{args.jobs} is no number of processes", "give 1 or more")
    baseline = read_baseline(Path(args.baseline)) if args.baseline else None
    with Machines(args.jobs or default_jobs()).lanes(DRAWING) as lanes:
        finished = read_finished(Path(args.folder), lanes)
        tell(_about(finished))
        if baseline and baseline.campaign != finished.campaign.name:
            tell([f"{args.baseline}: is of another campaign, {baseline.campaign!r}"])
        for file in write_report(finished, lanes, args.format or FORMS, PAPERS[args.paper], baseline):
            print(file)
    return 0


def _about(finished: Finished) -> list[str]:
    """What the reader should know of results that other code made."""
    if not finished.other_code:
        return []
    told = "another version of trackworthy or its libraries made these results"
    missing = sum(result.worst is not None for result in finished.results) - len(finished.outcomes)
    whole = f"; {missing} worst trials whose tracks were not kept are not shown whole" if missing > 0 else ""
    return [f"{finished.folder}: {told}{whole}"]
