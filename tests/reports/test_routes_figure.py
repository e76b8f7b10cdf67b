import numpy as np
import pytest

from campaigns.claims import Beside, Claim
from campaigns.plan_statistics import PlannedBy, PlanStatistics
from planners.all_planners import make_planner, plan_with
from reports.figures.plan_figure import plan_figure
from reports.figures.plan_turn import came
from reports.figures.routes_figure import COLUMNS, ROWS, Route, routes_figure
from reports.figures.style import VERMILION, style
from reports.words.quantity import text
from sample_maps import box, scenario
from small_reports import drawings_of, save_figure, sections_of

WALL = scenario(polygons=[box(55.0, 20.0, 4.0, 40.0)], unit=1.0)
SPEEDS = (30.0, 45.0, 60.0)  # [km/h]
NOTHING = PlanStatistics(seeds=1, found=1, missing={})


def printed(kmh):
    return make_planner("astar-arc-paper", {"speed": f"{kmh:g}km/h"})


@pytest.fixture(scope="module")
def rows():
    grid = plan_with(make_planner("astar-four", {}), WALL, 0)
    stuck = [Route(f"printed, {kmh:g} km/h", plan_with(printed(kmh), WALL, 0), kmh / 3.6) for kmh in SPEEDS]
    return [[Route("astar-four, 30 km/h", grid, 30.0 / 3.6)], stuck]


def words(figure):
    return "\n".join(artist.get_text() for artist in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def crosses(axes):
    return [line for line in axes.lines if line.get_marker() == "X"]


def test_routes_at_one_scale_with_what_they_need_and_where_they_ended(rows):
    with style():
        figure = routes_figure(WALL, rows)
        drawn = figure.get_tightbbox()
    assert len(figure.axes) == 4
    assert len({(axes.get_xlim(), axes.get_ylim(), *np.round(axes.bbox.size, 6)) for axes in figure.axes}) == 1
    assert f"{text(rows[0][0].plan.paths[0].length, 'm', 4)}, 2.67 g" in words(figure)
    for route, axes in zip(rows[1], figure.axes[1:], strict=True):
        end = came(route.plan)[0].xy[-1]
        assert f"not found, {text(np.hypot(*(end - WALL.goals[0])), 'm')} from the goal" in words(axes)
        (cross,) = crosses(axes)
        assert cross.get_xydata()[0] == pytest.approx(end)
    assert not crosses(figure.axes[0])
    assert VERMILION in {line.get_color() for line in figure.axes[0].lines}
    assert min(drawn.x0, drawn.y0) >= 0.0
    assert drawn.x1 <= figure.get_size_inches()[0]
    assert drawn.y1 <= figure.get_size_inches()[1]
    titles = [axes._left_title.get_window_extent() for axes in figure.axes]
    boxes = [axes.get_window_extent() for axes in figure.axes]
    assert not any(title.overlaps(box) for title in titles for box in boxes)


def test_the_same_routes_give_the_same_bytes(rows, tmp_path):
    for file in ("a.png", "b.png"):
        save_figure(routes_figure, WALL, rows, file=tmp_path / file)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def by(planner, speed, claims=()):
    return PlannedBy(planner, WALL, 0, "case", NOTHING, claims, driven_at=speed)


def test_a_campaign_has_one_picture_of_its_routes():
    claims = [(Claim(planner="astar-four", source="paper", beside=Beside(plan=f"Fig. {i}")),) for i in (9, 10)]
    plans = {
        "printed, 45 km/h": by(printed(45.0), 12.5, claims[1]),
        "four": by(make_planner("astar-four", {}), 5.0, claims[0]),
    }
    _, routes = drawings_of(plans)
    assert routes.stem == "plans-routes"
    assert routes.caption.startswith("astar-four and astar-arc-paper: the routes")
    assert routes.caption.endswith("or the slowest at which it is driven. Beside Fig. 9; Fig. 10.")


def test_what_plans_need_is_explained_where_they_are_driven(monkeypatch):
    monkeypatch.setattr("reports.pages.pdf_plans.plan_drawings", lambda *given: [])
    told = (
        "Needs: lateral acceleration, red over 0.6 g; of what is claimed, that of an arc which turns so far in 0.5 s."
    )
    notes = [sections_of([by(printed(45.0), speed)], note="Note.")[0].note for speed in (12.5, None)]
    assert notes == [f"{told} Note.", "Note."]


def test_more_speeds_than_a_page_holds_go_on_the_next():
    speeds = np.linspace(30.0, 60.0, COLUMNS * ROWS + 1)
    plans = {f"{kmh:.4g} km/h": by(printed(kmh), kmh / 3.6) for kmh in speeds}
    pages = drawings_of(plans)[1:]
    assert [page.stem for page in pages] == ["plans-routes-1", "plans-routes-2"]
    assert [[len(row) for row in page.arguments[1]] for page in pages] == [[COLUMNS] * ROWS, [1]]


def test_aircraft_keep_a_picture_each():
    plans = {name: by(make_planner(name, {}), None) for name in ("astar-four", "exact")}
    names = [picture.stem for picture in drawings_of(plans)]
    assert names == ["plans-astar-four", "plans-exact"]


def test_the_picture_of_one_plan_says_why_there_is_none_within_its_width():
    plan = plan_with(printed(45.0), WALL, 0)
    with style():
        figure = plan_figure(WALL, {"astar-arc-paper": plan}, 0.0, 12.5)
        assert figure.get_tightbbox().x1 <= figure.get_size_inches()[0]
    assert f"not found: {plan.reason}" in words(figure).replace("\n", " ")
    assert len(crosses(figure.axes[0])) == 1
    assert "as far as it came" in words(figure)
