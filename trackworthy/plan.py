"""`trackworthy plan`: one planner on one scenario, and what its path is like, or its paths."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from planners.scenario import Scenario


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "plan",
        help="plan on a scenario and measure what comes out",
        description="Plan a path from start to goal, or those of a fleet.",
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add("scenario", metavar="SCENARIO", help="a built-in name, a TOML file, or FILE.scen:NUMBER of movingai.com")
    add("--planner", required=True, help="its name, from: trackworthy list planners")
    add("--seed", type=int, default=0, metavar="N", help="decides all that is random (default: 0)")
    add(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="a setting, from: trackworthy list planner-settings; the value as in TOML, or a word; repeatable",
    )
    add(
        "-o",
        "--output",
        metavar="FILE",
        help="where to save the path: .csv .geojson .waypoints .plan; a fleet's are numbered",
    )
    add("--picture", metavar="FILE.png", help="where to save a picture of it")
    add("--json", action="store_true", help="print one JSON object on standard output and nothing else")


def main(args: argparse.Namespace) -> int:
    """Plan, measure, save, show, and answer with the exit code."""
    from planners import files
    from planners.all_planners import make_planner, plan_with
    from planners.errors import InputError
    from planners.facts import facts_of
    from planners.scenario import load_scenario
    from trackworthy.streams import check_picture, numbered, protect, tell

    if args.seed < 0:
        raise InputError("--seed", f"{args.seed} is negative", "give 0 or more")
    planner = make_planner(args.planner, _settings(args.set))
    scenario = load_scenario(args.scenario)
    if args.output:
        _check_output(args.output, scenario)
    if args.picture:
        check_picture(args.picture)
    most = numbered(args.output, len(scenario.starts)) if args.output else []
    for file in filter(None, (args.output, *most, args.picture)):
        protect(file, *map(str, scenario.files))
    plan = plan_with(planner, scenario, args.seed)
    tell(plan.notes)
    facts = facts_of(plan, planner, scenario, args.seed)
    paths = numbered(args.output, len(plan.paths)) if args.output else []
    for path, file in zip(plan.paths, paths, strict=bool(args.output)):
        files.write(path, file)
    if args.picture:
        from planners.astar.settings import planned_speed
        from reports.figures.plan_figure import save_plan_figure

        speed = planned_speed(planner)
        save_plan_figure(scenario, {planner.name: plan}, args.picture, planner.clearance, speed)
    if args.json:
        from reports.files.plan_json import plan_json

        print(plan_json(facts, plan))
    else:
        from reports.terminal.plan_table import print_facts

        print_facts(facts)
    tell(f"saved {file}" for file in (*paths, *filter(None, [args.picture])))
    return 0 if plan.paths else 1


def _settings(pairs: list[str]) -> dict[str, Any]:
    """The settings given as `key=value`; of one that is given twice, the last. A word needs no quotes."""
    import re
    import tomllib

    from planners.errors import InputError

    settings: dict[str, Any] = {}
    for pair in pairs:
        try:
            one = tomllib.loads(pair)
        except tomllib.TOMLDecodeError:
            word = re.fullmatch(r"(\w+)=([\w.][\w./-]*)", pair)
            one = {word[1]: word[2]} if word else {}
        if len(one) != 1 or "=" not in pair:
            remedy = "write it as in ants=50, taut=false or speed=45km/h"
            raise InputError("--set", f"{pair!r} is not key=value, with the value as in TOML", remedy)
        settings |= one
    return settings


def _check_output(file: str, scenario: Scenario) -> None:
    """Whether a path on `scenario` can be written to `file`: better known before the search than after it."""
    import numpy as np

    from planners import files
    from planners.path import Path

    files.check(Path(np.array([[0.0, 0.0], [1.0, 0.0]]), scenario.map.frame), file)
