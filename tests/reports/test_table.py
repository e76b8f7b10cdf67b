import dataclasses
import io

import pytest
from rich.console import Console

from reports.table import print_outcome
from reports.words import sentence


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
    named = dataclasses.replace(yard, name="[bold]a[/]", notes=("[red]n[/red]",))
    assert "[bold]a[/]" in printed(named)
    assert "note: [red]n[/red]" in printed(named)
