import dataclasses
import io

import pytest
from rich.console import Console

from reports.terminal.table import print_outcome
from reports.words.words import sentence
from tracking.feasibility import Feasibility, Turn


def printed(outcome, width=80, **console):
    file = io.StringIO()
    print_outcome(outcome, Console(file=file, width=width, highlight=False, **console))
    return file.getvalue()


def test_ends_with_the_sentence(route):
    assert printed(route).splitlines()[-1] == sentence(route)


@pytest.mark.parametrize("name", ["route", "yard", "sharp_yard"])
def test_fits_80_columns_and_cuts_nothing(name, request):
    outcome = request.getfixturevalue(name)
    lines = printed(outcome).splitlines()
    body = lines[: lines.index("")] if "" in lines else lines
    assert max(map(len, body)) <= 80
    assert "…" not in "\n".join(lines)
    for metric in outcome.metrics:
        assert metric in "\n".join(lines)


def test_requirements_come_first(route):
    text = printed(route)
    assert text.index("cross_track_max") < text.index("path following") < text.index("cross_track_rms")


def test_a_miss_is_marked_without_colour(route):
    text = printed(route)
    assert "✗ cross_track_max" in text
    assert "✓ completion" in text
    assert "\x1b" not in text


def test_a_terminal_has_colour(route):
    assert "\x1b" in printed(route, force_terminal=True, color_system="standard")


def test_what_is_not_valid_says_why(yard):
    assert "n/a: altitude_error_max: the path has no heights" in printed(yard)


def test_markup_in_names_is_text(yard):
    named = dataclasses.replace(yard, name="[bold]a[/]")
    assert "[bold]a[/]" in printed(named)


def with_turns(outcome, count):
    """`outcome` with `count` stretches of two turns each, whose arcs overlap, the later the tighter."""
    turns = []
    for i in range(count):
        turns += [Turn(100.0 * i + add, 0, 0, 0.1, 90.0 - i, 530.0) for add in (0.0, 40.0)]
        turns.append(Turn(100.0 * i + 50.0, 0, 0, 0.1, 900.0, 530.0))
    return dataclasses.replace(outcome, feasibility=Feasibility(tuple(turns), ()))


def test_infeasible_stretches_are_listed(route):
    lines = [line.rstrip() for line in printed(with_turns(route, 2)).splitlines()]
    start = lines.index("turns too tight for the vehicle: 2")
    assert lines[start + 1].split() == ["where", "turn", "needs", "radius", "offers", "missing"]
    first, second = (line.split() for line in lines[start + 3 : start + 5])
    assert first == ["0", "–", "40", "m", "11.5°", "left", "530", "m", "90", "m", "440", "m"]
    assert second[-6:] == ["530", "m", "89", "m", "441", "m"]
    assert lines[start + 5] == ""
    assert max(map(len, lines[start : start + 5])) <= 80


def test_no_more_than_the_worst_stretches_are_listed(route):
    text = printed(with_turns(route, 20))
    assert "and 12 more" in text
    assert text.count("11.5° left") == 8
    assert "1200 – 1240" not in text
    assert "71 m" in text


def test_nothing_infeasible_is_not_mentioned(yard):
    assert "too" not in printed(dataclasses.replace(yard, feasibility=Feasibility((), ())))


def test_steep_legs_are_listed(route, steep_leg):
    assert "legs too steep for the vehicle: 1" in printed(
        dataclasses.replace(route, feasibility=Feasibility((), (steep_leg,)))
    )
