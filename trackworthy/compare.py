"""`trackworthy compare`: two campaigns side by side."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

FORMATS = ("table", "json", "md")
WAYS = ("both", "name", "setting")


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "compare",
        help="two campaigns side by side: what was changed, and what came of it",
        description="Hold the results in DIR_B against those in DIR_A, case by case.",
        epilog="The exit code is 0 whatever is found: compare informs. The gate is: trackworthy check.",
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add("a", metavar="DIR_A", help="results of a campaign, as `trackworthy run` leaves them")
    add("b", metavar="DIR_B", help="results of another, or of the same after a change")
    add("--by", choices=WAYS, default="both",
        help="what makes two cases belong together: their name, their settings but for one (controller, planner, "
        "vehicle, speed or conditions), or the name and else the settings (default)")  # fmt: skip
    add("--format", choices=FORMATS, default="table", help="what to print (default: table)")


def main(args: argparse.Namespace) -> int:
    """Read both, compare, and tell."""
    from campaigns.side_by_side import read_side, side_by_side
    from trackworthy.streams import tell

    first, second = Path(args.a), Path(args.b)
    found = side_by_side(read_side(first), read_side(second), args.by)
    if first.resolve() == second.resolve():
        tell([f"{args.a} and {args.b} are the same folder"])
    if args.format == "table":
        from reports.terminal.compare_text import print_side_by_side

        print_side_by_side(found)
    elif args.format == "json":
        from reports.files.compare_json import side_by_side_json

        print(side_by_side_json(found))
    else:
        from reports.files.compare_markdown import side_by_side_markdown

        print(side_by_side_markdown(found), end="")
    return 0
