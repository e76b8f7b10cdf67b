"""`trackworthy run`: a campaign, its report, and an exit code."""

from __future__ import annotations

import argparse
import json
import sys
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
    add("-o", "--output", metavar="DIR", help="folder of the results (default: runs/ and the campaign's name)")


def main(args: argparse.Namespace) -> int:
    """Run every case, write the report, and answer with the exit code."""
    from campaigns.campaign import load_campaign
    from campaigns.runner import run_cases
    from reports.progress import watched
    from trackworthy.streams import chatter_to_stderr

    campaign = load_campaign(args.campaign)
    folder = Path(args.output or Path("runs") / campaign.name)
    folder.mkdir(parents=True, exist_ok=True)
    with chatter_to_stderr():
        results = list(watched(run_cases(campaign), len(campaign.cases)))
    return _report(campaign, results, folder)


def _report(campaign: Campaign, results: list[Result], folder: Path) -> int:
    from planners.errors import TrackworthyError
    from reports.files import atomic
    from reports.json_result import to_json
    from reports.pdf import write_pdf
    from reports.slug import slug
    from reports.track_figure import save_track_figure
    from reports.words import sentence

    outcomes = [result.outcome for result in results if result.outcome]
    failures = [result for result in results if result.error]
    (folder / "figures").mkdir(exist_ok=True)
    for outcome in outcomes:
        save_track_figure(outcome, folder / "figures" / f"{slug(outcome.name)}.png")
    with atomic(folder / "summary.json") as temporary:
        temporary.write_text(json.dumps([to_json(outcome) for outcome in outcomes], indent=2) + "\n")
    if outcomes:
        commands = [result.command for result in results if result.outcome]
        write_pdf(outcomes, folder / "report.pdf", campaign.title, commands=commands)
    for result in results:
        mark = "error" if not result.outcome else "pass " if result.outcome.verdict.passed else "FAIL "
        print(f"{mark} {result.case.name}: {sentence(result.outcome) if result.outcome else result.error}")
    passed = sum(outcome.verdict.passed for outcome in outcomes)
    print(f"{passed} of {len(results)} cases as expected; report: {folder / 'report.pdf'}")
    if failures:
        print(f"trackworthy: {len(failures)} cases failed to run", file=sys.stderr)
        return TrackworthyError.exit_code
    return 0 if passed == len(results) else 1
