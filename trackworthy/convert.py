"""`trackworthy convert`: a path from one kind of file to another."""

from __future__ import annotations

import argparse
from typing import Any


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "convert",
        help="convert path and mission files, by suffix",
        description="Convert a path or mission file to another kind, told by the suffixes.",
    )
    parser.set_defaults(main=main)
    parser.add_argument("source", metavar="IN", help=".csv, .geojson, .waypoints or .plan")
    parser.add_argument("target", metavar="OUT", help="the same; overwritten if it is there")


def main(args: argparse.Namespace) -> int:
    """Read, say what was skipped, write."""
    from planners import files
    from trackworthy.streams import protect, tell

    protect(args.target, args.source)
    source = files.read(args.source)
    notes = [*source.notes, *(["its geofence is not written"] if source.fence else [])]
    tell(f"{args.source}: {note}" for note in notes)
    files.write(source.path, args.target)
    tell([f"saved {args.target}: {len(source.path.points)} points, {source.path.length:.1f} m"])
    return 0
