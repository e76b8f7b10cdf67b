import math

import numpy as np
import pytest

from campaigns.claims import Beside, Claim
from campaigns.plan_statistics import PlannedBy, PlanStatistics
from planners.all_planners import make_planner
from planners.astar.arc_printed import children, descent_of
from reports.figures.sector_figure import most_cut, sector_figure
from reports.figures.style import style
from sample_maps import WALLED, box, scenario
from small_reports import drawings_of, drawn, save_figure

POST = scenario(circles=[(60.0, 41.3, 1.5)], goal=(105.0, 40.0), unit=1.0)
WALL = scenario(polygons=[box(55.0, 20.0, 4.0, 40.0)], unit=1.0)
PLANNERS = {f"{kmh} km/h": make_planner("astar-arc-paper", {"speed": f"{kmh}km/h"}) for kmh in (30, 45, 60)}


def words(figure):
    return "\n".join(text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def test_sectors_cut_and_with_the_goal_in_them_at_one_scale():
    with style():
        figure = sector_figure(POST, PLANNERS)
        drawn = figure.get_tightbbox()
    assert len(figure.axes) == 6
    assert len({round(np.ptp(limits), 9) for axes in figure.axes for limits in (axes.get_xlim(), axes.get_ylim())}) == 1
    told = words(figure)
    for part in ("30 km/h: 4.17 m, ±43.4°", "45 km/h: 6.25 m, ±19.3°", "60 km/h: 8.33 m, ±10.8°"):
        assert part in told
    for part in ("of 29 children free; 0.6 g: ±20.2°", "of 13 children free; 0.6 g: ±13.5°", "of 7 children free"):
        assert part in told
    assert told.count("the goal is in the sector") == 3
    assert min(drawn.x0, drawn.y0) >= 0.0
    assert drawn.x1 <= figure.get_size_inches()[0]
    assert drawn.y1 <= figure.get_size_inches()[1]


def test_where_the_search_ends_before_an_obstacle_it_says_so():
    assert words(sector_figure(WALL, PLANNERS)).count("no child is free and new: it ends here") == 3


def test_a_search_without_a_map_to_search_on_is_left_out():
    assert sector_figure(WALLED, {"none": PLANNERS["60 km/h"]}).axes == []


@pytest.mark.parametrize("planner", PLANNERS.values(), ids=PLANNERS)
def test_the_sector_shown_is_the_one_that_the_post_cuts(planner):
    found = descent_of(POST, planner)
    free = children(found, most_cut(found))[1]
    assert 0 < free.sum() < len(free)
    x, y = found.ground.to_metres(found.nodes)[most_cut(found)]
    assert math.dist((x, y), (60.0, 41.3)) < found.step + 1.5


def test_a_campaign_draws_the_sectors_of_its_planners(tmp_path):
    """Three of four speeds, beside the source's figure."""
    nothing = PlanStatistics(seeds=1, found=1, missing={})
    claim = Claim(planner="astar-arc-paper", source="paper", beside=Beside(sectors="Fig. 7"))
    four = {**PLANNERS, "20 km/h": make_planner("astar-arc-paper", {"speed": "20km/h"})}
    plans = {name: PlannedBy(planner, POST, 0, "case", nothing, (claim,)) for name, planner in four.items()}
    first = drawings_of(plans)[0]
    assert first.stem == "plans-sectors"
    assert first.caption.startswith("30 km/h, 45 km/h and 60 km/h: above")
    assert first.caption.endswith("Beside Fig. 7.")
    save_figure(sector_figure, POST, PLANNERS, file=tmp_path / "again.png")
    assert drawn([first], tmp_path / "figures")[0].read_bytes() == (tmp_path / "again.png").read_bytes()


def test_where_nothing_was_searched_there_is_no_picture_of_sectors():
    plans = {"none": PlannedBy(PLANNERS["60 km/h"], WALLED, 0, "case", PlanStatistics(seeds=1, found=0, missing={}))}
    assert [picture.stem for picture in drawings_of(plans)] == ["plans-none"]
