"""Two campaigns side by side as Markdown, for a pull request."""

from __future__ import annotations

from campaigns.side_by_side import SideBySide
from reports.files.markdown import cell, row
from reports.words.compare_words import case_lines, conclusion, footnote, heads, names, rest_words, rows, telling


def side_by_side_markdown(found: SideBySide) -> str:
    """The answer first, then what was changed, then a table of each pair of cases that differs."""
    lines = ["### trackworthy compare", "", f"**{cell(conclusion(found))}**", ""]
    lines += [f"- {cell(line)}" for line in heads(found)]
    differ, alike = telling(found)
    for pair in differ:
        lines += ["", f"#### {cell(pair.name)}", "", cell("; ".join(case_lines(pair, found))), ""]
        told = list(rows(pair))
        if told:
            lines += [
                "| metric | A | B | B − A | 95 % interval | | |",
                "| --- | ---: | ---: | ---: | ---: | --- | --- |",
            ]
            lines += [row(one) for one in told]
        if rest := rest_words(pair):
            lines += ["", cell(rest)]
    if alike:
        lines += ["", f"The same: {cell(names(tuple(pair.name for pair in alike)))}"]
    return "\n".join([*lines, "", cell(footnote(found))]).rstrip() + "\n"
