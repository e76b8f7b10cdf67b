"""`trackworthy`, also as `python -m trackworthy`: arguments in, exit code out."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import traceback
from collections.abc import Sequence
from typing import NoReturn

# A process works on one trial: threads of the linear algebra library only wait, and burn time doing so
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from planners.errors import InputError, TrackworthyError
from trackworthy import __version__, check, compare, convert, listing, plan, report, run, segment, track

DESCRIPTION = "Flies and drives planned paths in simulation, and says whether a real vehicle can follow them."
EPILOG = """exit codes:
  0  trackworthy, or as expected; a path was planned
  1  not trackworthy, or a regression; no path was found
  2  bad usage or bad input
  3  the machinery failed"""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.exit(InputError.exit_code, f"{self.prog}: {message}; see {self.prog} --help\n")


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = _Parser(
        "trackworthy", description=DESCRIPTION, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    top.add_argument("--version", action="version", version=f"trackworthy {__version__}")
    commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for command in (run, report, check, compare, track, plan, segment, convert, listing):
        command.add_parser(commands)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; expected failures are one line on standard error, surprises a traceback and exit code 3."""
    args = parser().parse_args(arguments)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that temporary files go when we are told to
    try:
        code: int = args.main(args)
    except TrackworthyError as error:
        print(f"trackworthy: {error}", file=sys.stderr)
        return error.exit_code
    except KeyboardInterrupt:
        print("trackworthy: stopped", file=sys.stderr)
        return 130
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return TrackworthyError.exit_code
    except OSError as error:
        print(f"trackworthy: {error.filename or 'the system'}: {error.strerror or error}", file=sys.stderr)
        return TrackworthyError.exit_code
    except Exception:
        traceback.print_exc()
        print("trackworthy: this is a fault of trackworthy itself; please report it", file=sys.stderr)
        return TrackworthyError.exit_code
    return code


if __name__ == "__main__":
    sys.exit(main())
