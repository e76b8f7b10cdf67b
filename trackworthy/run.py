"""`trackworthy run`: a campaign, its report, and an exit code."""

from __future__ import annotations

import argparse
import json
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from campaigns.campaign import Campaign
    from campaigns.runner import Result


def add_parser(commands: Any) -> None:
    """Declare the command's arguments."""
    parser = commands.add_parser(
        "run", help="run a campaign and write its report", description="Run a campaign and write its report."
    )
    parser.set_defaults(main=main)
    add = parser.add_argument
    add("campaign", nargs="?", default="quickstart", metavar="CAMPAIGN", help="a TOML file or a built-in name")
    add("--case", action="append", default=[], metavar="NAME", help="run this case only; repeatable")
    add("-o", "--output", metavar="DIR", help="folder of the results (default: runs/ and the campaign's name)")


def main(args: argparse.Namespace) -> int:
    """Run every case, write the report, and answer with the exit code."""
    from campaigns.campaign import load_campaign
    from campaigns.runner import prepare_cases, run_cases
    from reports.progress import watched
    from reports.slug import slug
    from trackworthy.streams import chatter_to_stderr, tell

    campaign = load_campaign(args.campaign, args.case)
    name = "-".join([slug(campaign.name), *map(slug, args.case)])
    folder = Path(args.output or Path("runs") / name)
    trials = prepare_cases(campaign)
    tell(dict.fromkeys(note for trial in trials for note in trial.notes))
    folder.mkdir(parents=True, exist_ok=True)
    with chatter_to_stderr():
        results = list(watched(run_cases(campaign, trials), len(trials)))
    _write(campaign, results, folder, args.campaign)
    return _answer(results, folder)


def _write(campaign: Campaign, results: list[Result], folder: Path, called: str) -> None:
    """The report, its figures, and what they show as JSON."""
    from reports.files import atomic
    from reports.json_result import to_json
    from reports.pdf import write_pdf
    from reports.slug import slug
    from reports.track_figure import save_track_figure

    outcomes = [result.outcome for result in results if result.outcome]
    errors = {result.case.name: result.error for result in results if not result.outcome}
    (folder / "figures").mkdir(exist_ok=True)
    for number, outcome in enumerate(outcomes, start=1):
        save_track_figure(outcome, folder / "figures" / f"{number}-{slug(outcome.name)}.png")
    summary = {"cases": [to_json(outcome) for outcome in outcomes], "errors": errors}
    with atomic(folder / "summary.json") as temporary:
        temporary.write_text(json.dumps(summary, indent=2) + "\n")
    commands = [shlex.join(["trackworthy", "run", called, "--case", outcome.name]) for outcome in outcomes]
    write_pdf(outcomes, folder / "report.pdf", campaign.title, commands=commands, errors=errors)


def _answer(results: list[Result], folder: Path) -> int:
    """A line a case, and the exit code."""
    from planners.errors import TrackworthyError
    from reports.words import sentence

    for result in results:
        mark = "error" if not result.outcome else "pass " if result.outcome.verdict.passed else "FAIL "
        print(f"{mark} {result.case.name}: {sentence(result.outcome) if result.outcome else result.error}")
    passed = sum(result.outcome is not None and result.outcome.verdict.passed for result in results)
    failed = sum(result.outcome is None for result in results)
    failures = f", {failed} failed to run" if failed else ""
    print(f"{passed} of {len(results)} cases as expected{failures}; report: {folder / 'report.pdf'}")
    if failed:
        return TrackworthyError.exit_code
    return 0 if passed == len(results) else 1
