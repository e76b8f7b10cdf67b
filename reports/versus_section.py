"""Controller against controller and planner against planner, as a report shows it: tables with their figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from campaigns.limits import Limit
from campaigns.summary import CaseResult
from campaigns.versus import Group, versus_groups
from reports.dimensions import scales
from reports.drawing import Drawing
from reports.names import listed
from reports.scenario_data import scenario_of
from reports.slug import slug
from reports.versus_figure import head_of, versus_figure
from reports.versus_layout import columns, pages
from reports.versus_words import Family, Table, families, outcome_cell, share_text, versus_table


def versus_section(
    results: Sequence[CaseResult], limits: Mapping[str, Limit]
) -> tuple[dict[str, list[Table]], list[Drawing]]:
    """What is told of the cases that differ in one thing only, by the name of their scenario, and its figures.

    Of each family the first table has "title", "head" and "rows" (lists of str), "note", and with all metrics "blocks";
    "file" and "caption" are those of a figure, further ones in tables of their own. `limits` are what the campaign's
    own gate allows. Both are empty where there are no such cases.
    """
    sizes = scales([result.case for result in results])
    found: dict[str, list[Table]] = {}
    drawings: list[Drawing] = []
    for number, family in enumerate(families(versus_groups(results, limits)), start=1):
        own = [
            Drawing(f"versus-{number}-{i}-{slug(family.title)}", versus_figure, (part,), caption(part), head_of(part))
            for i, part in enumerate(pages(family), start=1)
        ]
        figures = [{"file": one.svg, "caption": one.caption} for one in own]
        scenario = scenario_of(family.groups[0].members[0].result, sizes)
        found.setdefault(scenario, []).extend([{**versus_table(family), **_rows(family), **figures[0]}, *figures[1:]])
        drawings += own
    return found, drawings


def caption(family: Family) -> str:
    """What the figure shows."""
    return f"{family.title}: {family.about}."


def _rows(family: Family) -> Table:
    """The table of a page, which has room for the metrics of the figure."""
    shown = [one.metric for one in columns(family.groups)]
    named = any(family.names)
    head = [family.groups[0].dimension, *(["at"] if named else []), "trackworthy", *map(listed, shown)]
    rows = [
        row
        for group, name in zip(family.groups, family.names, strict=True)
        for row in _group_rows(group, [name] if named else [], shown)
    ]
    return {"head": head, "rows": rows}


def _group_rows(group: Group, name: list[str], shown: Sequence[str]) -> list[list[str]]:
    return [
        [
            f"{member.label}{' (reference)' if i == group.reference else ''}",
            *name,
            share_text(member.result),
            *(outcome_cell(member, metric) for metric in shown),
        ]
        for i, member in enumerate(group.members)
    ]
