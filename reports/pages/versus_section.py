"""Controller against controller and planner against planner, as a report shows it: tables with their figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from campaigns.limits import Limit
from campaigns.summary import CaseResult
from campaigns.versus import versus_groups
from reports.figures.drawing import Drawing
from reports.figures.versus_figure import head_of, versus_figure
from reports.figures.versus_layout import pages
from reports.words.slug import slug
from reports.words.versus_words import Table, families, versus_table


def versus_section(results: Sequence[CaseResult], limits: Mapping[str, Limit]) -> tuple[list[Table], list[Drawing]]:
    """What is told of the cases that differ in one thing only, and its figures, whose files are in "figures" of each
    table. `limits` are the campaign's own for its gate. Both are empty where there are no such cases.
    """
    tables: list[Table] = []
    drawings: list[Drawing] = []
    for number, family in enumerate(families(versus_groups(results, limits)), start=1):
        parts = pages(family)
        own = [
            Drawing(f"versus-{number}-{i}-{slug(family.title)}", versus_figure, (part,), family.title, head_of(part))
            for i, part in enumerate(parts, start=1)
        ]
        tables.append({**versus_table(family), "figures": [one.svg for one in own]})
        drawings += own
    return tables, drawings
