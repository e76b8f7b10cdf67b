"""What is told and drawn of fleets."""

import dataclasses
import io
import json
import math
import re

import numpy as np
import pytest
from PIL import Image
from rich.console import Console

from planners.errors import TrackworthyError
from reports.figures.fleet_figure import fleet_figure, save_fleet_figure
from reports.figures.fleet_map import closest_places, member_colours
from reports.figures.focus import focus
from reports.figures.separation_panel import closest_pairs
from reports.figures.style import MEMBERS, style
from reports.figures.track_figure import track_figure
from reports.files.json_result import to_json
from reports.pages.pdf_case import case_data
from reports.terminal.table import print_outcome
from reports.words.fleet_words import called, member_name
from reports.words.quantity import text
from reports.words.rows import rows
from reports.words.words import reason, setting
from small_reports import pdf_of
from tracking.fleet import fleet_outcome


def drawn(figure):
    return "\n".join(text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text")))


@pytest.fixture(scope="module")
def meeting(plane):
    """Two planes that meet in the middle, and fly well."""
    members = [plane([(0, 0), (8000, 8000)]), plane([(0, 8000), (8000, 0)])]
    return fleet_outcome("meeting", members, "together", 500.0, ())


def test_places_name_the_aircraft_and_the_remedy_is_told(fleet):
    assert setting(fleet) == "fleet of 3 c172x · lqr · 55 m/s · no wind"
    told = reason(fleet)
    assert re.match(r"cross-track error \d+ m > 30 m at [\d.]+ km of aircraft 3: the turn there, ", told)
    least, remedy = fleet.metrics["separation_min"], fleet.fleet.remedy
    close = f"aircraft 1 and 2 come within {text(least.value, 'm')} at {least.t:.0f} s; "
    assert close + f"leaving {remedy[0]:.0f}, 0 and 0 s later they would keep 1 km" in told


def test_where_separation_decides_the_pair_is_named_once(meeting):
    told, least = reason(meeting), meeting.metrics["separation_min"]
    assert told.startswith(
        f"separation {text(least.value, 'm')} < 500 m, aircraft 1 and 2 at {least.t:.0f} s; leaving "
    )
    assert told.endswith(" s later they would keep 500 m")
    assert told.count("aircraft") == 1


def test_departures_that_keep_apart_are_told_and_need_no_remedy(apart_fleet):
    late = max(apart_fleet.fleet.departures)
    assert late > 0.0
    assert f"departures at {late:.0f}, 0 and 0 s" in setting(apart_fleet)
    assert "come within" not in reason(apart_fleet)


def test_what_is_closest_to_a_limit_names_its_aircraft(plane):
    members = [plane([(0, 0), (8000, 0)]), plane([(0, 4000), (8000, 4000)])]
    told = reason(fleet_outcome("calm", members, "together", 3900.0, ()))
    assert told == "every requirement met; closest: separation 4 km of at least 3.9 km, aircraft 1 and 2"


def test_ground_vehicles_are_vehicles():
    assert called("1 and 3", "ground") == "vehicles 1 and 3"
    assert called("2", "ground") == "vehicle 2"
    assert called("1 and 3", "fixed-wing") == "aircraft 1 and 3"
    assert called("", "ground") == ""


def test_members_that_end_early_are_named(fleet):
    one, two, three = fleet.fleet.members
    lost = dataclasses.replace(two, track=dataclasses.replace(two.track, ended="stall"))
    told = dataclasses.replace(fleet, fleet=dataclasses.replace(fleet.fleet, members=(one, lost, three)))
    assert "aircraft 2 ended early: stall" in reason(told)


def test_the_worst_point_is_that_of_the_member_that_decides(fleet, apart_fleet, meeting):
    own = fleet.fleet.members[2].metrics["cross_track_max"]
    assert focus(fleet).s == own.s
    place, both = focus(meeting), closest_places(meeting, meeting.fleet)
    assert math.dist((place.x, place.y), both[0]) < 55.0  # [m] flown in the second that a sample may be off
    late = fleet_outcome("late", apart_fleet.fleet.members[:2], "separated", 1000.0, ["separation_min >= 5000"])
    assert max(late.fleet.departures) > 0.0
    place, both = focus(late), closest_places(late, late.fleet)
    assert math.dist((place.x, place.y), both[late.fleet.member]) < 55.0


def test_the_closest_approach_is_drawn_where_both_were(fleet, apart_fleet):
    for outcome in (fleet, apart_fleet):
        both = closest_places(outcome, outcome.fleet)
        assert math.dist(*both) == pytest.approx(outcome.metrics["separation_min"].value, abs=0.5)
        with style():
            lines = fleet_figure(outcome).axes[0].lines
        assert any(np.array_equal(line.get_xydata(), both) for line in lines)


def test_json_tells_every_member(fleet):
    told = to_json(fleet)
    assert json.loads(json.dumps(told, allow_nan=False)) == told
    own = told["fleet"]
    assert (own["decided_by"], own["departures"], own["separation_required"]) == (3, [0.0, 0.0, 0.0], 1000.0)
    assert [one["pair"] for one in own["separation"]] == [[1, 2], [1, 3], [2, 3]]
    assert own["separation"][0]["min"] == fleet.metrics["separation_min"].value
    assert own["remedy"] == list(fleet.fleet.remedy)
    assert [member["verdict"] for member in own["members"]] == ["trackworthy", "trackworthy", "not-trackworthy"]
    assert told["metrics"]["separation_min"]["who"] == "1 and 2"
    assert to_json(fleet.fleet.members[0])["fleet"] is None


def test_tables_say_whose_it_was(fleet, route):
    (row,) = (row for row in rows(fleet) if row.name == "cross_track_max")
    assert row.who == "3"
    page = io.StringIO()
    print_outcome(fleet, Console(width=120, file=page))
    assert re.search(r"separation_min .* 1 and 2\n", page.getvalue())
    told = case_data(fleet, "a.svg", "b.svg", "")
    at = {row["name"]: row["at"] or row["when"] for row in told["requirements"]}
    assert re.fullmatch(r"[\d.]+ km, aircraft 3", at["cross_track_max"])
    assert re.fullmatch(r"\d+ s, aircraft 1 and 2", at["separation_min"])
    assert [one["trackworthy"] for one in told["members"]] == [True, True, False]
    assert told["path"] == "paths 11.3 km, 11.3 km and 5.41 km"
    assert case_data(route, "a.svg", "", "")["members"] == []


def test_the_figure_is_the_same_bytes_and_says_what_it_shows(apart_fleet, tmp_path):
    for file in ("a.png", "b.png"):
        save_fleet_figure(apart_fleet, tmp_path / file)
    with Image.open(tmp_path / "a.png") as image:
        assert image.width == 1600
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    with style():
        told = drawn(fleet_figure(apart_fleet, trial="worst of 3: trial 2"))
    for part in ("NOT TRACKWORTHY", "worst of 3: trial 2", "Separation [km]", "≥ 1 km", "1–2", "closest approach",
                 "aircraft 3: max 271 m", "departures at", "Cross-track error [m]"):  # fmt: skip
        assert part in told


def test_every_separation_is_drawn_in_both_colours(fleet):
    with style():
        panel = fleet_figure(fleet).axes[-1]
    assert panel.get_title("left") == "Separation [km]"
    for (i, j), distance in zip(fleet.fleet.apart.pairs, fleet.fleet.apart.distances.T, strict=True):
        found = [line for line in panel.lines if np.nanmin(line.get_ydata()) == pytest.approx(np.nanmin(distance))]
        assert {MEMBERS[i], MEMBERS[j]} <= {line.get_color() for line in found}


@pytest.mark.parametrize("page", [False, True])
def test_nothing_runs_out_of_the_figure_or_into_its_neighbour(fleet, apart_fleet, meeting, page):
    for outcome in (fleet, apart_fleet, meeting):
        with style():
            figure = fleet_figure(outcome, page)
            inside = figure.get_tightbbox()
            assert inside.x0 >= 0.0
            assert inside.y0 >= 0.0
            assert inside.x1 <= figure.get_size_inches()[0]
            assert inside.y1 <= figure.get_size_inches()[1]
            first = figure.axes[1]
            assert first._right_title.get_window_extent().x0 > first._left_title.get_window_extent().x1
            panel = figure.axes[-1]
            assert panel.get_legend().get_window_extent().x0 > panel._left_title.get_window_extent().x1


def test_many_vehicles_and_those_that_never_meet(plane):
    members = [plane([(0, 1000.0 * i), (6000, 1000.0 * i + 300.0)]) for i in range(7)]
    many = fleet_outcome("many", members, "together", 0.0, ())
    with style():
        figure = fleet_figure(many)
    assert sum(axes._right_title.get_text().startswith("aircraft") for axes in figure.axes) == 4
    assert len(closest_pairs(many.fleet, 6)) == 6
    assert member_colours(7)[5:] == list(MEMBERS[:2])
    late = dataclasses.replace(many.fleet, departures=tuple(1000.0 * i for i in range(7)))
    assert closest_pairs(late, 0) == []


def test_a_vehicle_alone_is_no_fleet(route):
    with pytest.raises(TrackworthyError, match="it is no fleet"):
        fleet_figure(route)


def test_the_own_figure_says_which_it_is(fleet):
    assert member_name(fleet) == "aircraft 3 of 3"
    with style():
        assert "aircraft 3 of 3 · fleet of 3 c172x" in drawn(track_figure(fleet))
        assert not any(axes.get_xlabel() == "east [km]" for axes in track_figure(fleet, page=True).axes)


def test_a_fleet_is_one_page(fleet, apart_fleet, tmp_path):
    command = ["trackworthy run campaign.toml --case one --trial 1"]
    for name in ("a.pdf", "b.pdf"):
        pdf_of([fleet, apart_fleet], tmp_path / name, "Fleets", commands=command * 2)
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    assert len(re.findall(rb"/Type\s*/Page\b", (tmp_path / "a.pdf").read_bytes())) == 3


def test_the_remedy_keeps_what_it_says(fleet, apart_fleet):
    assert apart_fleet.fleet.departures == fleet.fleet.remedy
    assert apart_fleet.metrics["separation_min"].value >= 1000.0
