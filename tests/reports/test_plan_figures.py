import dataclasses
import math

import numpy as np
import pytest
from PIL import Image

from planners.all_planners import make_planner
from planners.astar.settings import SpeedSettings, planned_speed
from planners.map import Map, Raster
from planners.path import Path
from planners.planner import NO_PATH, Plan
from planners.scenario import Scenario, load_scenario
from reports.figures.colony_figure import colony_figure, shown_iterations
from reports.figures.comparison_figure import comparison_figure
from reports.figures.needed_panel import stretches_beyond, worst_place
from reports.figures.plan_figure import plan_figure, save_plan_figure
from reports.figures.plan_turn import sharpest
from reports.figures.style import style
from sample_plans import CORNERS, UNIT, lost_plan, made_up_history, made_up_plan
from small_reports import save_figure


@pytest.fixture(scope="module")
def nofly():
    return load_scenario("nofly-1000x660")


def words(figure):
    return "\n".join(text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text")))


@pytest.fixture
def saved(tmp_path):
    """Saves a figure twice in each format: the same bytes, 1600 pixels wide and not empty."""

    def save(draw):
        for suffix in ("png", "svg"):
            first, second = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
            draw(first)
            draw(second)
            assert first.read_bytes() == second.read_bytes()
        with Image.open(tmp_path / "a.png") as image:
            assert image.width == 1600

    return save


def test_every_figure_is_the_same_bytes(nofly, yard, sharp_yard, saved):
    plan = made_up_plan(iterations=5, ants=10)
    saved(lambda file: save_plan_figure(nofly, {"improved": plan}, file))
    saved(lambda file: save_figure(colony_figure, nofly, plan.history, file=file))
    saved(lambda file: save_figure(comparison_figure, {"improved": plan.history}, 24e3, file=file))


def figures_of(nofly, plan):
    return (
        plan_figure(nofly, {"improved": plan}),
        plan_figure(nofly, {"basic": plan, "improved": plan}),
        comparison_figure({"improved": plan.history}, 24e3),
        colony_figure(nofly, plan.history),
    )


@pytest.mark.parametrize("plan", [made_up_plan(iterations=1, ants=1), made_up_plan(iterations=80, ants=3), lost_plan()])
def test_nothing_runs_out_of_a_figure(nofly, plan):
    with style():
        for figure in figures_of(nofly, plan):
            inside_and_apart(figure)


def inside_and_apart(figure):
    drawn = figure.get_tightbbox()
    assert drawn.x0 >= 0.0
    assert drawn.y0 >= 0.0
    assert drawn.x1 <= figure.get_size_inches()[0]
    assert drawn.y1 <= figure.get_size_inches()[1]
    for axes in figure.axes:
        if axes.get_legend():
            assert axes.get_legend().get_window_extent().x0 > axes._left_title.get_window_extent().x1
        if axes._right_title.get_text():
            assert axes._right_title.get_window_extent().x0 > axes._left_title.get_window_extent().x1


def test_a_plan_is_told_in_metres_map_units_and_against_the_exact_path(nofly):
    plan = made_up_plan()
    text = words(plan_figure(nofly, {"improved": plan}))
    length = plan.paths[0].length
    for part in (f"{length / UNIT:.2f} map units", "times the exact shortest path", "before smoothing", "east [km]",
                 "99.6° in all, smallest radius 400 m", "Length by iteration [km]", "Arrived [%]",
                 "iteration"):  # fmt: skip
        assert part in text


def test_a_yardstick_that_keeps_clear_says_so(nofly):
    assert "exact shortest, 100 m clear" in words(plan_figure(nofly, {"exact": made_up_plan()}, 100.0))


def test_where_nothing_was_found_the_figure_says_why(nofly):
    assert "not found: no ant arrived in 3 iterations" in words(plan_figure(nofly, {"basic": lost_plan()}))
    assert "nothing arrived" in words(comparison_figure({"basic": lost_plan().history}))
    none = Plan(outcome=NO_PATH, reason="the goal is walled in")
    assert "no path: the goal is walled in" in words(plan_figure(nofly, {"exact": none}))


def test_many_plans_in_one_figure(nofly):
    plan = made_up_plan(iterations=3, ants=3)
    text = words(plan_figure(nofly, {f"plan {i}": plan for i in range(7)}))
    assert "plan 6" in text
    assert text.count("tightest curve") == 3


def test_a_colony_is_told_by_iteration(nofly):
    history = made_up_history(iterations=30, ants=20)
    text = words(colony_figure(nofly, history, (3, 5)))
    assert "iteration 3" in text
    assert f"{history.survivors[2]} of 20 arrive, best 29.2 km, mean 38.8 km" in text


def test_the_iterations_shown():
    assert shown_iterations(1) == (1,)
    assert shown_iterations(3) == (1, 2, 3)
    assert shown_iterations(10) == (1, 2, 5, 10)
    assert shown_iterations(30) == (1, 3, 10, 30)
    assert shown_iterations(30, (1, 3, 5, 10)) == (1, 3, 5, 10)
    assert shown_iterations(4, (1, 3, 5, 10)) == (1, 3, 4)
    with pytest.raises(ValueError, match="nothing to show"):
        shown_iterations(0)


def test_the_sharpest_turn_of_corners_and_of_the_curves_that_replace_them():
    """A 99.6 deg corner at (909, 439) is the sharpest; curves of one radius are as sharp, so the longest one counts."""
    plan = made_up_plan(radius=400.0)
    a, b, c = (np.array(CORNERS[i]) for i in (8, 9, 10))
    turn = math.acos(np.dot(b - a, c - b) / np.linalg.norm(b - a) / np.linalg.norm(c - b))
    corner, angle = sharpest(Plan(paths=plan.polylines))
    assert corner == pytest.approx(b * UNIT)
    assert angle == pytest.approx(turn, rel=1e-6)
    middle, angle = sharpest(plan)
    cut = 400.0 * (1.0 / math.cos(turn / 2) - 1.0)
    assert math.dist(middle, b * UNIT) == pytest.approx(cut, abs=30.0)
    assert angle == pytest.approx(turn, rel=0.05)


@pytest.mark.parametrize("radius", [None, 1.0])
@pytest.mark.parametrize("points", [[(0, 0), (1, 0)], [(0, 0), (5, 0), (0, 1)], [(0, 0), (5, 0), (0, 0)]])
def test_the_sharpest_turn_of_short_paths(points, radius):
    place, angle = sharpest(Plan(paths=(Path(np.array(points, dtype=float)),), smallest_radius=radius))
    assert np.isfinite(place).all()
    assert 0.0 <= angle <= math.pi + 1e-9


def test_maps_of_any_shape(saved):
    path = Path(np.array([[10.0, 10.0], [60.0, 30.0], [90.0, 10.0]]))
    blocked = np.zeros((10, 10), bool)
    blocked[7:9, 3:7] = True
    area = Map(raster=Raster(blocked, 10.0))
    for size in ((100.0, 1000.0), (1000.0, 50.0)):
        places = {"starts": path.xy[:1], "goals": path.xy[-1:], "size": size}
        plan = dataclasses.replace(made_up_plan(iterations=2, ants=2), paths=(path,), polylines=(path,))
        saved(lambda file, places=places, plan=plan: save_plan_figure(
            Scenario(name="$odd", map=area, **places), {"a": plan}, file))  # fmt: skip


SPEED, STEP = 60 / 3.6, 60 / 3.6 * 0.5


@pytest.fixture(scope="module")
def square():
    return load_scenario("target-vehicle-71m")


def printed(turn_deg, run_up=20.0):
    """A plan that turns left by `turn_deg` at the end of three steps of 0.5 s at 60 km/h, between straights."""
    headings = np.radians(turn_deg) * np.array([0, 1, 2, 3])
    lengths = np.array([run_up, STEP, STEP, 20.0])
    legs = lengths[:, None] * np.column_stack([np.cos(headings), np.sin(headings)])
    return Plan(paths=(Path(np.cumsum(np.vstack([[5.0, 5.0], legs]), axis=0)),))


def test_a_turn_beyond_the_limit_is_one_stretch_around_its_corners():
    """18 deg a step need 1.07 g; the middle of the turn is beyond, and the way in and out by 0.6 of 1.07 of a step."""
    plan = printed(18.0)
    (piece,) = stretches_beyond(plan.paths[0], SPEED)
    ends = [plan.paths[0].project(*piece[i]).s for i in (0, -1)]
    needed = SPEED * math.radians(18.0) / 0.5 / 9.80665
    reach = STEP * (1.0 - 0.6 * 1.005 / needed)
    assert ends == pytest.approx([20.0 - reach, 20.0 + 2 * STEP + reach], abs=0.05)
    _, s, most = worst_place(plan, SPEED)
    assert most == pytest.approx(needed)
    assert 20.0 - 1e-9 <= s <= 20.0 + 2 * STEP + 1e-9


@pytest.mark.parametrize("turn_deg", [0.0, 10.1])
def test_a_turn_at_the_limit_is_not_beyond_it(turn_deg):
    """0.6 g allow 10.1 deg a step of 0.5 s at 60 km/h."""
    assert stretches_beyond(printed(turn_deg).paths[0], SPEED) == []


@pytest.mark.parametrize(("plan", "told"), [
    (printed(18.0), {"1.07 g", "needs more", "needs most"}),
    (printed(-10.0), {"0.593 g", "needs most"}),
    (printed(0.0), set()),
])  # fmt: skip
def test_a_plan_for_a_speed_says_what_it_needs(square, plan, told):
    limit = "needs up to 0.6 g of lateral acceleration at 60 km/h"
    with style():
        figure = plan_figure(square, {"a": plan}, speed=SPEED)
        inside_and_apart(figure)
        said = set(words(figure).splitlines())
        assert limit in said
        assert said & {"1.07 g", "0.593 g", "needs more", "needs most"} == told
        assert limit not in words(plan_figure(square, {"a": plan}))


def test_a_plan_for_a_speed_without_a_path_is_drawn(square):
    with style():
        assert "needs" not in words(plan_figure(square, {"a": lost_plan()}, speed=SPEED))


def test_a_planner_that_knows_its_speed_says_it():
    assert planned_speed(SpeedSettings(speed="60km/h")) == pytest.approx(SPEED)
    assert planned_speed(SpeedSettings()) == 12.5
    assert planned_speed(make_planner("exact")) is None
