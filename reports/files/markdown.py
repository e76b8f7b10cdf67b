"""Text that users gave, as Markdown shows it and does not obey it."""

from __future__ import annotations

import re
from collections.abc import Sequence


def cell(text: str) -> str:
    """Text as a cell of a table: no line breaks, no bars, no markup."""
    for character in "\\`*_<>|[]~":
        text = text.replace(character, f"\\{character}")
    text = re.sub(r"([@#])(?=\w)", "\\1\u2060", text)  # or a name would call somebody, a number another thread
    return " ".join(text.split())


def row(cells: Sequence[str]) -> str:
    """A row of a table."""
    return f"| {' | '.join(cell(one) for one in cells)} |"


def fenced(lines: Sequence[str]) -> list[str]:
    """Lines as they are, within a fence that none of them ends: longer than any run of backticks in them."""
    fence = "`" * max(3, 1 + max(map(len, re.findall("`+", "\n".join(lines))), default=0))
    return [fence, *lines, fence]
