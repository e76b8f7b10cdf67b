"""What goes where: results on standard output, everything else on standard error."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager


def tell(notes: Iterable[str]) -> None:
    """Each note as a line on standard error."""
    for note in notes:
        print(note, file=sys.stderr)


@contextmanager
def chatter_to_stderr() -> Iterator[None]:
    """Send what simulators print on standard output, from C++ too, to standard error instead."""
    sys.stdout.flush()
    kept = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
