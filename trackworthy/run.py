"""`trackworthy run`: a campaign, its report, and an exit code."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from campaigns.campaign import Campaign
    from campaigns.finished import Finished
    from campaigns.ready import ReadyCase
    from campaigns.search import Search
    from campaigns.search_ready import ReadySearch


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "run", help="run or resume a campaign and write its report", description="Run or resume a campaign."
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add(
        "campaign",
        nargs="?",
        default="papers",
        metavar="CAMPAIGN",
        help="a TOML file or a built-in name; default papers",
    )
    add("--full", action="store_true", help="the long form of papers: three campaigns in one")
    add("--case", action="append", default=[], metavar="NAME", help="run this case only; repeatable")
    add("--trial", type=int, metavar="N", help="replay just this trial of the one --case, and show it whole")
    add("-o", "--output", metavar="DIR", help="folder of the results (default: runs/ and the campaign's name)")
    add("-j", "--jobs", type=int, metavar="N", help="processes to run trials in (default: one a processor)")
    add("--dask", metavar="ADDRESS", help="run trials on this dask scheduler, as tcp://host:8786")
    add("--fresh", action="store_true", help="start anew where DIR has results already")
    add("--dry-run", action="store_true", help="show the cases and the number of trials, and stop")


def main(args: argparse.Namespace) -> int:
    """Run what is missing, write the report, and answer with the exit code."""
    from campaigns.execute import Machines, default_jobs, execute
    from campaigns.full import find_campaign
    from campaigns.ready import make_ready
    from campaigns.search_ready import make_searches_ready
    from planners.errors import InputError
    from reports.terminal.progress import watched
    from reports.words.slug import slug
    from reports.write import DRAWING, write_report
    from trackworthy.streams import tell

    if args.jobs is not None and args.jobs < 1:
        raise InputError("--jobs", f"{args.jobs} is no number of processes", "give 1 or more")
    campaign = find_campaign(args.campaign, args.case, args.full)
    cases, searches = make_ready(campaign), make_searches_ready(campaign)
    tell(dict.fromkeys(note for ready in cases for note in ready.notes))
    name = "-".join([slug(campaign.name), *map(slug, args.case)])
    folder = Path(args.output or Path("runs") / name)
    if args.dry_run:
        return _show(campaign, cases)
    if args.trial is not None:
        from trackworthy.replay import replay_trial

        return replay_trial(campaign, cases, args.trial, folder)
    machines = Machines(args.jobs or default_jobs(), args.dask)
    tell(_ahead(cases, searches, folder, args.fresh))
    try:
        finished = execute(campaign, cases, folder, machines, watched, args.fresh, searches)
    except (KeyboardInterrupt, SystemExit) as stop:  # Ctrl-C, or told to by SIGTERM
        tell([f"trackworthy: stopped; the same command goes on from what is stored in {folder}"])
        return int(stop.code or 0) if isinstance(stop, SystemExit) else 130
    with Machines(machines.jobs).lanes(DRAWING) as lanes:
        write_report(finished, lanes)
    return _answer(finished, folder)


def _ahead(cases: Sequence[ReadyCase], searches: Sequence[ReadySearch], folder: Path, fresh: bool) -> list[str]:
    """What is to be done besides the trials, whose progress is shown."""
    from collections import Counter

    from reports.words.quantity import counted

    paths = {plan.key for ready in cases for plan in ready.plans if fresh or not plan.done(folder)}
    said = [f"making {counted(len(paths), 'plan')}"] if paths else []
    kinds = Counter(one.search.BLOCK.replace("_", " ") for one in searches)
    return [*said, *(f"searching {counted(count, kind)}" for kind, count in kinds.items())]


def _show(campaign: Campaign, cases: tuple[ReadyCase, ...]) -> int:
    """Every case with its number of trials, and every search."""
    from planners.outside import OutsidePlanner
    from reports.words.quantity import counted

    names = [*(ready.case.name for ready in cases), *(search.name for search in campaign.searches)]
    width = max(map(len, names))
    for ready in cases:
        case, planner = ready.case, ready.case.planner
        by = planner.label if isinstance(planner, OutsidePlanner) else planner
        path = case.path or f"planned by {by} on {case.scenario}"
        what = f"{path}, {case.vehicle}, {case.controller}, {case.speed:.4g} m/s"
        print(f"{case.name:<{width}}  {case.trials:>6}  {what}")
    for search in campaign.searches:
        print(f"{search.name:<{width}}          {_asked(search)}")
    print(f"{counted(len(cases), 'case')}, {counted(campaign.trials, 'trial')}")
    return 0


def _asked(search: Search) -> str:
    """What a search is for, and within which range."""
    from campaigns.search import ScaleSearch

    low, high = (f"{end:g}" if isinstance(end, float) else end for end in search.between)
    followed = f"{search.vehicle}, {search.controller}"
    if isinstance(search, ScaleSearch):
        return f"smallest scale of {search.scenario}, {search.planner}, {followed}, {low} to {high} m"
    path = search.path or f"{search.planner} on {search.scenario}"
    return f"top speed of {path}, {followed}, {low} to {high}"


def _answer(finished: Finished, folder: Path) -> int:
    """A line a case and a search, and the exit code."""
    from campaigns.attempt import INPUT
    from planners.errors import InputError, TrackworthyError
    from reports.words.campaign_words import case_line
    from reports.words.quantity import counted
    from reports.words.search_words import search_line

    results, searches = finished.results, finished.searches
    for result in results:
        print(case_line(result, finished.outcomes.get(result.case.name)))
    for search in searches:
        print(search_line(search))
    passed = sum(result.passed for result in results)
    asked = [search.passed for search in searches if search.passed is not None]
    kinds = [result.statistics.kinds for result in results if result.statistics.errors]
    kinds += [frozenset({search.found.kind}) for search in searches if search.found.error]
    tried = [f"{passed} of {counted(len(results), 'case')}"] if results else []
    tried += [f"{sum(asked)} of {len(asked)} searches"] if asked else []
    failures = f", {len(kinds)} failed to run" if kinds else ""
    told = (
        f"{' and '.join(tried)} as expected"
        if tried
        else f"{len(searches)} search{'' if len(searches) == 1 else 'es'} made"
    )
    print(f"{told}{failures}; report: {folder / 'report.pdf'}, {folder / 'report.html'}")
    if kinds:
        only_input = frozenset[str]().union(*kinds) == {INPUT}
        return InputError.exit_code if only_input else TrackworthyError.exit_code
    return 0 if passed == len(results) and all(asked) else 1
