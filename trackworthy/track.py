"""`trackworthy track`: one path and one vehicle, or a fleet with a path each, and one verdict."""

from __future__ import annotations

import argparse
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from campaigns.case import Case


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "track",
        help="put a path under a vehicle, or several under a fleet, and judge it",
        description="Put a path under a vehicle, or several under a fleet.",
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add(
        "path",
        nargs="+",
        metavar="PATH",
        help="path or mission file: .csv, .geojson, .waypoints, .plan; several are a fleet, one vehicle each",
    )
    add("--vehicle", required=True, help="c172x, ares, truck, truck-dynamic, or an aircraft's TOML file")
    add("--planet", help="earth or mars (default: the scenario's, or else the vehicle's own)")
    add("--controller", default="lqr", help="pure-pursuit, l1, stanley, vector-field or lqr (default)")
    add("--speed", help="55, 55m/s, 30km/h or 100kt: airspeed of aircraft, ground speed of others")
    add("--altitude", help="metres; in place of the path's own heights")
    add("--wind", help="10@270: 10 m/s from 270 degrees true")
    add("--corridor", help="half-width in metres within which the path must be kept")
    add("--scenario", help="map with obstacles: a built-in name, a TOML file, or FILE.scen:NUMBER")
    add("--corners", choices=("as-drawn", "fly-by"), default="as-drawn", help="fly-by rounds a mission's corners")
    add("--steering-hz", type=float, default=20.0, help="how often a truck may steer (paper 004: 2)")
    add("--departures", choices=("together", "separated"), default="together", help="of a fleet; separated by delays")
    add("--separation", help="metres that a fleet's vehicles must stay apart (default: the vehicle's own)")
    add("--require", action="append", default=[], metavar="LIMIT", help="e.g. 'cross_track_p95<=4'; repeatable")
    add("--expect", choices=("trackworthy", "not-trackworthy", "either"), default="trackworthy")
    add("--picture", metavar="FILE.png", help="where to save the picture (default: PATH's name and the vehicle's)")
    add(
        "--export",
        action="append",
        default=[],
        metavar="FILE",
        help="flown track: .csv .kml .geojson .tlog; repeatable",
    )
    add("--json", action="store_true", help="print one JSON object on standard output and nothing else")


def main(args: argparse.Namespace) -> int:
    """Track, show, save, and answer with the exit code."""
    from campaigns.inputs import Reader
    from campaigns.prepare import assemble
    from reports.figures.fleet_figure import save_fleet_figure
    from reports.figures.track_figure import save_track_figure
    from reports.files.export import check, export
    from reports.terminal.table import print_outcome
    from tracking.trial import run_trial
    from trackworthy.streams import chatter_to_stderr, check_picture, numbered, protect, tell

    with chatter_to_stderr():
        case = _case(args)
        trial = assemble(case, Reader(Path()).read(case))
        tell(trial.notes)
        picture = args.picture or f"{Path(args.path[0]).stem}-{Path(args.vehicle).stem}.png"
        check_picture(picture)
        for file in args.export:
            check(trial.path, file)
        exports = [numbered(file, len(args.path)) for file in args.export]
        for file in (picture, *chain(*exports)):
            protect(file, *filter(None, (*args.path, args.vehicle, args.scenario)))
        outcome = run_trial(trial)
    save = save_fleet_figure if outcome.fleet else save_track_figure
    save(outcome, picture)
    members = outcome.fleet.members if outcome.fleet else (outcome,)
    for files in exports:
        for member, file in zip(members, files, strict=True):
            export(member, file)
    if args.json:
        import json

        from reports.files.json_result import to_json

        print(json.dumps(to_json(outcome), indent=2))
    else:
        print_outcome(outcome)
    tell(f"saved {file}" for file in (picture, *chain(*exports)))
    return 0 if outcome.verdict.passed else 1


def _case(args: argparse.Namespace) -> Case:
    from campaigns.case import Case
    from campaigns.conditions import ConditionKeys, WindKeys

    return Case(
        path=args.path[0],
        others=tuple(args.path[1:]),
        planet=args.planet,
        departures=args.departures,
        separation=args.separation,
        vehicle=args.vehicle,
        controller=args.controller,
        speed=args.speed,
        altitude=args.altitude,
        corridor=args.corridor,
        conditions=ConditionKeys(wind=args.wind or WindKeys(0.0)),
        scenario=args.scenario,
        corners=args.corners,
        steering_hz=args.steering_hz,
        require=tuple(args.require),
        expect=args.expect,
    )
